//! SIGINT, SIGTERM and SIGHUP stop a command. A second one ends the program at once.
//!
//! What computes looks at a flag, ends in order, and keeps and prints what it has. Where the program does not get there in a moment, because
//! it reads, checks, searches an equilibrium or sorts results, and no result waits to be written ([`grace`]), a thread of its own ends
//! the program: no loop has to look for signals. What is on disk is whole or marked partial then, as after a kill.

use std::{
    io::{self, IsTerminal, Read},
    os::unix::net::UnixStream,
    path::Path,
    process::ExitCode,
    sync::{
        Arc, Mutex,
        atomic::{AtomicBool, AtomicUsize, Ordering},
    },
    thread,
};

use super::{CommandError, output};
use seacable_base::files::read;
use seacable_base::grace;
use signal_hook::{
    consts::{SIGHUP, SIGINT, SIGTERM},
    flag,
    low_level::{exit, pipe},
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
    /// What is said where the program does not end in order.
    farewell: Arc<Mutex<String>>,
}

impl StopFlag {
    /// Listens to these signals from now on.
    pub(super) fn listen() -> Result<Self, CommandError> {
        let caught = Self::register();
        caught.map_err(|e| CommandError::Usage(format!("Signals cannot be caught: {e}")))
    }

    fn register() -> io::Result<Self> {
        let stop = Self::default();
        let (wake, waker) = UnixStream::pair()?;
        waker.set_nonblocking(true)?;
        let hang_up = (!hang_up_is_ignored()).then_some(SIGHUP);
        for signal in [SIGINT, SIGTERM].into_iter().chain(hang_up) {
            let again = BY_SIGNAL + signal;
            flag::register_conditional_shutdown(signal, again, Arc::clone(&stop.cancel))?;
            let number = usize::try_from(signal).unwrap_or_default();
            flag::register_usize(signal, Arc::clone(&stop.signal), number)?;
            flag::register(signal, Arc::clone(&stop.cancel))?;
            pipe::register(signal, waker.try_clone()?)?;
        }
        let watched = stop.clone();
        let watch = thread::Builder::new().name("signals".to_owned());
        watch.spawn(move || watched.end_after_grace(wake))?;
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

    /// What is said where a signal ends the program before it can say more.
    pub(super) fn say_at_the_end(&self, words: &str) {
        if let Ok(mut farewell) = self.farewell.lock() {
            words.clone_into(&mut farewell);
        }
    }

    /// The exit status of the signal that was caught, if any.
    pub(super) fn status(&self) -> Option<ExitCode> {
        u8::try_from(self.code()?).ok().map(ExitCode::from)
    }

    fn code(&self) -> Option<i32> {
        match i32::try_from(self.signal.load(Ordering::SeqCst)) {
            Ok(0) | Err(_) => None,
            Ok(signal) => Some(BY_SIGNAL + signal),
        }
    }

    /// Waits for a signal and ends the program after it, unless that ends in order before.
    fn end_after_grace(&self, mut wake: UnixStream) {
        if wake.read_exact(&mut [0]).is_err() {
            return;
        }
        grace::wait();
        if io::stderr().is_terminal() {
            output::progress("");
        }
        let farewell = self.farewell.lock();
        if let Some(words) = farewell.ok().filter(|words| !words.is_empty()) {
            output::message(&words);
        }
        exit(self.code().unwrap_or(BY_SIGNAL));
    }
}
