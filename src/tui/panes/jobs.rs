//! The jobs.

use ratatui::layout::Rect;

use super::interface::{Pane, PaneInfo, about};
use crate::command::{self, Command, CommandId, FILTER, LIST, main};
use crate::msg::Effect;
use crate::number;
use crate::pane::PaneId;
use crate::run::Progress;
use crate::state::{AppState, JobLine, JobPurpose, JobState};
use crate::update::jobs;
use crate::update::motion::{moved, step};
use crate::view::paint::span;
use crate::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::CancelJob, &["x", "d"], "cancel", "Cancel the job under the cursor"),
    FILTER,
    command::DOWN,
];

pub(super) struct JobsPane;

impl Pane for JobsPane {
    fn about(&self) -> PaneInfo {
        about("Jobs", "Go to the jobs", &[COMMANDS, LIST])
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let line = state.jobs.current();
        let state = line.map(|line| &line.state);
        if id == CommandId::CancelJob && matches!(state, Some(JobState::Elsewhere(_))) {
            return Some("This job is on another host; `seacable jobs cancel` does it there.");
        }
        let open = state.is_some_and(JobState::is_open);
        (id == CommandId::CancelJob && !open).then_some("There is no running job under the cursor.")
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        if id == CommandId::CancelJob {
            let ticket = state.jobs.current()?.ticket;
            return Some(jobs::cancel(state, ticket));
        }
        let by = step(state, id)?;
        state.jobs.cursor = moved(state.jobs.cursor, by, state.jobs.shown().len());
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let state = painter.state;
        let jobs = &state.jobs;
        if jobs.lines.is_empty() {
            painter.text(area, "No jobs yet.", painter.theme.faint());
            return;
        }
        let focused = state.focus() == PaneId::Jobs;
        let shown = jobs.shown();
        let area = painter.filter_line(area, &jobs.filter, (shown.len(), jobs.lines.len()));
        painter.list(area, jobs.cursor, shown.len(), |painter, at, i| {
            let line = shown[i];
            let style = painter.line_style(i == jobs.cursor && focused);
            painter.buf.set_style(at, style);
            let half = (area.width / 2).max(20);
            painter.text(span(at, 0, half.saturating_sub(1)), &job_name(line), style);
            painter.text(span(at, half, u16::MAX), &job_words(line), style);
        });
    }
}

/// What it computes, with the number by which the command line knows it.
fn job_name(line: &JobLine) -> String {
    let number = line.process.as_ref().and_then(|process| process.number);
    match number {
        Some(number) => format!("{number}: {}", line.name),
        None => line.name.clone(),
    }
}

fn job_words(line: &JobLine) -> String {
    let p = line.progress;
    match &line.state {
        JobState::Running if line.purpose == JobPurpose::Trials => {
            format!("{:.0} of {:.0} trials", p.time, p.duration)
        }
        JobState::Running if line.purpose == JobPurpose::Sweep => load_cases(p),
        JobState::Running if p.estimating => "estimating errors".to_owned(),
        JobState::Running if p.steps == 0 => p
            .search
            .map_or_else(|| "starting".to_owned(), |search| search.to_string()),
        JobState::Running => {
            let left = p.remaining_s();
            let left = left.map_or_else(String::new, |s| format!(", {} left", number::duration(s)));
            format!(
                "step {}, {:.0} of {:.0} s{left}",
                p.steps, p.time, p.duration
            )
        }
        JobState::Failed(why) => format!("failed: {why}"),
        JobState::Killed(words) => format!("killed; {words}"),
        JobState::Elsewhere(words) => words.clone(),
        other => other.word().to_owned(),
    }
}

/// How many load cases are done, and how long the others take.
pub(crate) fn load_cases(progress: Progress) -> String {
    if progress.steps == 0 && progress.duration <= 0.0 {
        return "reading the load cases".to_owned();
    }
    // Those that were stored before took no time.
    let of = progress.steps as f64 - progress.time + progress.duration;
    let left = progress.remaining_s();
    let left = left.map_or_else(String::new, |s| format!(", {} left", number::duration(s)));
    format!("{} of {of:.0} load cases{left}", progress.steps)
}
