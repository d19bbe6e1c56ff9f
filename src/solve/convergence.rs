//! When Newton's iteration has converged: its displacement is small, or the next one would be, since convergence is quadratic.

/// Safety factor on the extrapolated displacement.
const SAFETY: f64 = 4.0;

/// One iteration watched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Convergence {
    tolerance: f64,
    /// Measured `|d1| / |d0|²` \[1/m\]; absent until two iterations were seen.
    rate: Option<f64>,
    before: Option<f64>,
    least: f64,
    idle: usize,
}

impl Convergence {
    /// Of an iteration with this tolerance \[m\], from the rate measured in those before \[1/m\].
    #[must_use]
    pub fn new(tolerance: f64, rate: Option<f64>) -> Self {
        Self {
            tolerance,
            rate,
            before: None,
            least: f64::INFINITY,
            idle: 0,
        }
    }

    /// Whether the iteration has converged with this displacement \[m\].
    pub fn is_reached(&mut self, moved: f64) -> bool {
        self.idle = if moved < 0.5 * self.least {
            0
        } else {
            self.idle + 1
        };
        self.least = self.least.min(moved);
        if let Some(last) = self.before {
            let rate = moved / (last * last);
            // The rate is that of the tail of the iteration, above rounding.
            if moved < 0.1 * last && moved > 1e-3 * self.tolerance {
                self.rate = Some(self.rate.map_or(rate, |c| rate.max(0.7 * c)));
            }
        }
        self.before = Some(moved);
        let next = self
            .rate
            .map_or(f64::INFINITY, |k| SAFETY * k * moved * moved);
        moved <= self.tolerance || next <= self.tolerance
    }

    /// Iterations in a row that did not halve the least displacement so far.
    #[must_use]
    pub fn idle(&self) -> usize {
        self.idle
    }

    /// The measured rate \[1/m\].
    #[must_use]
    pub fn rate(&self) -> Option<f64> {
        self.rate
    }
}
