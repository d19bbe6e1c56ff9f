//! The runs of a line case.

use ratatui::layout::Rect;
use ratatui::style::Style;

use super::{Pane, PaneInfo, about};
use crate::report::number;
use crate::run::settings::method_name;
use crate::tui::command::{self, Command, CommandId, LIST, main, other};
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::state::{
    AppState, JobState, LineView, Overlay, Question, RunEntry, RunOrigin, RunStatus,
};
use crate::tui::update::motion::{moved, step};
use crate::tui::update::{resume, runs};
use crate::tui::view::paint::{below_head, span};
use crate::tui::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::ShowAlone, &["enter"], "show", "Show this run alone on the charts, in the table and in the report"),
    main(CommandId::Select, &["space"], "overlay", "Add this run to the charts or take it off"),
    main(CommandId::Resume, &["c"], "resume", "Resume this stored run from its last checkpoint, up to a time that is asked for"),
    other(CommandId::SelectNone, &["a"], "live only", "Show the live run only"),
    other(CommandId::Delete, &["d"], "delete", "Delete this stored run (asks first)"),
    command::DOWN,
];

pub(super) struct RunsPane;

impl Pane for RunsPane {
    fn about(&self) -> PaneInfo {
        about("Runs", "Go to the runs", &[COMMANDS, LIST])
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let run = state.line()?.current_run();
        match id {
            CommandId::Delete => why_not_deleted(run),
            CommandId::Resume => why_not_resumed(run),
            _ => None,
        }
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let by = step(state, id);
        let line = state.line_mut()?;
        match id {
            CommandId::ShowAlone => return Some(runs::show_alone(state)),
            CommandId::Select => return Some(runs::select(line)),
            CommandId::Resume => return Some(resume::ask(state)),
            CommandId::SelectNone => {
                line.runs.iter_mut().for_each(|entry| entry.shown = false);
                line.live.hidden = false;
            }
            CommandId::Delete => {
                let entry = line.current_run()?;
                let (dir, id) = (entry.dir.clone()?, entry.id.clone());
                state.overlay = Some(Overlay::Ask(Question::DeleteRun { dir, id }));
            }
            _ => line.run = moved(line.run, by?, line.runs.len() + 1),
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let state = painter.state;
        let Some(line) = state.line() else {
            return;
        };
        let [head, list] = below_head(area);
        let strong = painter.theme.strong();
        columns(
            painter,
            head,
            ["    run", "state", "solver", "steps", "CPU"],
            strong,
        );
        let focused = state.focus() == PaneId::Runs;
        painter.list(list, line.run, line.runs.len() + 1, |painter, at, i| {
            let style = painter.line_style(i == line.run && focused);
            painter.buf.set_style(at, style);
            match i.checked_sub(1).and_then(|i| line.runs.get(i)) {
                None => live_line(painter, at, line, style),
                Some(entry) => run_line(painter, at, entry, style),
            }
        });
    }
}

fn why_not_resumed(run: Option<&RunEntry>) -> Option<&'static str> {
    let Some(run) = run else {
        return Some("The live run is in memory only; `R` makes one that can be resumed.");
    };
    match &run.state {
        RunStatus::Job(state) if state.is_open() => {
            Some("This run is still running; `ctrl+c` stops it.")
        }
        RunStatus::Elsewhere => Some("Another program is still computing this run."),
        RunStatus::Unreadable(_) => Some("This run cannot be read."),
        _ if run.dir.is_none() => Some("This run has no directory to resume from."),
        _ => None,
    }
}

fn why_not_deleted(run: Option<&RunEntry>) -> Option<&'static str> {
    let Some(run) = run else {
        return Some("The live run is in memory only; there is nothing to delete.");
    };
    match &run.state {
        RunStatus::Job(state) if state.is_open() => {
            Some("This run is still running; `ctrl+c` cancels it.")
        }
        RunStatus::Elsewhere => Some("Another program is still computing this run."),
        _ if run.kind == RunOrigin::Session && run.dir.is_none() => {
            Some("This run has no directory to delete.")
        }
        _ => None,
    }
}

fn columns(painter: &mut Painter, line: Rect, words: [&str; 5], style: Style) {
    let name_width = line.width.saturating_sub(38).clamp(12, 60);
    let mut from = 0_u16;
    for (word, width) in words.into_iter().zip([name_width, 10, 6, 8, 10]) {
        painter.text(span(line, from, width), word, style);
        from = from.saturating_add(width + 1);
    }
}

fn live_line(painter: &mut Painter, at: Rect, line: &LineView, style: Style) {
    let live = &line.live;
    let mark = if live.hidden { "[ ]" } else { "[x]" };
    let kept = if live.kept.is_some() { ", kept" } else { "" };
    let name = format!("{mark} live, in memory{kept}");
    let state = match (&live.ticket, &live.failure, &live.done) {
        (Some(_), ..) => "running",
        (None, Some(why), _) if why == "cancelled" => "cancelled",
        (None, Some(_), _) => "failed",
        (None, None, Some(_)) => "done",
        (None, None, None) => "",
    };
    let run = live.done.as_ref().and_then(|done| done.run.as_ref());
    let (steps, cpu) = cost_words(run.map(|run| (run.info.work.steps, run.info.cost.cpu_s)));
    let method = method_name(line.case.solver.method);
    columns(painter, at, [&name, state, method, &steps, &cpu], style);
}

fn run_line(painter: &mut Painter, at: Rect, entry: &RunEntry, style: Style) {
    let mark = if entry.shown { "[x]" } else { "[ ]" };
    let label = if entry.label.is_empty() {
        String::new()
    } else {
        format!("{}: ", entry.label)
    };
    let name = format!("{mark} {label}{}", entry.id);
    let (steps, cpu) = cost_words(entry.cost);
    let style = match entry.state {
        RunStatus::Job(JobState::Failed(_)) | RunStatus::Unreadable(_) => {
            style.patch(painter.theme.error())
        }
        _ => style,
    };
    let words = [&name, entry.state.word(), &entry.method, &steps, &cpu];
    columns(painter, at, words, style);
}

fn cost_words(cost: Option<(u64, f64)>) -> (String, String) {
    cost.map_or_else(Default::default, |(steps, cpu)| {
        (steps.to_string(), number::duration(cpu))
    })
}
