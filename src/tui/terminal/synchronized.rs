//! Frames that a terminal shows whole: between the sequences of synchronized output where it may know them, in one write, and
//! nothing at all where nothing has changed.

use std::io::{self, Write};

use crossterm::terminal::{BeginSynchronizedUpdate, EndSynchronizedUpdate};
use crossterm::{cursor, queue};
use ratatui::backend::{Backend, ClearType, CrosstermBackend, WindowSize};
use ratatui::buffer::Cell;
use ratatui::layout::{Position, Size};

/// A backend whose bytes go out when a frame is complete.
pub(super) struct FrameBackend<W: Write> {
    inner: CrosstermBackend<W>,
    /// Whether the terminal may know synchronized output.
    synchronized: bool,
    /// An update has begun and not ended.
    begun: bool,
    /// Where the terminal's own cursor is; nothing while it is hidden.
    cursor: Option<Position>,
}

impl<W: Write> FrameBackend<W> {
    /// A backend for a terminal whose cursor is hidden.
    pub(super) fn new(out: W, synchronized: bool) -> Self {
        Self {
            inner: CrosstermBackend::new(out),
            synchronized,
            begun: false,
            cursor: None,
        }
    }

    /// The terminal was left and taken again, with its cursor hidden.
    pub(super) fn reenter(&mut self) {
        self.begun = false;
        self.cursor = None;
    }

    /// Writes bytes that are no cells.
    pub(super) fn write_now(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.inner.write_all(bytes)?;
        Write::flush(&mut self.inner)
    }

    fn begin(&mut self) -> io::Result<()> {
        if self.synchronized && !self.begun {
            queue!(self.inner, BeginSynchronizedUpdate)?;
            self.begun = true;
        }
        Ok(())
    }
}

impl<W: Write> Backend for FrameBackend<W> {
    type Error = io::Error;

    fn draw<'a, I>(&mut self, content: I) -> io::Result<()>
    where
        I: Iterator<Item = (u16, u16, &'a Cell)>,
    {
        let mut content = content.peekable();
        if content.peek().is_none() {
            return Ok(());
        }
        self.begin()?;
        self.inner.draw(content)?;
        // The cells have taken the cursor along.
        if let Some(at) = self.cursor {
            queue!(self.inner, cursor::MoveTo(at.x, at.y))?;
        }
        Ok(())
    }

    fn hide_cursor(&mut self) -> io::Result<()> {
        match self.cursor.take() {
            Some(_) => queue!(self.inner, cursor::Hide),
            None => Ok(()),
        }
    }

    fn show_cursor(&mut self) -> io::Result<()> {
        // It is shown where it is put next.
        Ok(())
    }

    fn get_cursor_position(&mut self) -> io::Result<Position> {
        self.inner.get_cursor_position()
    }

    fn set_cursor_position<P: Into<Position>>(&mut self, position: P) -> io::Result<()> {
        let at = position.into();
        match self.cursor.replace(at) {
            Some(before) if before == at => Ok(()),
            Some(_) => queue!(self.inner, cursor::MoveTo(at.x, at.y)),
            None => queue!(self.inner, cursor::MoveTo(at.x, at.y), cursor::Show),
        }
    }

    fn clear(&mut self) -> io::Result<()> {
        self.begin()?;
        self.inner.clear()
    }

    fn clear_region(&mut self, clear_type: ClearType) -> io::Result<()> {
        self.begin()?;
        self.inner.clear_region(clear_type)
    }

    fn append_lines(&mut self, n: u16) -> io::Result<()> {
        self.inner.append_lines(n)
    }

    fn size(&self) -> io::Result<Size> {
        self.inner.size()
    }

    fn window_size(&mut self) -> io::Result<WindowSize> {
        self.inner.window_size()
    }

    fn flush(&mut self) -> io::Result<()> {
        if std::mem::take(&mut self.begun) {
            queue!(self.inner, EndSynchronizedUpdate)?;
        }
        Write::flush(&mut self.inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratatui::Terminal;
    use ratatui::layout::Rect;
    use ratatui::{TerminalOptions, Viewport};
    use std::cell::RefCell;
    use std::rc::Rc;

    /// What the terminal is sent, a write an entry.
    #[derive(Clone, Default)]
    struct Sent(Rc<RefCell<Vec<u8>>>);

    impl Write for Sent {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0.borrow_mut().extend(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    /// The bytes of frames that show these words, the terminal's cursor at a column or hidden.
    fn frames(synchronized: bool, frames: &[(&str, Option<u16>)]) -> Vec<String> {
        let sent = Sent::default();
        let backend = FrameBackend::new(sent.clone(), synchronized);
        let viewport = Viewport::Fixed(Rect::new(0, 0, 20, 2));
        let mut terminal = Terminal::with_options(backend, TerminalOptions { viewport }).unwrap();
        let mut all = Vec::new();
        for (words, at) in frames {
            let drawn = terminal.draw(|frame| {
                let style = ratatui::style::Style::new();
                frame.buffer_mut().set_string(0, 0, words, style);
                if let Some(x) = at {
                    frame.set_cursor_position((*x, 0));
                }
            });
            drawn.unwrap();
            let bytes = std::mem::take(&mut *sent.0.borrow_mut());
            all.push(String::from_utf8(bytes).unwrap());
        }
        all
    }

    #[test]
    fn a_frame_is_shown_whole_and_one_without_changes_sends_nothing() {
        let sent = frames(true, &[("one", None), ("one", None), ("two", None)]);
        for frame in [&sent[0], &sent[2]] {
            assert!(
                frame.starts_with("\x1b[?2026h") && frame.ends_with("\x1b[?2026l"),
                "{frame:?}"
            );
        }
        assert_eq!(sent[1], "");
        assert!(!frames(false, &[("one", None)])[0].contains("2026"));
    }

    #[test]
    fn the_cursor_is_shown_moved_and_hidden_once() {
        let sent = frames(
            false,
            &[("a", Some(1)), ("a", Some(1)), ("a", Some(2)), ("a", None)],
        );
        assert!(sent[0].ends_with("\x1b[1;2H\x1b[?25h"), "{:?}", sent[0]);
        assert_eq!(sent[1..], ["", "\x1b[1;3H", "\x1b[?25l"]);
    }

    #[test]
    fn cells_leave_the_cursor_where_it_was() {
        let sent = frames(true, &[("a", Some(1)), ("b", Some(1))]);
        assert!(sent[1].ends_with("\x1b[1;2H\x1b[?2026l"), "{:?}", sent[1]);
    }
}
