//! How long a program that was told to stop may take to end in order: a moment, and as long as results wait to be written ([`unsaved`]). After
//! that a thread of its own ends it, so that no loop has to look for signals.

use std::thread;
use std::time::{Duration, Instant};

use rustix::time::{ClockId, clock_gettime};

use crate::files::unsaved;

/// How long a program that was stopped may take to end in order.
const GRACE: Duration = Duration::from_millis(150);

/// CPU time that it may take of that, so that it gets its share where others have the cores.
const GRACE_CPU: Duration = Duration::from_millis(60);

/// How long it may wait in all, for others or for a disk.
const LONGEST_GRACE: Duration = Duration::from_millis(600);

/// Between two looks at the clocks.
const NAP: Duration = Duration::from_millis(10);

/// Waits until the time is up, which begins anew while results wait to be written.
pub fn wait() {
    let mut clocks = Clocks::now();
    while unsaved::any() || !clocks.have_passed() {
        if unsaved::any() {
            clocks = Clocks::now();
        }
        thread::sleep(NAP);
    }
}

/// When the time began that a program has to end in order.
struct Clocks {
    wall: Instant,
    cpu: Duration,
}

impl Clocks {
    fn now() -> Self {
        Self {
            wall: Instant::now(),
            cpu: cpu_time(),
        }
    }

    fn have_passed(&self) -> bool {
        let waited = self.wall.elapsed();
        let had_its_share = cpu_time().saturating_sub(self.cpu) >= GRACE_CPU;
        waited >= LONGEST_GRACE || waited >= GRACE && had_its_share
    }
}

/// CPU time of the program.
fn cpu_time() -> Duration {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.try_into().unwrap_or_default()
}
