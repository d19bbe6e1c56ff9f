//! SIGINT, SIGTERM and SIGHUP stop a run, which keeps what it has computed. A second one ends the program at once.

use std::{
    io,
    path::Path,
    process::ExitCode,
    sync::{
        Arc,
        atomic::{AtomicBool, AtomicUsize, Ordering},
    },
};

use super::CommandError;
use crate::files::read;
use signal_hook::{
    consts::{SIGHUP, SIGINT, SIGTERM},
    flag,
};

/// Exit status of a program ended by signal `n`, less n.
const BY_SIGNAL: i32 = 128;

/// Whether the program was started to outlive its terminal, as by `nohup`, which a handler would undo.
fn hang_up_is_ignored() -> bool {
    let status = read::text(Path::new("/proc/self/status")).unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (SIGHUP - 1) & 1 == 1)
}

/// Set when the user or the system asks the program to stop.
#[derive(Debug, Clone, Default)]
pub(super) struct StopFlag {
    cancel: Arc<AtomicBool>,
    signal: Arc<AtomicUsize>,
}

impl StopFlag {
    /// Listens to these signals from now on.
    pub(super) fn listen() -> Result<Self, CommandError> {
        let caught = Self::register();
        caught.map_err(|e| CommandError::Usage(format!("Signals cannot be caught: {e}")))
    }

    fn register() -> io::Result<Self> {
        let stop = Self::default();
        let hang_up = (!hang_up_is_ignored()).then_some(SIGHUP);
        for signal in [SIGINT, SIGTERM].into_iter().chain(hang_up) {
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
