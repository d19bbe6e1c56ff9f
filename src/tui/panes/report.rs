//! The text report of a run.

use std::path::PathBuf;

use ratatui::layout::Rect;

use super::interface::{Pane, PaneInfo, about};
use crate::command::{self, Command, CommandId, DOWN, LIST, WIDE};
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::state::AppState;
use crate::update::export;
use crate::update::motion::{moved, step};
use crate::view::layout;
use crate::view::paint::below_head;
use crate::view::painter::Painter;

/// Columns that a key scrolls sideways, and the last column to scroll to.
const SIDEWAYS: isize = 8;
const LAST_COLUMN: usize = 400;

const COMMANDS: &[Command] = &[
    command::write("Write the report to a text file, of a stored run into its directory"),
    command::WRITE_AS,
    DOWN,
];

pub(super) struct ReportPane;

/// Rows of the text in the pane, below its head.
fn text_rows(area: Rect) -> usize {
    usize::from(area.height.saturating_sub(1))
}

impl Pane for ReportPane {
    fn about(&self) -> PaneInfo {
        about("Report", "Go to the report", &[COMMANDS, LIST, WIDE])
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let view = state.runs_view()?;
        let none = view.report.is_none() && view.report_asked.is_none();
        (matches!(id, CommandId::Write | CommandId::WriteAs) && none)
            .then_some("There is no finished run to report on. `:run` runs the case.")
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let by = step(state, id);
        let page = layout::pane_area(state, PaneId::Report).map_or(0, text_rows);
        let (view, editor) = state.document.as_mut()?.runs_and_editor()?;
        let across = &mut view.report_scroll.1;
        match id {
            CommandId::Write => {
                let beside = format!("{}-report.txt", editor.stem());
                let dir = view.reported().and_then(|(_, _, dir)| dir);
                let path = dir.map_or_else(|| PathBuf::from(beside), |dir| dir.join("report.txt"));
                let text = view.report.as_ref().map(|(_, text)| text.clone());
                return Some(export::write(path, text, "The report"));
            }
            CommandId::ScrollRight => *across = moved(*across, SIDEWAYS, LAST_COLUMN),
            CommandId::ScrollLeft => *across = moved(*across, -SIDEWAYS, LAST_COLUMN),
            _ => {
                let report = view.report.as_ref();
                let lines = report.map_or(0, |(_, text)| text.lines().count());
                // The last line is at the foot of the pane at most.
                let last = lines.saturating_sub(page);
                view.report_scroll.0 = moved(view.report_scroll.0.min(last), by?, last + 1);
            }
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let Some(view) = painter.state.runs_view() else {
            return;
        };
        let Some((name, report)) = &view.report else {
            let words = match view.report_asked {
                Some(_) => "The report is being made.",
                None => "There is no finished run to report on yet. `:run` runs the case.",
            };
            return painter.paragraph(area, words);
        };
        let [head, below] = below_head(area);
        let words = match view.report_asked {
            Some(_) => format!("Report on {name}, older than the run: a newer one is being made."),
            None => format!(
                "Report on {name}; `:write` saves it as text, `:write_as` in another format."
            ),
        };
        let words = painter.state.worded(&words);
        painter.text(head, &words, painter.theme.strong());
        let (down, across) = view.report_scroll;
        let last = report.lines().count().saturating_sub(text_rows(area));
        let down = down.min(last);
        let plain = painter.theme.plain();
        let lines = report.lines().skip(down);
        let seen = lines.map(|line| (line.chars().skip(across).collect::<String>(), plain));
        painter.lines(below, seen);
    }
}
