//! Threads that work behind the screen.

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
