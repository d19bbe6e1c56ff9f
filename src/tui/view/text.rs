//! Words in a pane, and a line that is typed into.

use ratatui::layout::{Constraint, Layout, Rect};
use tui_input::Input;

use super::Painter;
use super::paint::{row, text, wrap};

impl Painter<'_> {
    /// Plain words in an area, broken between words, as many lines as it has.
    pub(super) fn paragraph(&mut self, area: Rect, words: &str) {
        let lines = wrap(words, area.width.into());
        for (i, line) in lines.iter().take(area.height.into()).enumerate() {
            let at = row(area, u16::try_from(i).unwrap_or(u16::MAX));
            text(self.buf, (at.x, at.y), at.width, line, self.theme.plain());
        }
    }

    /// A title with words below it, one line apart.
    pub(super) fn titled(&mut self, area: Rect, title: &str, words: &str) {
        let strong = self.theme.strong();
        text(self.buf, (area.x, area.y), area.width, title, strong);
        let [_, below] = Layout::vertical([Constraint::Length(2), Constraint::Min(0)]).areas(area);
        self.paragraph(below, words);
    }

    /// What is typed after a prompt, scrolled to where the cursor is; the terminal's own cursor stands there while
    /// keys go in.
    pub(super) fn prompt(&mut self, line: Rect, prompt: &str, input: &Input, typing: bool) {
        let strong = self.theme.strong();
        let x = text(self.buf, (line.x, line.y), line.width, prompt, strong);
        let room = line.right().saturating_sub(x + 1);
        let scroll = input.visual_scroll(room.into());
        let value: String = input.value().chars().skip(scroll).collect();
        text(self.buf, (x, line.y), room, &value, self.theme.plain());
        if typing {
            let at = u16::try_from(input.visual_cursor().saturating_sub(scroll)).unwrap_or(0);
            self.cursor = Some((x.saturating_add(at), line.y));
        }
    }
}
