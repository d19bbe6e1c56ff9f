//! Gumbel's law of greatest values, fitted by maximum likelihood: `F(x) = exp(-exp(-(x - mode)/scale))`.

use super::conditional::Posterior;
use super::error::{ExtremesError, check_probability, check_spread};
use super::interval::{Interval, IntervalMethod, by_profile};
use super::location_scale::{LocationScale, Offset};
use super::target::ExtremesTarget;
use crate::numerics::random::Random;
use crate::numerics::roots::Bracket;

/// Gumbel's law, the parameters of greatest likelihood.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GumbelFit {
    /// Mode, the most probable value, in the unit of the values.
    pub mode: f64,
    /// Scale, in the unit of the values.
    pub scale: f64,
    /// Values fitted.
    pub count: usize,
    /// Logarithm of the likelihood at the fit.
    pub log_likelihood: f64,
}

impl GumbelFit {
    /// Of two different values or more.
    ///
    /// The scale solves `s + sum(x e^(-x/s))/sum(e^(-x/s)) = mean(x)` (Johnson, Kotz and Balakrishnan, Continuous Univariate
    /// Distributions 2, eq. 22.53 f.). The left side rises with a slope of one or more from the least value on, so there is one
    /// root, between zero and mean less least value: Newton's method inside that bracket.
    ///
    /// # Errors
    /// Where values are fewer than two, not finite, or all the same.
    pub fn fit(values: &[f64]) -> Result<Self, ExtremesError> {
        let (low, high) = check_spread(values, 2)?;
        let range = high - low;
        let above: Vec<f64> = values.iter().map(|v| (v - low) / range).collect();
        let n = values.len() as f64;
        let mean = above.iter().sum::<f64>() / n;
        let scale = likely_scale(&above, mean);
        let sum: f64 = above.iter().map(|d| (-d / scale).exp()).sum();
        let mode = -scale * (sum / n).ln();
        // At the fit the sum of exp(-z) is n.
        let log_likelihood = -n * (scale * range).ln() - n * (mean - mode) / scale - n;
        Ok(Self {
            mode: low + range * mode,
            scale: range * scale,
            count: values.len(),
            log_likelihood,
        })
    }

    /// The figure asked for, in the unit of the values.
    ///
    /// # Errors
    /// Where its probability or its number of values is out of range.
    pub fn value(&self, target: ExtremesTarget) -> Result<f64, ExtremesError> {
        target.check()?;
        Ok(self.mode + self.scale * target.gumbel_offset())
    }

    /// The probability that a value stays below `x`.
    #[must_use]
    pub fn probability(&self, x: f64) -> f64 {
        (-(-(x - self.mode) / self.scale).exp()).exp()
    }

    /// A value drawn from the law.
    pub fn draw(&self, random: &mut Random) -> f64 {
        self.mode - self.scale * (-random.uniform().ln()).ln()
    }
}

/// The interval that holds a figure of the law of these values at a level of confidence, by the method asked for.
///
/// # Errors
/// Those of the fit; a level or target out of range; where the values do not bound the figure.
pub fn interval(
    values: &[f64],
    target: ExtremesTarget,
    level: f64,
    method: IntervalMethod,
) -> Result<Interval, ExtremesError> {
    target.check()?;
    check_probability("the level", level)?;
    let offset = Offset::Linear(target.gumbel_offset());
    let model = LocationScale::new(values.to_vec(), &offset)?;
    let estimate = model.value();
    let (low, high) = match method {
        IntervalMethod::Conditional => {
            let posterior = Posterior::new(values, &offset)?;
            let tail = 0.5 * (1.0 - level);
            (posterior.quantile(tail)?, posterior.quantile(1.0 - tail)?)
        }
        other => by_profile(&model, level, other)?,
    };
    Interval {
        estimate,
        low,
        high,
        level,
        method,
    }
    .checked()
}

/// The confidence with which a figure of the law of these values lies below a limit: exact over repeated samples, as the
/// conditional interval.
///
/// # Errors
/// Those of the fit; a target out of range; a limit that is no number.
pub fn confidence_below(
    values: &[f64],
    target: ExtremesTarget,
    limit: f64,
) -> Result<f64, ExtremesError> {
    target.check()?;
    super::error::check_finite(&[limit], 1)?;
    let offset = Offset::Linear(target.gumbel_offset());
    Ok(Posterior::new(values, &offset)?.below(limit))
}

/// The scale of greatest likelihood of values from 0 to 1.
fn likely_scale(above: &[f64], mean: f64) -> f64 {
    let mut bracket = Bracket {
        low: 0.0,
        high: mean,
    };
    // The scale by moments is a good start.
    let square = above.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / above.len() as f64;
    let mut scale = (0.78 * square.sqrt()).min(0.99 * mean);
    for _ in 0..200 {
        let (mut sum, mut first, mut second) = (0.0, 0.0, 0.0);
        for d in above {
            let weight = (-d / scale).exp();
            sum += weight;
            first += weight * d;
            second += weight * d * d;
        }
        let centre = first / sum;
        let value = scale - mean + centre;
        let slope = 1.0 + (second / sum - centre * centre).max(0.0) / (scale * scale);
        bracket.shrink(scale, value);
        let next = bracket.newton(scale, value, slope);
        if (next - scale).abs() <= 4.0 * f64::EPSILON * scale {
            return next;
        }
        scale = next;
    }
    scale
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(mode: f64, scale: f64) -> GumbelFit {
        GumbelFit {
            mode,
            scale,
            count: 0,
            log_likelihood: 0.0,
        }
    }

    fn sample(law: GumbelFit, count: usize, seed: u64) -> Vec<f64> {
        let mut random = Random::new(seed, 0);
        (0..count).map(|_| law.draw(&mut random)).collect()
    }

    #[test]
    fn finds_its_own_law() {
        let fit = GumbelFit::fit(&sample(law(5.0, 2.0), 20_000, 3)).unwrap();
        assert!((fit.mode - 5.0).abs() < 0.05 && (fit.scale - 2.0).abs() < 0.04);
        assert!(
            (fit.probability(fit.value(ExtremesTarget::quantile(0.9)).unwrap()) - 0.9).abs()
                < 1e-12
        );
        assert!((fit.value(ExtremesTarget::most_probable(1.0)).unwrap() - fit.mode).abs() < 1e-12);
    }

    /// The likelihood falls on all sides of the fit, and is the sum over the values.
    #[test]
    fn is_the_greatest_likelihood() {
        let values = sample(law(-40.0, 0.3), 25, 8);
        let fit = GumbelFit::fit(&values).unwrap();
        let likelihood = |mode: f64, scale: f64| -> f64 {
            let one = |x: &f64| {
                let z = (x - mode) / scale;
                -scale.ln() - z - (-z).exp()
            };
            values.iter().map(one).sum()
        };
        let best = likelihood(fit.mode, fit.scale);
        assert!((best - fit.log_likelihood).abs() < 1e-9);
        for (a, b) in [(1e-3, 0.0), (-1e-3, 0.0), (0.0, 1e-3), (0.0, -1e-3)] {
            assert!(likelihood(fit.mode + a, fit.scale + b) < best);
        }
    }

    #[test]
    fn follows_shift_and_scale() {
        let values = sample(law(0.0, 1.0), 12, 4);
        let fit = GumbelFit::fit(&values).unwrap();
        let moved: Vec<f64> = values.iter().map(|v| 1e6 + 1e-3 * v).collect();
        let other = GumbelFit::fit(&moved).unwrap();
        assert!((other.scale / fit.scale - 1e-3).abs() < 1e-9);
        assert!((other.mode - 1e6 - 1e-3 * fit.mode).abs() < 1e-8);
    }

    #[test]
    fn whatever_the_values_a_fit_or_an_error() {
        let mut random = Random::new(11, 0);
        for turn in 0..2000_u64 {
            let count = (random.uniform() * 6.0) as usize;
            let power = 10.0_f64.powf(600.0 * random.uniform() - 300.0);
            let mut values: Vec<f64> = (0..count)
                .map(|_| power * (random.uniform() - 0.5).powi(3))
                .collect();
            if turn % 7 == 0 && count > 1 {
                values[1] = values[0];
            }
            if turn % 11 == 0 && count > 0 {
                values[0] = [f64::NAN, f64::INFINITY, 1.7e308, 0.0][(turn % 4) as usize];
            }
            if let Ok(fit) = GumbelFit::fit(&values) {
                assert!(
                    fit.mode.is_finite() && fit.scale > 0.0 && fit.scale.is_finite(),
                    "{values:?}"
                );
                assert!(fit.log_likelihood.is_finite(), "{values:?}");
            }
        }
    }
}
