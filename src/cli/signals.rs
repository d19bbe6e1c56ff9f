//! SIGINT and SIGTERM stop a run, which keeps what it has computed. A second one ends the program at once.

use std::{
    io,
    process::ExitCode,
    sync::{
        Arc,
        atomic::{AtomicBool, AtomicUsize, Ordering},
    },
};

use super::CommandError;
use signal_hook::{
    consts::{SIGINT, SIGTERM},
    flag,
};

/// Exit status of a program ended by signal `n`, less n.
const BY_SIGNAL: i32 = 128;

/// Set when the user or the system asks the program to stop.
#[derive(Debug, Clone, Default)]
pub(super) struct StopFlag {
    cancel: Arc<AtomicBool>,
    signal: Arc<AtomicUsize>,
}

impl StopFlag {
    /// Listens to both signals from now on.
    pub(super) fn listen() -> Result<Self, CommandError> {
        let caught = Self::register();
        caught.map_err(|e| CommandError::Usage(format!("Signals cannot be caught: {e}")))
    }

    fn register() -> io::Result<Self> {
        let stop = Self::default();
        for signal in [SIGINT, SIGTERM] {
            let again = BY_SIGNAL + signal;
            flag::register_conditional_shutdown(signal, again, Arc::clone(&stop.cancel))?;
            let number = usize::try_from(signal).unwrap_or_default();
            flag::register_usize(signal, Arc::clone(&stop.signal), number)?;
            flag::register(signal, Arc::clone(&stop.cancel))?;
        }
        Ok(stop)
    }

    /// The flag that a computation watches.
    pub(super) fn cancel(&self) -> &AtomicBool {
        &self.cancel
    }

    /// Requests a stop from within the program.
    pub(super) fn request(&self) {
        self.cancel.store(true, Ordering::SeqCst);
    }

    /// The exit status of the signal that was caught, if any.
    pub(super) fn status(&self) -> Option<ExitCode> {
        let code = match i32::try_from(self.signal.load(Ordering::SeqCst)) {
            Ok(0) | Err(_) => return None,
            Ok(signal) => BY_SIGNAL + signal,
        };
        u8::try_from(code).ok().map(ExitCode::from)
    }
}
