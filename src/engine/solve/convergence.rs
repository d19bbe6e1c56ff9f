//! When Newton's iteration has converged: its displacement is small, or the next one would be, since convergence is quadratic.

use serde::{Deserialize, Serialize};

/// Safety factor on the extrapolated displacement.
const SAFETY: f64 = 4.0;

/// Two displacements in a row that shrink to this share are in the range of quadratic convergence.
const CONVERGES: f64 = 0.1;

/// Elsewhere a rate is believed down to this share of the displacement at which it was last measured. A far iteration that happens to
/// shrink tenfold is not in the range of quadratic convergence, and its rate says nothing of displacements a thousand times
/// smaller.
const REACH: f64 = 1e-2;

/// Displacements below this share of the tolerance are rounding, of which no rate can be measured.
const ROUNDING: f64 = 1e-3;

/// Where no rate was ever measured, since second displacements are rounding, they count as this share of the tolerance: a first
/// displacement up to five times as large as before needs no second one.
const LINEAR: f64 = 1e-2;

/// First displacements of up to so many tolerances may be those of a linear system. Greater ones may have passed a kink.
const NEAR: f64 = 100.0;

/// A rate of quadratic convergence.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ConvergenceRate {
    /// `|d1| / |d0|²` \[1/m\].
    pub per_m: f64,
    /// The `|d0|` of its last measurement \[m\].
    pub measured_at_m: f64,
    /// The system is linear up to rounding: the rate is a bound, and none was measured.
    #[serde(default)]
    pub is_bound: bool,
}

impl ConvergenceRate {
    /// The displacement after one of this size \[m\], with the safety factor.
    fn next(&self, moved: f64) -> f64 {
        SAFETY * self.per_m * moved * moved
    }

    /// Whether it says something of a first displacement of this size \[m\].
    fn reaches(&self, moved: f64) -> bool {
        moved >= REACH * self.measured_at_m
    }
}

/// One iteration watched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Convergence {
    tolerance: f64,
    /// Absent until two iterations were seen.
    rate: Option<ConvergenceRate>,
    before: Option<f64>,
    least: f64,
    idle: usize,
}

impl Convergence {
    /// Of an iteration with this tolerance \[m\], from the rate measured in those before.
    #[must_use]
    pub fn new(tolerance: f64, rate: Option<ConvergenceRate>) -> Self {
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
            self.measure(last, moved);
        }
        let converges = self.before.is_some_and(|last| moved < CONVERGES * last);
        let believed = |rate: &ConvergenceRate| converges || rate.reaches(moved);
        self.before = Some(moved);
        let next = self.rate.filter(believed);
        moved <= self.tolerance || next.is_some_and(|rate| rate.next(moved) <= self.tolerance)
    }

    /// Measures the rate in the tail of the iteration, from two displacements in a row \[m\].
    fn measure(&mut self, last: f64, moved: f64) {
        if moved >= CONVERGES * last {
            return;
        }
        let least = ROUNDING * self.tolerance;
        let per_m = moved.max(least) / (last * last);
        let known = self.rate.filter(|rate| !rate.is_bound);
        let (is_bound, believed) = match known.map(|rate| rate.per_m) {
            None if moved <= least && last > NEAR * self.tolerance => return,
            None if moved <= least => (true, LINEAR * self.tolerance / (last * last)),
            Some(known) if moved <= least => (false, per_m.max(known)),
            Some(known) => (false, per_m.max(0.7 * known)),
            None => (false, per_m),
        };
        self.rate = Some(ConvergenceRate {
            per_m: believed,
            measured_at_m: last,
            is_bound,
        });
    }

    /// Iterations in a row that did not halve the least displacement so far.
    #[must_use]
    pub fn idle(&self) -> usize {
        self.idle
    }

    /// The rate measured, or its bound.
    #[must_use]
    pub fn rate(&self) -> Option<ConvergenceRate> {
        self.rate
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLERANCE: f64 = 1e-5;

    /// An iteration with these displacements \[m\], and whether the last is taken for converged.
    fn ends(moves: &[f64], rate: Option<ConvergenceRate>) -> (bool, Option<ConvergenceRate>) {
        let mut iteration = Convergence::new(TOLERANCE, rate);
        let reached = moves.iter().map(|&moved| iteration.is_reached(moved));
        (reached.last().unwrap_or_default(), iteration.rate())
    }

    /// A rate measured at a kilometre once let a march take displacements of a decimetre for converged in every step: one
    /// iteration a step, which never measured it again.
    #[test]
    fn a_rate_measured_far_away_is_not_believed_near() {
        let (reached, far) = ends(&[2e4, 4e2], None);
        assert!(!reached && far.is_some());
        assert!(!ends(&[0.3], far).0);
        // Measured again where it is needed, it is believed there.
        let (_, near) = ends(&[1e-2, 1e-6], far);
        assert!(ends(&[1e-2], near).0);
        assert!(
            !ends(&[9e-5], near).0,
            "a hundredth of where it was measured"
        );
    }

    #[test]
    fn rounding_lowers_no_rate() {
        let rate = Some(ConvergenceRate {
            per_m: 0.04,
            measured_at_m: 1.0,
            is_bound: false,
        });
        let (reached, after) = ends(&[1e-1, 1e-12], rate);
        assert!(reached);
        assert_eq!(after.map(|rate| rate.per_m), Some(0.04));
        assert_eq!(after.map(|rate| rate.measured_at_m), Some(1e-1));
    }

    /// Every second displacement is rounding: a first one that is not much greater needs none.
    #[test]
    fn a_linear_system_needs_one_iteration() {
        assert_eq!(ends(&[1e-1, 1e-12], None), (true, None));
        let (_, bound) = ends(&[1e-4, 1e-12], None);
        assert!(bound.unwrap().is_bound);
        assert!(ends(&[4.9e-4], bound).0 && !ends(&[5.1e-4], bound).0);
        // It follows the displacements, and gives way to a rate that is measured.
        let (_, wider) = ends(&[1e-3, 1e-12], bound);
        assert!(ends(&[4.9e-3], wider).0);
        let (_, measured) = ends(&[1e-2, 1e-6], wider);
        let measured = measured.unwrap();
        assert!(!measured.is_bound && (measured.per_m - 1e-2).abs() < 1e-12);
    }

    #[test]
    fn a_rate_does_not_fall_by_one_lucky_iteration() {
        let rate = Some(ConvergenceRate {
            per_m: 1.0,
            measured_at_m: 1e-2,
            is_bound: false,
        });
        let (_, after) = ends(&[1e-2, 1e-6], rate);
        assert_eq!(after.map(|rate| rate.per_m), Some(0.7));
    }
}
