//! Mean of an extreme over whole cycles, counted between upcrossings of the mean.

/// How far beyond the mean a value must come to have gone through it, as a share of the whole range: ripples about the mean
/// are no cycles.
const BAND: f64 = 0.1;

/// Mean, over all whole cycles, of the extreme that `pick` takes of each. A cycle goes from one rise through the mean to the
/// next.
#[derive(Debug)]
pub(super) struct Cycles {
    level: f64,
    band: f64,
    pick: fn(f64, f64) -> f64,
    below: bool,
    extreme: Option<f64>,
    sum: f64,
    whole: u32,
}

impl Cycles {
    /// For values with this mean and range.
    pub(super) fn new(level: f64, range: f64, pick: fn(f64, f64) -> f64) -> Self {
        Self {
            level,
            band: BAND * range,
            pick,
            below: false,
            extreme: None,
            sum: 0.0,
            whole: 0,
        }
    }

    /// Takes in a value.
    pub(super) fn add(&mut self, value: f64) {
        if value < self.level - self.band {
            self.below = true;
        } else if self.below && value > self.level + self.band {
            self.below = false;
            if let Some(whole) = self.extreme {
                self.sum += whole;
                self.whole += 1;
            }
            self.extreme = Some(value);
        }
        self.extreme = self.extreme.map(|e| (self.pick)(e, value));
    }

    /// The mean; nothing where there was no whole cycle.
    pub(super) fn mean(&self) -> Option<f64> {
        (self.whole > 0).then(|| self.sum / f64::from(self.whole))
    }
}
