//! Entering and leaving the terminal: one way in, one way out, for every kind of exit.

use std::fs::File;
use std::io::{self, BufWriter};
use std::os::fd::AsFd;
use std::sync::atomic::{AtomicBool, Ordering};

use crossterm::event::{DisableBracketedPaste, EnableBracketedPaste};
use crossterm::style::{Attribute, ResetColor, SetAttribute};
use crossterm::terminal::{
    Clear, ClearType, EnterAlternateScreen, LeaveAlternateScreen, disable_raw_mode, enable_raw_mode,
};
use crossterm::{cursor, queue};
use ratatui::layout::Rect;
use ratatui::{Frame, Terminal};

use super::synchronized::FrameBackend;

static ENTERED: AtomicBool = AtomicBool::new(false);

/// One frame at 200x60 fits; a frame is then sent in one write.
const FRAME_BYTES: usize = 1 << 16;

/// The screen while the workbench has it.
pub struct Screen {
    terminal: Terminal<FrameBackend<BufWriter<File>>>,
}

impl std::fmt::Debug for Screen {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Screen").finish_non_exhaustive()
    }
}

impl Screen {
    /// Takes the terminal: raw mode, alternate screen, bracketed paste. No mouse, no queries. Frames are `synchronized` where the
    /// terminal may know that.
    ///
    /// # Errors
    /// When the terminal cannot be set up; it is then as it was before.
    pub fn enter(synchronized: bool) -> io::Result<Self> {
        enter()?;
        let out = File::from(io::stdout().as_fd().try_clone_to_owned()?);
        let out = BufWriter::with_capacity(FRAME_BYTES, out);
        let backend = FrameBackend::new(out, synchronized);
        match Terminal::new(backend) {
            Ok(terminal) => Ok(Self { terminal }),
            Err(error) => {
                restore();
                Err(error)
            }
        }
    }

    /// Takes the terminal again after a stop; the next frame is painted whole.
    ///
    /// # Errors
    /// When the terminal cannot be set up.
    pub fn reenter(&mut self) -> io::Result<()> {
        enter()?;
        self.terminal.backend_mut().reenter();
        self.repaint()
    }

    /// Has the next frame painted whole, at the terminal's size of now.
    ///
    /// `Terminal::clear` would do, but asks the terminal for the cursor and waits for the answer.
    ///
    /// # Errors
    /// When the terminal cannot be written or asked for its size.
    pub fn repaint(&mut self) -> io::Result<()> {
        let size = self.size()?;
        self.terminal.resize(Rect::new(0, 0, size.0, size.1))
    }

    /// Columns and rows.
    ///
    /// # Errors
    /// When the system does not know.
    pub fn size(&self) -> io::Result<(u16, u16)> {
        let size = rustix::termios::tcgetwinsize(io::stdout().as_fd())?;
        // A terminal that has no size; any screen is better than no screen.
        Ok(match (size.ws_col, size.ws_row) {
            (0, _) | (_, 0) => (80, 24),
            known => known,
        })
    }

    /// Draws one frame and writes the difference in one go.
    ///
    /// # Errors
    /// When the terminal cannot be written.
    pub fn draw(&mut self, render: impl FnOnce(&mut Frame)) -> io::Result<()> {
        self.terminal.draw(render).map(|_| ())
    }

    /// Writes bytes that are no cells, such as a copy to the clipboard.
    ///
    /// # Errors
    /// When the terminal cannot be written.
    pub fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.terminal.backend_mut().write_now(bytes)
    }
}

fn enter() -> io::Result<()> {
    enable_raw_mode()?;
    ENTERED.store(true, Ordering::SeqCst);
    let mut bytes = Vec::new();
    queue!(
        bytes,
        EnterAlternateScreen,
        EnableBracketedPaste,
        Clear(ClearType::All),
        cursor::Hide
    )?;
    let written = write_out(&bytes);
    if written.is_err() {
        restore();
    }
    written
}

/// Gives the terminal back as it was. Used by normal exit, error, panic, stop and signals; safe to
/// call at any time and more than once, and silent when the terminal has hung up.
pub fn restore() {
    if !ENTERED.swap(false, Ordering::SeqCst) {
        return;
    }
    let mut bytes = Vec::new();
    // The screen is erased before it is left: old tmux otherwise leaves its rows in the shell.
    let queued = queue!(
        bytes,
        SetAttribute(Attribute::Reset),
        ResetColor,
        Clear(ClearType::All),
        DisableBracketedPaste,
        LeaveAlternateScreen,
        cursor::Show
    );
    if queued.is_ok() {
        drop(write_out(&bytes));
    }
    drop(disable_raw_mode());
}

fn write_out(mut bytes: &[u8]) -> io::Result<()> {
    let out = io::stdout();
    while !bytes.is_empty() {
        let written = rustix::io::retry_on_intr(|| rustix::io::write(out.as_fd(), bytes))?;
        bytes = &bytes[written..];
    }
    Ok(())
}
