//! Signals as flags, with a socket that wakes the waiting loop.

use std::io::{self, Read};
use std::os::fd::{AsFd, BorrowedFd};
use std::os::unix::net::UnixStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGTERM, SIGTSTP, SIGWINCH};

/// The signals that the workbench answers, each at most once until read.
#[derive(Debug)]
pub struct Signals {
    wake: UnixStream,
    flags: Vec<(Signal, Arc<AtomicBool>)>,
}

/// A signal and what it asks of us.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Signal {
    /// Leave: SIGTERM, or SIGINT from outside.
    Terminate(i32),
    /// The terminal goes away.
    HangUp,
    /// Stop until continued.
    Stop,
    /// Continued.
    Continue,
    /// The terminal has a new size.
    Resize,
}

impl Signals {
    /// Registers for all of them. A second SIGTERM ends the program at once, should the first hang.
    ///
    /// # Errors
    /// When the system refuses a handler or the socket.
    pub fn register() -> io::Result<Self> {
        let (wake, writer) = UnixStream::pair()?;
        wake.set_nonblocking(true)?;
        writer.set_nonblocking(true)?;
        let mut flags = Vec::new();
        for (number, signal) in [
            (SIGTERM, Signal::Terminate(SIGTERM)),
            (SIGINT, Signal::Terminate(SIGINT)),
            (SIGHUP, Signal::HangUp),
            (SIGTSTP, Signal::Stop),
            (SIGCONT, Signal::Continue),
            (SIGWINCH, Signal::Resize),
        ] {
            let flag = Arc::new(AtomicBool::new(false));
            if number == SIGTERM {
                signal_hook::flag::register_conditional_shutdown(
                    number,
                    128 + number,
                    Arc::clone(&flag),
                )?;
            }
            signal_hook::flag::register(number, Arc::clone(&flag))?;
            signal_hook::low_level::pipe::register(number, writer.try_clone()?)?;
            flags.push((signal, flag));
        }
        Ok(Self { wake, flags })
    }

    /// Readable when a signal came.
    #[must_use]
    pub fn fd(&self) -> BorrowedFd<'_> {
        self.wake.as_fd()
    }

    /// Forgets a SIGINT: one that came while another program had the terminal was meant for that program.
    pub fn forget_interrupt(&self) {
        for (signal, flag) in &self.flags {
            if *signal == Signal::Terminate(SIGINT) {
                flag.store(false, Ordering::SeqCst);
            }
        }
    }

    /// The signals that came since the last call, the pressing ones first.
    pub fn take(&mut self) -> Vec<Signal> {
        // The socket is emptied before the flags are read, so that no signal is lost in between.
        let mut buffer = [0_u8; 64];
        while matches!(self.wake.read(&mut buffer), Ok(n) if n > 0) {}
        self.flags
            .iter()
            .filter(|(signal, flag)| match signal {
                // Left standing, so that a second one ends the program.
                Signal::Terminate(_) => flag.load(Ordering::SeqCst),
                _ => flag.swap(false, Ordering::SeqCst),
            })
            .map(|(signal, _)| *signal)
            .collect()
    }
}
