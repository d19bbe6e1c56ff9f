//! Whether results are computed that are not on disk yet: a signal ends the program at once where there are none.

use std::sync::atomic::{AtomicUsize, Ordering};

/// How many hold such results.
static HOLDERS: AtomicUsize = AtomicUsize::new(0);

/// Held by what computes results and writes them at its end, from its first result until all are on disk.
#[derive(Debug)]
pub struct Unsaved(());

impl Unsaved {
    /// Results are computed from now on.
    pub fn begin() -> Self {
        HOLDERS.fetch_add(1, Ordering::SeqCst);
        Self(())
    }
}

impl Drop for Unsaved {
    fn drop(&mut self) {
        HOLDERS.fetch_sub(1, Ordering::SeqCst);
    }
}

/// Whether there are any.
pub(crate) fn any() -> bool {
    HOLDERS.load(Ordering::SeqCst) > 0
}
