//! The times of the rows of a record.

/// Intervals that divide the duration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutputTimes {
    /// Their length \[s\].
    pub interval: f64,
    count: u64,
    duration: f64,
}

impl OutputTimes {
    /// For a run of this duration with rows at this interval \[s\], or the next to it that divides the duration.
    #[must_use]
    pub fn new(duration: f64, interval: f64) -> Self {
        const SAME: f64 = 1e-9;
        let count = (duration / interval).round().max(1.0);
        // A run that is resumed to a later time goes on with the same intervals to the bit, where both are whole numbers of them.
        let whole = (count * interval / duration - 1.0).abs() < SAME;
        Self {
            interval: if whole { interval } else { duration / count },
            count: count as u64,
            duration,
        }
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.count as usize + 1
    }

    /// The time of a row by its number, if it is not after `until` \[s\].
    pub(super) fn due(&self, number: u64, until: f64) -> Option<f64> {
        let time = if number == self.count {
            self.duration
        } else {
            number as f64 * self.interval
        };
        (number <= self.count && time <= until).then_some(time)
    }
}
