//! Periods of what swings.

/// Mean period between the first and the last time that a value rises through zero, by straight lines between steps.
#[derive(Default)]
pub(crate) struct Period {
    before: Option<(f64, f64)>,
    rises: Vec<f64>,
}

impl Period {
    pub(crate) fn see(&mut self, t: f64, value: f64) {
        if let Some((t0, v0)) = self.before
            && v0 < 0.0
            && value >= 0.0
        {
            self.rises.push(t0 + (t - t0) * v0 / (v0 - value));
        }
        self.before = Some((t, value));
    }

    pub(crate) fn mean(&self) -> f64 {
        let (first, last) = (self.rises[0], self.rises[self.rises.len() - 1]);
        (last - first) / (self.rises.len() - 1) as f64
    }
}
