//! Weibull's law of peaks above a given location, fitted by maximum likelihood: `F(x) = 1 - exp(-((x - location)/scale)^shape)`.
//!
//! `-ln(x - location)` has Gumbel's law of mode `-ln(scale)` and scale `1/shape`: fit and intervals are those of Gumbel's law.

use super::conditional::Posterior;
use super::error::{ExtremesError, check_finite, check_probability};
use super::gumbel::GumbelFit;
use super::interval::{Interval, IntervalMethod, by_profile};
use super::location_scale::{LocationScale, Offset};
use super::target::{ExponentialMaximum, ExtremesTarget};
use crate::numerics::random::Random;

/// Weibull's law, scale and shape of greatest likelihood above a given location.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeibullFit {
    /// Lower end of the law, in the unit of the values; zero makes it the law of two parameters.
    pub location: f64,
    /// Scale above the location, in the unit of the values.
    pub scale: f64,
    /// Shape: 1 the exponential law, 2 Rayleigh's.
    pub shape: f64,
    /// Values fitted.
    pub count: usize,
    /// Logarithm of the likelihood at the fit.
    pub log_likelihood: f64,
}

impl WeibullFit {
    /// Of two different values or more, all above the location. A location that the values themselves would fix has no greatest
    /// likelihood (Smith, Biometrika 72 (1985) 67), so it is given: zero, the mean of the record, a threshold.
    ///
    /// # Errors
    /// Where values are fewer than two, not finite, all the same, or not above the location.
    pub fn fit(values: &[f64], location: f64) -> Result<Self, ExtremesError> {
        let logs = negative_logs(values, location)?;
        let fit = GumbelFit::fit(&logs)?;
        Ok(Self {
            location,
            scale: (-fit.mode).exp(),
            shape: 1.0 / fit.scale,
            count: fit.count,
            log_likelihood: fit.log_likelihood + logs.iter().sum::<f64>(),
        })
    }

    /// The figure asked for, in the unit of the values.
    ///
    /// # Errors
    /// Where its probability or its number of values is out of range.
    pub fn value(&self, target: ExtremesTarget) -> Result<f64, ExtremesError> {
        target.check_for_peaks()?;
        let offset = offset(target).at(1.0 / self.shape).0;
        Ok(self.location + self.scale * (-offset).exp())
    }

    /// The probability that a value stays below `x`.
    #[must_use]
    pub fn probability(&self, x: f64) -> f64 {
        let above = ((x - self.location) / self.scale).max(0.0);
        -(-above.powf(self.shape)).exp_m1()
    }

    /// A value drawn from the law.
    pub fn draw(&self, random: &mut Random) -> f64 {
        self.location + self.scale * (-random.uniform().ln()).powf(1.0 / self.shape)
    }
}

/// The interval that holds a figure of the law of these values at a level of confidence, by the method asked for.
///
/// The conditional interval is exact for quantiles and the most probable greatest; for the expected greatest, whose logarithm is
/// not linear in the scale of the logarithms, its coverage is measured ([`coverage`](super::coverage)).
///
/// # Errors
/// Those of the fit; a level or target out of range; where the values do not bound the figure.
pub fn interval(
    values: &[f64],
    location: f64,
    target: ExtremesTarget,
    level: f64,
    method: IntervalMethod,
) -> Result<Interval, ExtremesError> {
    target.check_for_peaks()?;
    check_probability("the level", level)?;
    let logs = negative_logs(values, location)?;
    let offset = offset(target);
    let tail = 0.5 * (1.0 - level);
    let (high, low) = if method == IntervalMethod::Conditional {
        let posterior = Posterior::new(&logs, &offset)?;
        (posterior.quantile(tail)?, posterior.quantile(1.0 - tail)?)
    } else {
        let model = LocationScale::new(logs.clone(), &offset)?;
        by_profile(&model, level, method)?
    };
    let back = |log: f64| location + (-log).exp();
    Interval {
        estimate: back(LocationScale::new(logs, &offset)?.value()),
        low: back(low),
        high: back(high),
        level,
        method,
    }
    .checked()
}

/// Minus the logarithms of the values above the location.
fn negative_logs(values: &[f64], location: f64) -> Result<Vec<f64>, ExtremesError> {
    check_finite(&[location], 1)?;
    check_finite(values, 2)?;
    let log = |value: &f64| {
        let above = value - location;
        if above > 0.0 && above.is_finite() {
            Ok(-above.ln())
        } else {
            let value = *value;
            Err(ExtremesError::NotAbove { value, location })
        }
    };
    values.iter().map(log).collect()
}

/// Minus the logarithm of the figure, above the mode of minus the logarithms of the values.
fn offset(target: ExtremesTarget) -> Offset {
    match target.ln_exceedance() {
        Some(ln_exceedance) => Offset::Linear(-(-ln_exceedance).ln()),
        None => Offset::Expected(ExponentialMaximum::of_count(target.greatest_of)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::special::ln_gamma;
    use super::*;

    fn sample(location: f64, scale: f64, shape: f64, count: usize, seed: u64) -> Vec<f64> {
        let law = WeibullFit {
            location,
            scale,
            shape,
            count: 0,
            log_likelihood: 0.0,
        };
        let mut random = Random::new(seed, 0);
        (0..count).map(|_| law.draw(&mut random)).collect()
    }

    #[test]
    fn finds_its_own_law() {
        let fit = WeibullFit::fit(&sample(5.0, 3.0, 1.7, 20_000, 2), 5.0).unwrap();
        assert!((fit.scale - 3.0).abs() < 0.04 && (fit.shape - 1.7).abs() < 0.03);
        let mean = fit.value(ExtremesTarget::expected(1.0)).unwrap();
        let exact = 5.0 + fit.scale * ln_gamma(1.0 + 1.0 / fit.shape).exp();
        assert!((mean - exact).abs() < 1e-12);
        let thousand = fit.value(ExtremesTarget::most_probable(1000.0)).unwrap();
        assert!((fit.probability(thousand) - 0.999).abs() < 1e-12);
    }

    #[test]
    fn is_the_greatest_likelihood() {
        let values = sample(0.0, 3.0, 0.8, 30, 6);
        let fit = WeibullFit::fit(&values, 0.0).unwrap();
        let likelihood = |scale: f64, shape: f64| -> f64 {
            let one = |x: &f64| {
                let t = x / scale;
                (shape / scale).ln() + (shape - 1.0) * t.ln() - t.powf(shape)
            };
            values.iter().map(one).sum()
        };
        let best = likelihood(fit.scale, fit.shape);
        assert!((best - fit.log_likelihood).abs() < 1e-9);
        for (a, b) in [(1e-3, 0.0), (-1e-3, 0.0), (0.0, 1e-3), (0.0, -1e-3)] {
            assert!(likelihood(fit.scale + a, fit.shape + b) < best);
        }
    }

    /// The ends of the profile lie where the likelihood has fallen by half of 3.84.
    #[test]
    fn intervals_hold_their_estimate() {
        let values = sample(10.0, 1.0, 2.0, 40, 9);
        for target in [
            ExtremesTarget::quantile(0.9),
            ExtremesTarget::most_probable(500.0),
            ExtremesTarget::expected(500.0),
        ] {
            for method in [
                IntervalMethod::Conditional,
                IntervalMethod::ProfileLikelihood,
                IntervalMethod::Bartlett {
                    draws: 100,
                    seed: 1,
                },
            ] {
                let found = interval(&values, 10.0, target, 0.95, method).unwrap();
                assert!(
                    10.0 < found.low && found.low < found.estimate && found.estimate < found.high
                );
                assert!(found.high - found.low < 2.5, "{found:?}");
            }
        }
    }

    #[test]
    fn values_at_or_below_the_location_are_refused() {
        let refused = ExtremesError::NotAbove {
            value: 1.0,
            location: 1.0,
        };
        assert_eq!(WeibullFit::fit(&[2.0, 1.0], 1.0), Err(refused));
        assert!(WeibullFit::fit(&[2.0, 3.0], f64::NAN).is_err());
        assert!(WeibullFit::fit(&[2.0, 2.0], 0.0).is_err());
    }
}
