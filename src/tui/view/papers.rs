//! The validation table and the report.

use ratatui::layout::Rect;

use super::Canvas;
use super::paint::{row, text, wrap};
use crate::tui::backend;
use crate::tui::inks::Inks;
use crate::tui::state::OpenCase;

impl Canvas<'_> {
    pub(super) fn validation(&mut self, area: Rect, open: &OpenCase) {
        if open.checks.is_empty() {
            let words = "This case states no published values to be held against.";
            text(
                self.buf,
                (area.x, area.y),
                area.width,
                words,
                self.theme.plain(),
            );
            return;
        }
        let inks = Inks::new(self.state.looks.colour);
        let table = backend::checks_table(&open.checks);
        let glyphs = self.state.looks.glyphs;
        open.checks_pane.draw(&table, area, self.buf, glyphs, inks);
    }

    pub(super) fn report(&mut self, area: Rect, open: &OpenCase) {
        let Some((name, report)) = &open.report else {
            let words = "There is no finished run to report on yet. `R` runs the case.";
            for (i, line) in wrap(words, area.width.into()).iter().enumerate() {
                let at = row(area, u16::try_from(i).unwrap_or(u16::MAX));
                text(self.buf, (at.x, at.y), at.width, line, self.theme.plain());
            }
            return;
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
