//! What is asked of a law: a quantile, the most probable or the expected greatest of a number of values.

use super::error::{ExtremesError, check_inside, check_probability};

/// Euler's constant.
pub(super) const EULER: f64 = 0.577_215_664_901_532_9;

/// Which figure of the greatest value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Statistic {
    /// The value that the greatest stays below with this probability, between 0 and 1.
    Quantile(f64),
    /// The most probable greatest value. Of Weibull and Pareto peaks the characteristic greatest, which one of so many peaks
    /// exceeds on average (DNV-RP-C205, 2.4.5: equal to the mode for many peaks).
    MostProbable,
    /// The mean of the greatest value.
    Expected,
}

/// A figure of the greatest of a number of independent values of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExtremesTarget {
    /// The figure.
    pub statistic: Statistic,
    /// The number of values, 1 or more and not necessarily whole: of hourly maxima the hours, of peaks the peaks in the time.
    pub greatest_of: f64,
}

impl ExtremesTarget {
    /// The quantile of a single value.
    #[must_use]
    pub const fn quantile(probability: f64) -> Self {
        Self::quantile_of_greatest(probability, 1.0)
    }

    /// The quantile of the greatest of `count` values.
    #[must_use]
    pub const fn quantile_of_greatest(probability: f64, count: f64) -> Self {
        Self {
            statistic: Statistic::Quantile(probability),
            greatest_of: count,
        }
    }

    /// The most probable greatest of `count` values.
    #[must_use]
    pub const fn most_probable(count: f64) -> Self {
        Self {
            statistic: Statistic::MostProbable,
            greatest_of: count,
        }
    }

    /// The expected greatest of `count` values.
    #[must_use]
    pub const fn expected(count: f64) -> Self {
        Self {
            statistic: Statistic::Expected,
            greatest_of: count,
        }
    }

    /// The return value: what one of `count` values exceeds on average.
    #[must_use]
    pub fn return_value(count: f64) -> Self {
        Self::quantile(1.0 - 1.0 / count)
    }

    pub(super) fn check(&self) -> Result<(), ExtremesError> {
        if let Statistic::Quantile(probability) = self.statistic {
            check_probability("the probability", probability)?;
        }
        let range = (1.0 - f64::EPSILON, 1e15);
        check_inside(
            "the number of values",
            self.greatest_of,
            range,
            "from 1 to 1e15",
        )
    }

    /// The same for peaks, whose characteristic greatest is defined above one peak.
    pub(super) fn check_for_peaks(&self) -> Result<(), ExtremesError> {
        self.check()?;
        if self.statistic == Statistic::MostProbable {
            let range = (1.0, f64::INFINITY);
            check_inside("the number of peaks", self.greatest_of, range, "above 1")?;
        }
        Ok(())
    }

    /// How many scales the figure lies above the mode of a Gumbel law.
    pub(super) fn gumbel_offset(&self) -> f64 {
        let many = self.greatest_of.ln();
        match self.statistic {
            Statistic::Quantile(probability) => many - (-probability.ln()).ln(),
            Statistic::MostProbable => many,
            Statistic::Expected => many + EULER,
        }
    }

    /// Logarithm of the probability that a single value exceeds the figure; `None` of the expected, which depends on the law.
    pub(super) fn ln_exceedance(&self) -> Option<f64> {
        match self.statistic {
            // The complement of p^(1/N).
            Statistic::Quantile(p) => Some((-(p.ln() / self.greatest_of).exp_m1()).ln()),
            Statistic::MostProbable => Some(-self.greatest_of.ln()),
            Statistic::Expected => None,
        }
    }
}

/// The law of the greatest of N standard exponential variables, as points with weights for means over it.
///
/// Trapezoidal rule in the logarithm of `N` times the exceedance probability, whose error falls exponentially with the step.
#[derive(Debug, Clone)]
pub(super) struct ExponentialMaximum {
    /// Logarithms of the weights, and of the greatest values.
    points: Vec<(f64, f64)>,
}

impl ExponentialMaximum {
    pub(super) fn of_count(count: f64) -> Self {
        // Down to -90: powers up to 30 of the greatest value have their mass above it.
        const STEP: f64 = 0.25;
        let point = |i: i32| {
            let s = 4.0 - STEP * f64::from(i);
            let cumulative = s.exp() / count;
            let greatest = if cumulative > 0.7 {
                -(-(-cumulative).exp()).ln_1p()
            } else {
                -(-(-cumulative).exp_m1()).ln()
            };
            (STEP.ln() + s - s.exp(), greatest.max(1e-300).ln())
        };
        Self {
            points: (0..376).map(point).collect(),
        }
    }

    /// Logarithm of the mean of the greatest value to a power, and its derivative with respect to the power.
    pub(super) fn ln_moment(&self, power: f64) -> (f64, f64) {
        // Terms are relative to the greatest so far; they rise and then fall, and end where they no longer count.
        let (mut most, mut sum, mut slope) = (f64::NEG_INFINITY, 0.0, 0.0);
        for (weight, ln_z) in &self.points {
            let log = weight + power * ln_z;
            if log > most {
                let shrink = (most - log).exp();
                (most, sum, slope) = (log, sum * shrink + 1.0, slope * shrink + ln_z);
            } else if log < most - 38.0 {
                break;
            } else {
                let part = (log - most).exp();
                sum += part;
                slope += part * ln_z;
            }
        }
        (most + sum.ln(), slope / sum)
    }

    /// The mean of a function of the greatest value.
    pub(super) fn mean(&self, f: impl Fn(f64) -> f64) -> f64 {
        let part = |(weight, ln_z): &(f64, f64)| weight.exp() * f(ln_z.exp());
        self.points.iter().map(part).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::super::special::ln_gamma;
    use super::*;

    #[test]
    fn moments_of_the_greatest_exponential() {
        let one = ExponentialMaximum::of_count(1.0);
        for power in [0.1, 0.5, 1.0, 2.0, 5.0, 20.0] {
            let exact = ln_gamma(1.0 + power);
            assert!((one.ln_moment(power).0 - exact).abs() < 1e-12, "{power}");
        }
        // The harmonic number of 1000.
        let harmonic: f64 = (1..=1000).map(|k| 1.0 / f64::from(k)).sum();
        let many = ExponentialMaximum::of_count(1000.0);
        assert!((many.ln_moment(1.0).0 - harmonic.ln()).abs() < 1e-13);
        assert!((many.mean(|z| z) - harmonic).abs() < 1e-12);
        let (h, slope) = (1e-5, many.ln_moment(0.5).1);
        let numeric = (many.ln_moment(0.5 + h).0 - many.ln_moment(0.5 - h).0) / (2.0 * h);
        assert!((slope - numeric).abs() < 1e-9);
    }

    #[test]
    fn exceedance_of_the_greatest() {
        let target = ExtremesTarget::quantile_of_greatest(0.5, 1e12);
        let exact = (2.0_f64.ln() / 1e12).ln();
        assert!((target.ln_exceedance().unwrap() - exact).abs() < 1e-10);
        assert!(
            ExtremesTarget::quantile(1.0).check().is_err()
                && ExtremesTarget::expected(0.5).check().is_err()
        );
        assert!(
            ExtremesTarget::most_probable(1.0)
                .check_for_peaks()
                .is_err()
        );
        assert_eq!(ExtremesTarget::most_probable(1.0).check(), Ok(()));
    }
}
