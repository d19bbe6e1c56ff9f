//! The instant at which a search ends.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crossbeam_channel::RecvTimeoutError;

/// The instant at which a search ends.
pub(super) struct Deadline {
    pub(super) begun: Instant,
    budget_s: f64,
}

impl Deadline {
    pub(super) fn after(budget_s: f64) -> Self {
        Self {
            begun: Instant::now(),
            budget_s,
        }
    }

    /// Time left \[s\].
    pub(super) fn left(&self) -> f64 {
        self.budget_s - self.begun.elapsed().as_secs_f64()
    }

    /// Works, with a flag that is set at the deadline or where the user's is.
    pub(super) fn watch<T>(&self, cancel: &AtomicBool, work: impl FnOnce(&AtomicBool) -> T) -> T {
        const EVERY: Duration = Duration::from_millis(20);
        let (stop, (working, done)) = (AtomicBool::new(false), crossbeam_channel::bounded::<()>(0));
        std::thread::scope(|scope| {
            scope.spawn(|| {
                while done.recv_timeout(EVERY) == Err(RecvTimeoutError::Timeout) {
                    if cancel.load(Ordering::Relaxed) || self.left() <= 0.0 {
                        stop.store(true, Ordering::Relaxed);
                    }
                }
            });
            let result = work(&stop);
            drop(working);
            result
        })
    }
}
