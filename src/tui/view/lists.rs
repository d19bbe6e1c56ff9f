//! The runs of a case, and the jobs.

use ratatui::layout::Rect;

use super::Painter;
use super::paint::{first_line, row, text};
use crate::report::number;
use crate::tui::pane::PaneId;
use crate::tui::state::{JobLine, JobState, OpenCase, Purpose, RunEntry, RunStatus};

impl Painter<'_> {
    pub(super) fn runs(&mut self, area: Rect, open: &OpenCase) {
        let name_width = area.width.saturating_sub(38).clamp(12, 60);
        let head = row(area, 0);
        self.columns(
            head,
            name_width,
            ["    run", "state", "solver", "steps", "CPU"],
            self.theme.strong(),
        );
        let list = Rect::new(
            area.x,
            area.y + 1,
            area.width,
            area.height.saturating_sub(1),
        );
        let height = usize::from(list.height);
        let first = first_line(open.run, open.runs.len() + 1, height);
        for (i, at) in (first..=open.runs.len()).take(height).enumerate() {
            let line = row(list, u16::try_from(i).unwrap_or(u16::MAX));
            let selected = open.run == at && open.pane == PaneId::Runs;
            let style = if selected {
                self.theme.selected()
            } else {
                self.theme.plain()
            };
            self.buf.set_style(line, style);
            match at.checked_sub(1).and_then(|i| open.runs.get(i)) {
                None => self.live_line(line, name_width, open, style),
                Some(slot) => self.run_line(line, name_width, slot, style),
            }
        }
    }

    fn columns(
        &mut self,
        line: Rect,
        name_width: u16,
        words: [&str; 5],
        style: ratatui::style::Style,
    ) {
        let widths = [name_width, 10, 6, 8, 10];
        let mut x = line.x;
        for (word, width) in words.into_iter().zip(widths) {
            let room = line.right().saturating_sub(x).min(width);
            text(self.buf, (x, line.y), room, word, style);
            x = x.saturating_add(width + 1);
        }
    }

    fn live_line(&mut self, line: Rect, width: u16, open: &OpenCase, style: ratatui::style::Style) {
        let live = &open.live;
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
        let run = live.done.as_ref().and_then(|d| d.run.as_ref());
        let cost = run.map(|run| (run.info.work.steps, run.info.cost.cpu_s));
        let (steps, cpu) = cost_words(cost);
        let method = crate::tui::facade::method_word(open.case.solver.method);
        self.columns(line, width, [&name, state, method, &steps, &cpu], style);
    }

    fn run_line(&mut self, line: Rect, width: u16, slot: &RunEntry, style: ratatui::style::Style) {
        let mark = if slot.shown { "[x]" } else { "[ ]" };
        let label = if slot.label.is_empty() {
            String::new()
        } else {
            format!("{}: ", slot.label)
        };
        let name = format!("{mark} {label}{}", slot.id);
        let (steps, cpu) = cost_words(slot.cost);
        let style = match slot.state {
            RunStatus::Failed(_) | RunStatus::Unreadable(_) => style.patch(self.theme.error()),
            _ => style,
        };
        self.columns(
            line,
            width,
            [&name, slot.state.word(), &slot.method, &steps, &cpu],
            style,
        );
    }

    pub(super) fn jobs(&mut self, area: Rect) {
        let jobs = &self.state.jobs;
        if jobs.lines.is_empty() {
            text(
                self.buf,
                (area.x, area.y),
                area.width,
                "No jobs yet.",
                self.theme.faint(),
            );
            return;
        }
        let height = usize::from(area.height);
        let first = first_line(jobs.cursor, jobs.lines.len(), height);
        for (i, (at, line)) in jobs
            .lines
            .iter()
            .enumerate()
            .skip(first)
            .take(height)
            .enumerate()
        {
            let selected = at == jobs.cursor && self.state.focus() == PaneId::Jobs;
            let style = if selected {
                self.theme.selected()
            } else {
                self.theme.plain()
            };
            let place = row(area, u16::try_from(i).unwrap_or(u16::MAX));
            self.buf.set_style(place, style);
            let half = (area.width / 2).max(20);
            text(
                self.buf,
                (place.x, place.y),
                half.saturating_sub(1),
                &line.name,
                style,
            );
            let x = place.x + half;
            text(
                self.buf,
                (x, place.y),
                place.right().saturating_sub(x),
                &job_words(line),
                style,
            );
        }
    }
}

fn cost_words(cost: Option<(u64, f64)>) -> (String, String) {
    cost.map_or_else(
        || (String::new(), String::new()),
        |(steps, cpu)| (steps.to_string(), number::duration(cpu)),
    )
}

fn job_words(line: &JobLine) -> String {
    let p = line.progress;
    match &line.state {
        JobState::Running if line.purpose == Purpose::Trials => {
            format!("{:.0} of {:.0} trials", p.time, p.duration)
        }
        JobState::Running if p.estimating => "estimating errors".to_owned(),
        JobState::Running if p.steps == 0 => "starting".to_owned(),
        JobState::Running => {
            let left = p
                .remaining_s()
                .map_or_else(String::new, |s| format!(", {} left", number::duration(s)));
            format!(
                "step {}, {:.0} of {:.0} s{left}",
                p.steps, p.time, p.duration
            )
        }
        JobState::Failed(why) => format!("failed: {why}"),
        other => other.word().to_owned(),
    }
}
