//! Times of many repeats, and CPU time of another process.

use std::time::Duration;

/// Times of many repeats.
#[derive(Default)]
pub(crate) struct Times(Vec<Duration>);

impl Times {
    /// Adds one.
    pub(crate) fn add(&mut self, time: Duration) {
        self.0.push(time);
    }

    /// Median, 99th percentile and greatest, in words.
    pub(crate) fn words(&mut self) -> String {
        self.0.sort_unstable();
        let last = self.0.len() - 1;
        let at = |share: f64| self.0[(last as f64 * share).ceil() as usize].as_secs_f64() * 1e3;
        let (median, high, most) = (at(0.5), at(0.99), at(1.0));
        format!("{median:>9.1} ms median, {high:.1} ms at 99 %, {most:.1} ms greatest")
    }
}

/// CPU time that a process has used so far, all threads together.
pub(crate) fn cpu_time(process: i32) -> Duration {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).unwrap();
    let (_, tail) = stat.rsplit_once(')').unwrap();
    let fields: Vec<&str> = tail.split_whitespace().collect();
    let ticks: u64 = fields[11].parse::<u64>().unwrap() + fields[12].parse::<u64>().unwrap();
    Duration::from_millis(ticks * 10)
}
