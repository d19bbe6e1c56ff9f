//! The validation table, the report, and the line node by node.

use ratatui::layout::{Constraint, Layout, Rect};

use super::Painter;
use super::paint::{row, text};
use crate::report::limits as limits_table;
use crate::run::limits;
use crate::tui::facade;
use crate::tui::line_tables::LineTable;
use crate::tui::state::OpenCase;
use crate::tui::update::reported;

/// What stands in place of a validation table that would be empty.
pub(super) const NO_PUBLISHED_VALUES: &str =
    "This file states no published values to be held against.";

impl Painter<'_> {
    pub(super) fn validation(&mut self, area: Rect, open: &OpenCase) {
        if open.checks.is_empty() {
            return self.paragraph(area, NO_PUBLISHED_VALUES);
        }
        let table = facade::checks_table(&open.checks);
        let glyphs = self.state.capabilities.glyphs;
        open.checks_pane
            .draw(&table, area, self.buf, glyphs, self.theme);
    }

    /// What the sections bear, where the case states limits, and the nodes below.
    pub(super) fn nodes(&mut self, area: Rect, open: &OpenCase) {
        let Some((name, run, _)) = reported(open) else {
            return self.paragraph(area, "There is no finished run yet. `R` runs the case.");
        };
        let glyphs = self.state.capabilities.glyphs;
        let mut rest = area;
        // A stored run may be of another text than the one that is open.
        let case = facade::parse(&run.case_text, &open.editor.file);
        let limits = case.ok().and_then(|case| {
            let checks = limits::check(&case, &run.profile);
            limits_table::table(&checks)
        });
        if let Some(table) = limits {
            let lines = table.to_text(area.width.into());
            let height = u16::try_from(lines.lines().count()).unwrap_or(u16::MAX);
            // The nodes keep at least half of the room.
            if height < area.height / 2 {
                for (i, line) in lines.lines().enumerate() {
                    let at = row(area, u16::try_from(i).unwrap_or(u16::MAX));
                    let style = if line.contains(limits_table::EXCEEDED) {
                        self.theme.error()
                    } else {
                        self.theme.plain()
                    };
                    text(self.buf, (at.x, at.y), at.width, line, style);
                }
                let [_, below] =
                    Layout::vertical([Constraint::Length(height + 1), Constraint::Min(0)])
                        .areas(area);
                rest = below;
            }
        }
        let which = open.line_table.or_nodes(&run);
        let mut table = which.table(&run);
        table.title = match (which, LineTable::of(&run).len()) {
            (LineTable::Nodes, 1) => format!("Nodes of {name}; `w` writes them as CSV."),
            (which, count) => {
                let number = 1 + which as usize;
                let what = which.title();
                format!("{what} of {name}, table {number} of {count}; `]` leafs, `w` writes it.")
            }
        };
        open.nodes_pane
            .draw(&table, rest, self.buf, glyphs, self.theme);
    }

    pub(super) fn report(&mut self, area: Rect, open: &OpenCase) {
        let Some((name, report)) = &open.report else {
            let words = "There is no finished run to report on yet. `R` runs the case.";
            return self.paragraph(area, words);
        };
        let words = format!("Report on {name}; `w` saves it.");
        text(
            self.buf,
            (area.x, area.y),
            area.width,
            &words,
            self.theme.strong(),
        );
        let (down, across) = open.report_scroll;
        for (i, line) in report.lines().skip(down).enumerate() {
            let at = row(area, u16::try_from(i + 1).unwrap_or(u16::MAX));
            if at.width == 0 {
                break;
            }
            let line: String = line.chars().skip(across).collect();
            text(self.buf, (at.x, at.y), at.width, &line, self.theme.plain());
        }
    }
}
