//! The error of a result from the same result of coarser runs.
//!
//! With an order p and a ratio r between the steps or meshes, the error of the finer of two results is about
//! `|fine - coarse| / (r^p - 1)` (Richardson), times a factor of safety (Roache 1994, doi 10.1115/1.2910291): 1.25 where the
//! order is observed on three results, 3 where it is that of the method.

/// Factor of safety of an observed order, and of one that is presumed.
pub(crate) const OBSERVED: f64 = 1.25;
pub(crate) const PRESUMED: f64 = 3.0;
/// The least order observed.
const LEAST: f64 = 0.5;
/// Power of the quotient that is usual among the results of a run, below which that of a single result is by chance.
const SHARED: f64 = 0.42;
/// Share of the value from which on results that do not approach each other are said not to be settled.
const NOTABLE: f64 = 0.02;
/// By how much the difference between the two finer results counts as greater for what it falls short of the order of the method:
/// it may have passed through zero.
const CROSSING: f64 = 3.0;
/// By how much at most: a difference smaller still is not small by chance.
const CHANCE: f64 = 30.0;

/// What is known of a family of results.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Refinement {
    /// Step or segment of a coarser result by that of the next finer one.
    pub(crate) ratio: f64,
    /// The order of the method.
    pub(crate) order: f64,
}

impl Refinement {
    /// Error of a result from the next coarser one.
    pub(crate) fn presumed(&self, value: f64, coarse: f64) -> f64 {
        PRESUMED * (value - coarse).abs() / (self.ratio.powf(self.order) - 1.0).abs()
    }

    /// Error of a result from the two next coarser ones. `usual` is the quotient of their differences that is usual among the results
    /// of the run (see [`usual_quotient`]).
    pub(crate) fn observed(&self, [value, coarse, coarser]: [f64; 3], usual: f64) -> f64 {
        let (near, far) = ((value - coarse).abs(), (coarse - coarser).abs());
        let falls = self.ratio.powf(self.order);
        if far > falls * near {
            let short = far / falls - near;
            let difference = (near + CROSSING * short).min(CHANCE * near);
            return OBSERVED * difference / (falls - 1.0);
        }
        let least = self.ratio.powf(LEAST).max(usual.min(falls).powf(SHARED));
        let quotient = if far > least * near {
            far / near
        } else {
            least
        };
        OBSERVED * near / (quotient - 1.0)
    }
}

/// The median quotient of the differences between three results each; zero of none.
pub(crate) fn usual_quotient(results: impl Iterator<Item = [f64; 3]>) -> f64 {
    const ROUNDING: f64 = 1e-12;
    let quotient = |[value, coarse, coarser]: [f64; 3]| {
        let (near, far) = ((value - coarse).abs(), (coarse - coarser).abs());
        (far > ROUNDING * value.abs()).then(|| far / near.max(f64::MIN_POSITIVE))
    };
    let mut quotients: Vec<f64> = results.filter_map(quotient).collect();
    quotients.sort_by(f64::total_cmp);
    quotients.get(quotients.len() / 2).copied().unwrap_or(0.0)
}

/// Whether three results differ by a notable share of the finest and do not approach each other.
pub(crate) fn is_unsettled(value: f64, coarse: f64, coarser: f64) -> bool {
    let (near, far) = ((value - coarse).abs(), (coarse - coarser).abs());
    near > far && near > NOTABLE * value.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SECOND: Refinement = Refinement {
        ratio: 2.0,
        order: 2.0,
    };

    /// `exact + c h^p` at h = 1, 2, 4.
    fn series(exact: f64, order: f64) -> [f64; 3] {
        [1.0_f64, 2.0, 4.0].map(|h| exact + 0.1 * h.powf(order))
    }

    #[test]
    fn an_error_of_the_order_of_the_method_is_found_with_its_safety() {
        let [fine, coarse, coarser] = series(5.0, 2.0);
        let observed = SECOND.observed([fine, coarse, coarser], 0.0);
        assert!((observed - OBSERVED * 0.1).abs() < 1e-12, "{observed}");
        let presumed = SECOND.presumed(fine, coarse);
        assert!((presumed - PRESUMED * 0.1).abs() < 1e-12, "{presumed}");
    }

    #[test]
    fn a_lower_order_is_observed() {
        let [fine, coarse, coarser] = series(5.0, 1.0);
        let error = SECOND.observed([fine, coarse, coarser], 0.0);
        assert!((error - OBSERVED * 0.1).abs() < 1e-12, "{error}");
    }

    #[test]
    fn a_difference_that_is_small_by_chance_does_not_make_the_error_small() {
        let error = SECOND.observed([1.0, 1.02, 1.42], 0.0);
        assert!((error - OBSERVED * (0.02 + CROSSING * 0.08) / 3.0).abs() < 1e-12);
        let error = SECOND.observed([1.0, 1.0 + 1e-6, 1.4], 0.0);
        assert!((error - OBSERVED * CHANCE * 1e-6 / 3.0).abs() < 1e-12);
        let nearly = SECOND.observed([1.0, 1.1, 1.5001], 0.0);
        assert!((nearly - OBSERVED * 0.1 / 3.0).abs() < 1e-4, "continuous");
        assert_eq!(SECOND.observed([1.0, 1.0, 1.0], 0.0), 0.0);
    }

    #[test]
    fn the_usual_quotient_is_the_median() {
        let results = [
            series(5.0, 2.0),
            series(1.0, 1.0),
            series(3.0, 2.0),
            [1.0; 3],
        ];
        assert!((usual_quotient(results.into_iter()) - 4.0).abs() < 1e-9);
        assert_eq!(usual_quotient(std::iter::empty()), 0.0);
    }

    #[test]
    fn results_that_drift_apart_are_not_settled() {
        assert!(is_unsettled(1.0, 1.1, 1.15));
        assert!(!is_unsettled(1.0, 1.1, 1.4));
        assert!(!is_unsettled(1.0, 1.001, 1.001));
        let error = SECOND.observed([1.0, 1.1, 1.15], 0.0);
        assert!((error - OBSERVED * 0.1 / (2.0_f64.powf(LEAST) - 1.0)).abs() < 1e-12);
        let shared = SECOND.observed([1.0, 1.1, 1.15], 3.0);
        let quotient = 3.0_f64.powf(SHARED);
        assert!((shared - OBSERVED * 0.1 / (quotient - 1.0)).abs() < 1e-12);
    }
}
