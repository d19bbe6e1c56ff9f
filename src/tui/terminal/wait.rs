//! Waiting for the terminal and for signals with `poll(2)`.
//!
//! Asked before every read, it notices a terminal that has hung up without a SIGHUP; libraries that
//! only ask for readability spin forever on such a descriptor.

use std::io;
use std::os::fd::BorrowedFd;
use std::time::Duration;

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::Errno;

/// Why the wait ended; all false when the time was up.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct WakeReasons {
    /// The terminal has bytes.
    pub input: bool,
    /// A signal came.
    pub signal: bool,
    /// Another thread has sent a message.
    pub message: bool,
    /// The terminal has hung up.
    pub hung_up: bool,
}

/// Waits until the terminal, the socket of the signals or that of the messages has something, or the time is up; no limit:
/// `None`.
///
/// # Errors
/// What `poll(2)` reports, except that an interruption by a signal counts as one.
pub fn wait(
    terminal: BorrowedFd<'_>,
    signals: BorrowedFd<'_>,
    messages: BorrowedFd<'_>,
    limit: Option<Duration>,
) -> io::Result<WakeReasons> {
    let mut fds = [
        PollFd::from_borrowed_fd(terminal, PollFlags::IN),
        PollFd::from_borrowed_fd(signals, PollFlags::IN),
        PollFd::from_borrowed_fd(messages, PollFlags::IN),
    ];
    let limit = limit.and_then(|d| Timespec::try_from(d).ok());
    match poll(&mut fds, limit.as_ref()) {
        Ok(_) => {}
        Err(Errno::INTR) => {
            return Ok(WakeReasons {
                signal: true,
                ..WakeReasons::default()
            });
        }
        Err(error) => return Err(error.into()),
    }
    let gone = PollFlags::HUP | PollFlags::ERR | PollFlags::NVAL;
    Ok(WakeReasons {
        input: fds[0].revents().contains(PollFlags::IN),
        signal: fds[1].revents().contains(PollFlags::IN),
        message: fds[2].revents().contains(PollFlags::IN),
        hung_up: fds[0].revents().intersects(gone),
    })
}

/// Reads what is there; zero bytes and an input/output error both mean that the terminal has hung up.
///
/// # Errors
/// Any other error of `read(2)`.
pub fn read(terminal: BorrowedFd<'_>, buffer: &mut [u8]) -> io::Result<Option<usize>> {
    match rustix::io::read(terminal, buffer) {
        Ok(0) | Err(Errno::IO) => Ok(None),
        Ok(n) => Ok(Some(n)),
        Err(Errno::INTR | Errno::AGAIN) => Ok(Some(0)),
        Err(error) => Err(error.into()),
    }
}
