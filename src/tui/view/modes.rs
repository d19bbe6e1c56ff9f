//! Natural modes: their table, and the shape of the one selected.

use ratatui::layout::{Constraint, Layout, Rect};

use super::Painter;
use super::paint::text;
use crate::modes::LineModes;
use crate::report::modes as views;
use crate::report::table::Table;
use crate::tui::plot_pane::draw_chart;
use crate::tui::state::OpenCase;

/// From this room on both pictures are seen at once.
const BOTH: (u16, u16) = (110, 24);

impl Painter<'_> {
    pub(super) fn modes(&mut self, area: Rect, open: &OpenCase) {
        let found = match &open.modes.found {
            Some(Ok(found)) => found,
            Some(Err(why)) => {
                let words = format!("There are no modes to tell: {why}");
                return self.paragraph(area, &words);
            }
            None => return self.paragraph(area, "The modes are looked for in the background."),
        };
        let both = area.width >= BOTH.0 && area.height >= BOTH.1;
        let lines = u16::try_from(found.modes.len() + 2).unwrap_or(u16::MAX);
        let most = if both {
            area.height / 2
        } else {
            area.height * 9 / 20
        };
        let [table, said, pictures] = Layout::vertical([
            Constraint::Length(lines.min(most)),
            Constraint::Length(1),
            Constraint::Min(0),
        ])
        .areas(area);
        let whole = if area.width < BOTH.0 {
            views::narrow(found)
        } else {
            views::table(found)
        };
        let bare = Table {
            notes: Vec::new(),
            ..whole.clone()
        };
        let glyphs = self.state.capabilities.glyphs;
        open.modes
            .pane
            .draw(&bare, table, self.buf, glyphs, self.theme);
        self.about_modes(said, open, &views::troubles(found));
        let number = open.modes.pane.selected(&bare).unwrap_or(0);
        self.mode_pictures(pictures, found, number, both, open.modes.over);
    }

    /// What must be known of the modes, the most pressing first.
    fn about_modes(&mut self, line: Rect, open: &OpenCase, troubles: &[String]) {
        let old = open.modes.text != open.editor.text;
        let (words, style) = match (old, troubles.first()) {
            (true, _) => (
                "Of the case before the last edit; looked for anew.",
                self.theme.warning(),
            ),
            (false, Some(note)) => (note.as_str(), self.theme.warning()),
            (false, None) => (
                "About the line at rest; added mass in, drag out; errors from half the mesh.",
                self.theme.faint(),
            ),
        };
        text(self.buf, (line.x, line.y), line.width, words, style);
    }

    fn mode_pictures(
        &mut self,
        area: Rect,
        found: &LineModes,
        number: usize,
        both: bool,
        over: bool,
    ) {
        let glyphs = self.state.capabilities.glyphs;
        let along = views::chart(found, &[number]);
        let shape = views::over_line(found, number);
        if both {
            let [left, right] =
                Layout::horizontal([Constraint::Fill(1), Constraint::Fill(1)]).areas(area);
            draw_chart(&along, left, self.buf, glyphs, self.theme);
            draw_chart(&shape, right, self.buf, glyphs, self.theme);
        } else {
            let chart = if over { shape } else { along };
            draw_chart(&chart, area, self.buf, glyphs, self.theme);
        }
    }
}
