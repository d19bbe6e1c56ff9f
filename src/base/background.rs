//! Threads that compute: their priority and their CPU time.

use rustix::time::{ClockId, clock_gettime};

/// Lowers the priority of the calling thread, and of the threads it starts, so that what it computes never holds up the
/// thread that answers the keys. Only Linux has a priority for each thread; elsewhere nothing is done.
pub fn lower_priority() {
    // The greater, the more others go first; 19 is the most.
    const NICENESS: i32 = 10;
    #[cfg(target_os = "linux")]
    let _ = rustix::process::setpriority_process(None, NICENESS);
    #[cfg(not(target_os = "linux"))]
    let _ = NICENESS;
}

/// CPU time of the calling thread \[s\].
#[must_use]
pub fn cpu_time() -> f64 {
    let t = clock_gettime(ClockId::ThreadCPUTime);
    t.tv_sec as f64 + 1e-9 * t.tv_nsec as f64
}
