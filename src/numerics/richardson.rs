//! The error of a result from the same result of coarser runs.
//!
//! With an order p and a ratio r between the steps or meshes, the error of the finer of two results is about
//! `|fine - coarse| / (r^p - 1)` (Richardson), times a factor of safety (Roache 1994, doi 10.1115/1.2910291): 3 where the order is that
//! of the method, 1.25 where it is observed by the quotient of two differences. Pairs on several meshes and in several steps often show
//! another order than that of the method: there the factor and the constants below are those by which the errors of all shipped
//! cases lie inside as often as they must (`seacable laboratory bars`).

/// Factor of safety of an observed order that is that of the method.
pub const OBSERVED: f64 = 1.25;
/// The same of an observed order that is not that of the method.
pub const UNLIKE: f64 = 1.7;
/// The same of an order that is presumed.
pub const PRESUMED: f64 = 3.0;
/// The share of itself by which an order differs from that of the method where it is no longer like it: with what is usual among
/// the results of the run, and of a single result so near to it that it cannot be by chance.
const LIKE: f64 = 0.1;
const NEARLY: f64 = 0.03;
/// The least order observed.
const LEAST: f64 = 0.8;
/// Power of the quotient that is usual among the results of a run, below which that of a single result is by chance.
const SHARED: f64 = 0.6;
/// Power of the usual quotient in that by which the next difference should fall, where its own is greater.
const USUAL: f64 = 0.8;
/// By what part of that which it falls short of, a difference counts as greater: it may have passed through zero.
const CROSSING: f64 = 0.7;
/// By how much at most: a difference smaller still is not small by chance.
const CHANCE: f64 = 30.0;
/// Share of the value from which on results that do not approach each other are said not to be settled.
const NOTABLE: f64 = 0.032;

/// What is known of a family of results.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refinement {
    /// Step or segment of a coarser result by that of the next finer one.
    pub ratio: f64,
    /// The order of the method.
    pub order: f64,
}

impl Refinement {
    /// Error of a result from the next coarser one.
    pub fn presumed(&self, value: f64, coarse: f64) -> f64 {
        PRESUMED * (value - coarse).abs() / (self.ratio.powf(self.order) - 1.0).abs()
    }

    /// Error of a result by its difference from a coarser one and by the next difference further on, between runs coarser still.
    /// `usual` is the quotient of the two that is usual among the results of the run (see [`usual_quotient`]).
    pub fn observed(&self, [near, far]: [f64; 2], usual: f64) -> f64 {
        if near <= 0.0 {
            return 0.0;
        }
        let falls = self.ratio.powf(self.order);
        let usual = usual.clamp(self.ratio.powf(LEAST).min(falls), falls);
        let nearly = 1.0 - (self.off(far / near) / NEARLY).min(1.0);
        let by_order = OBSERVED * near / (falls - 1.0);
        nearly * by_order + (1.0 - nearly) * self.among_others([near, far], usual)
    }

    /// The error by differences whose quotient may be by chance, held against the usual one.
    fn among_others(&self, [near, far]: [f64; 2], usual: f64) -> f64 {
        let (own, falls) = (far / near, self.ratio.powf(self.order));
        let least = self.ratio.powf(LEAST).min(falls).max(usual.powf(SHARED));
        let unlike = (self.off(own).max(self.off(usual)) / LIKE).min(1.0);
        let safety = OBSERVED + unlike * (UNLIKE - OBSERVED);
        if own <= usual {
            return safety * near / (own.max(least) - 1.0);
        }
        let quotient = usual.powf(USUAL) * own.min(falls).powf(1.0 - USUAL);
        let short = far / quotient - near;
        let difference = (near + CROSSING * short).min(CHANCE * near);
        safety * difference / (quotient.max(least) - 1.0)
    }

    /// By what share of the method's order that of differences differs which fall by this quotient.
    fn off(&self, quotient: f64) -> f64 {
        let order = quotient.max(f64::MIN_POSITIVE).ln() / self.ratio.ln();
        (order / self.order - 1.0).abs()
    }
}

/// The median quotient of the differences `[near, far]` of results of these values; zero of none.
pub fn usual_quotient(results: impl Iterator<Item = (f64, [f64; 2])>) -> f64 {
    const ROUNDING: f64 = 1e-12;
    let quotient = |(value, [near, far]): (f64, [f64; 2])| {
        (far > ROUNDING * value.abs()).then(|| far / near.max(f64::MIN_POSITIVE))
    };
    let mut quotients: Vec<f64> = results.filter_map(quotient).collect();
    quotients.sort_by(f64::total_cmp);
    quotients.get(quotients.len() / 2).copied().unwrap_or(0.0)
}

/// Whether runs differ by a notable share of the value and do not approach each other.
pub fn is_unsettled(value: f64, [near, far]: [f64; 2]) -> bool {
    near > far && near > NOTABLE * value.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SECOND: Refinement = Refinement {
        ratio: 2.0,
        order: 2.0,
    };

    /// Differences between results `exact + 0.1 h^p` at h = 1, 2, 4.
    fn series(order: f64) -> [f64; 2] {
        let [fine, coarse, coarser] = [1.0_f64, 2.0, 4.0].map(|h| 0.1 * h.powf(order));
        [coarse - fine, coarser - coarse]
    }

    #[test]
    fn an_error_of_the_order_of_the_method_is_found_with_its_safety() {
        let [near, far] = series(2.0);
        let observed = SECOND.observed([near, far], 4.0);
        assert!((observed - OBSERVED * 0.1).abs() < 1e-12, "{observed}");
        let presumed = SECOND.presumed(5.1, 5.1 + near);
        assert!((presumed - PRESUMED * 0.1).abs() < 1e-12, "{presumed}");
    }

    #[test]
    fn a_lower_order_is_observed() {
        let error = SECOND.observed(series(1.0), 2.0);
        assert!((error - UNLIKE * 0.1).abs() < 1e-12, "{error}");
    }

    /// A difference that is a hundredth of what the next one lets expect counts as most of that.
    #[test]
    fn a_difference_that_is_small_by_chance_does_not_make_the_error_small() {
        let usual = SECOND.observed([0.1, 0.4], 4.0);
        let small = SECOND.observed([0.01, 0.4], 4.0);
        assert!(
            small > CROSSING * usual && small < UNLIKE / OBSERVED * usual,
            "{small}"
        );
        let error = SECOND.observed([1e-6, 0.4], 4.0);
        assert!((error - UNLIKE * CHANCE * 1e-6 / 3.0).abs() < 1e-12);
        assert_eq!(SECOND.observed([0.0, 0.0], 4.0), 0.0);
        assert_eq!(SECOND.observed([0.0, 0.4], 4.0), 0.0);
    }

    #[test]
    fn the_error_is_continuous_in_the_differences() {
        for usual in [0.0, 2.5, 4.0, 9.0] {
            let mut last = SECOND.observed([0.1, 1e-3], usual);
            for k in 1..120_000 {
                let far = 1e-3 * 1.0001_f64.powi(k);
                let error = SECOND.observed([0.1, far], usual);
                assert!((error / last - 1.0).abs() < 0.05, "{usual}: {far}");
                last = error;
            }
        }
    }

    #[test]
    fn the_usual_quotient_is_the_median() {
        let results = [
            (5.0, series(2.0)),
            (1.0, series(1.0)),
            (3.0, series(2.0)),
            (1.0, [0.0; 2]),
        ];
        assert!((usual_quotient(results.into_iter()) - 4.0).abs() < 1e-9);
        assert_eq!(usual_quotient(std::iter::empty()), 0.0);
    }

    #[test]
    fn results_that_drift_apart_are_not_settled() {
        assert!(is_unsettled(1.0, [0.1, 0.05]));
        assert!(!is_unsettled(1.0, [0.1, 0.3]));
        assert!(!is_unsettled(1.0, [0.001, 0.0]));
        let error = SECOND.observed([0.1, 0.05], 0.0);
        let slowest = 2.0_f64.powf(LEAST);
        assert!((error - UNLIKE * 0.1 / (slowest - 1.0)).abs() < 1e-12);
        let shared = SECOND.observed([0.1, 0.05], 4.0);
        let least = 4.0_f64.powf(SHARED);
        assert!((shared - UNLIKE * 0.1 / (least - 1.0)).abs() < 1e-12);
    }
}
