//! The strip of the tutorial at the foot of the screen: a title, and two lines on what to do.

use ratatui::layout::Rect;

use super::paint::{row, wrap};
use super::painter::Painter;
use crate::tutorial::COUNT;

impl Painter<'_> {
    /// Draws the strip below the rest of the screen, where there is room for it.
    pub(super) fn tutorial(&mut self, screen: Rect, work: Rect) {
        let Some(tutorial) = &self.state.tutorial else {
            return;
        };
        let height = screen.height.saturating_sub(work.height);
        if height == 0 {
            return;
        }
        let strip = Rect::new(screen.x, work.bottom(), screen.width, height);
        let step = tutorial.shown();
        let head = row(strip, 0);
        self.buf.set_style(head, self.theme.selected());
        let title = format!(" Tutorial {} of {COUNT}: {}", tutorial.step + 1, step.title);
        self.text(head, &title, self.theme.selected());
        let ways = self
            .state
            .worded("`:tutorial_skip` skips, `:tutorial` leaves ");
        let ways = ways.replace('`', "");
        super::paint::right(self.buf, head, &ways, self.theme.selected());
        let words = self.state.worded(&(step.words)(self.state));
        let lines = wrap(&words, strip.width.into());
        for (at, line) in (1..height).zip(&lines) {
            self.text(row(strip, at), line, self.theme.plain());
        }
    }
}
