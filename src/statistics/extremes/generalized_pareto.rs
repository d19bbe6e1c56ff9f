//! The generalized Pareto law of peaks over a threshold, fitted by maximum likelihood:
//! `F(x) = 1 - (1 + shape (x - threshold)/scale)^(-1/shape)`.

use super::error::{ExtremesError, check_finite, check_probability};
use super::interval::{Interval, IntervalMethod, by_profile};
use super::pareto_likelihood::likely;
use super::pareto_profile::Excesses;
use super::pareto_sums::UnitExcesses;
use super::special::ln_gamma;
use super::target::{ExponentialMaximum, ExtremesTarget};
use crate::numerics::random::Random;

/// The generalized Pareto law, scale and shape of greatest likelihood above a given threshold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParetoFit {
    /// Threshold, in the unit of the values.
    pub threshold: f64,
    /// Scale, in the unit of the values.
    pub scale: f64,
    /// Shape: 0 the exponential law, negative with an upper end, positive with a heavy tail.
    pub shape: f64,
    /// Values fitted.
    pub count: usize,
    /// Logarithm of the likelihood at the fit.
    pub log_likelihood: f64,
}

impl ParetoFit {
    /// Of three peaks or more, all above the threshold.
    ///
    /// With the ratio `t = shape/scale` the shape is the mean of `ln(1 + t y)`, so the likelihood has one unknown (Grimshaw,
    /// Technometrics 35 (1993) 185). Its stationary points are bracketed on a grid of `ln(1 + t y_max)`, solved, and the
    /// greatest with a shape above -1 is taken.
    ///
    /// # Errors
    /// Where peaks are fewer than three, not finite or not above the threshold, and where the likelihood has no maximum with a
    /// shape from -1 to 5, as happens with few peaks.
    pub fn fit(peaks: &[f64], threshold: f64) -> Result<Self, ExtremesError> {
        Self::of_excesses(&UnitExcesses::new(&excesses(peaks, threshold)?), threshold)
    }

    /// The same of excesses over a threshold.
    pub(super) fn of_excesses(
        excesses: &UnitExcesses,
        threshold: f64,
    ) -> Result<Self, ExtremesError> {
        let (scale, shape) =
            likely(excesses).ok_or(ExtremesError::NoMaximum("generalized Pareto"))?;
        let scale = scale * excesses.greatest();
        Ok(Self {
            threshold,
            scale,
            shape,
            count: excesses.count(),
            log_likelihood: -(excesses.count() as f64) * (scale.ln() + shape + 1.0),
        })
    }

    /// The figure asked for, in the unit of the values.
    ///
    /// # Errors
    /// Where its probability or its number of values is out of range, and an expected value of a shape of one or above.
    pub fn value(&self, target: ExtremesTarget) -> Result<f64, ExtremesError> {
        target.check_for_peaks()?;
        let unit = UnitFigure::new(target).at(self.shape);
        if unit.is_finite() {
            Ok(self.threshold + self.scale * unit)
        } else {
            Err(ExtremesError::InfiniteMean(self.shape))
        }
    }

    /// The probability that a peak stays below `x`.
    #[must_use]
    pub fn probability(&self, x: f64) -> f64 {
        let above = ((x - self.threshold) / self.scale).max(0.0);
        let exponent = if self.shape.abs() < 1e-12 {
            above
        } else {
            (self.shape * above).max(-1.0).ln_1p() / self.shape
        };
        -(-exponent).exp_m1()
    }

    /// A peak drawn from the law.
    pub fn draw(&self, random: &mut Random) -> f64 {
        self.threshold + self.scale * growth(self.shape, -random.uniform().ln())
    }
}

/// The interval that holds a figure of the law of these peaks at a level of confidence. The conditional method does not apply:
/// the shape leaves no pivot.
///
/// # Errors
/// Those of the fit; a level or target out of range; where the peaks do not bound the figure.
pub fn interval(
    peaks: &[f64],
    threshold: f64,
    target: ExtremesTarget,
    level: f64,
    method: IntervalMethod,
) -> Result<Interval, ExtremesError> {
    check_probability("the level", level)?;
    let fit = ParetoFit::fit(peaks, threshold)?;
    let estimate = fit.value(target)?;
    let unit = UnitFigure::new(target);
    let model = Excesses::new(&excesses(peaks, threshold)?, fit, &unit);
    let (low, high) = by_profile(&model, level, method)?;
    Interval {
        estimate,
        low: threshold + low,
        high: threshold + high,
        level,
        method,
    }
    .checked()
}

/// `(e^(shape z) - 1)/shape`, which is `z` at shape zero.
pub(super) fn growth(shape: f64, z: f64) -> f64 {
    if (shape * z).abs() < 1e-9 {
        z * (1.0 + 0.5 * shape * z)
    } else {
        (shape * z).exp_m1() / shape
    }
}

/// A figure above the threshold over the scale, as a function of the shape.
#[derive(Debug, Clone)]
pub(super) struct UnitFigure {
    /// Logarithm of the exceedance probability of a quantile; `None` of the expected greatest.
    ln_exceedance: Option<f64>,
    count: f64,
    greatest: ExponentialMaximum,
}

impl UnitFigure {
    pub(super) fn new(target: ExtremesTarget) -> Self {
        Self {
            ln_exceedance: target.ln_exceedance(),
            count: target.greatest_of,
            greatest: ExponentialMaximum::of_count(target.greatest_of),
        }
    }

    /// At a shape; infinite for the mean of a shape of one or above.
    pub(super) fn at(&self, shape: f64) -> f64 {
        match self.ln_exceedance {
            Some(log) => growth(shape, -log),
            None if shape >= 1.0 => f64::INFINITY,
            // The mean of (1 - F)^-shape is a beta function; its logarithm cancels near shape zero.
            None if shape.abs() > 0.02 => {
                let n = self.count + 1.0;
                let log = ln_gamma(n) + ln_gamma(1.0 - shape) - ln_gamma(n - shape);
                log.exp_m1() / shape
            }
            None => self.greatest.mean(|z| growth(shape, z)),
        }
    }
}

fn excesses(peaks: &[f64], threshold: f64) -> Result<Vec<f64>, ExtremesError> {
    check_finite(&[threshold], 1)?;
    check_finite(peaks, 3)?;
    let above = |value: &f64| {
        let excess = value - threshold;
        if excess > 1e-290 && excess.is_finite() {
            Ok(excess)
        } else {
            let value = *value;
            Err(ExtremesError::NotAbove {
                value,
                location: threshold,
            })
        }
    };
    peaks.iter().map(above).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(scale: f64, shape: f64) -> ParetoFit {
        ParetoFit {
            threshold: 2.0,
            scale,
            shape,
            count: 0,
            log_likelihood: 0.0,
        }
    }

    fn sample(law: ParetoFit, count: usize, seed: u64) -> Vec<f64> {
        let mut random = Random::new(seed, 0);
        (0..count).map(|_| law.draw(&mut random)).collect()
    }

    #[test]
    fn finds_its_own_law() {
        for shape in [-0.3, 0.0, 0.25, 0.8] {
            let fit = ParetoFit::fit(&sample(law(1.5, shape), 20_000, 7), 2.0).unwrap();
            assert!((fit.shape - shape).abs() < 0.03, "{fit:?}");
            assert!((fit.scale - 1.5).abs() < 0.05, "{fit:?}");
        }
    }

    #[test]
    fn is_the_greatest_likelihood() {
        for (shape, seed) in [(-0.2, 1), (1e-7, 2), (0.3, 3)] {
            let peaks = sample(law(1.5, shape), 60, seed);
            let fit = ParetoFit::fit(&peaks, 2.0).unwrap();
            let likelihood = |scale: f64, shape: f64| -> f64 {
                let one = |x: &f64| {
                    let t = (shape * (x - 2.0) / scale).ln_1p();
                    -scale.ln() - (1.0 + 1.0 / shape) * t
                };
                peaks.iter().map(one).sum()
            };
            let best = likelihood(fit.scale, fit.shape);
            assert!((best - fit.log_likelihood).abs() < 1e-8, "{fit:?}");
            for (a, b) in [(1e-3, 0.0), (-1e-3, 0.0), (0.0, 1e-3), (0.0, -1e-3)] {
                assert!(likelihood(fit.scale + a, fit.shape + b) < best);
            }
        }
    }

    #[test]
    fn the_expected_greatest_is_smooth_across_shape_zero() {
        let unit = UnitFigure::new(ExtremesTarget::expected(300.0));
        for shape in [0.02, -0.02] {
            let (inside, outside) = (unit.at(shape), unit.at(shape * (1.0 + 1e-12)));
            assert!((inside / outside - 1.0).abs() < 1e-9);
        }
        // Of shape -1 the excesses are uniform: N/(N + 1).
        assert!((unit.at(-1.0) - 300.0 / 301.0).abs() < 1e-12);
    }

    #[test]
    fn whatever_the_peaks_a_fit_or_an_error() {
        let mut random = Random::new(3, 0);
        for turn in 0..400_u64 {
            let count = (random.uniform() * 12.0) as usize;
            let power = 10.0_f64.powf(500.0 * random.uniform() - 250.0);
            let mut peaks: Vec<f64> = (0..count)
                .map(|_| power * random.uniform().powi(4))
                .collect();
            if turn % 5 == 0 && count > 0 {
                peaks[0] = [f64::NAN, f64::INFINITY, 0.0, 1.7e308][(turn % 4) as usize];
            }
            if let Ok(fit) = ParetoFit::fit(&peaks, 0.0) {
                assert!(fit.scale > 0.0 && fit.scale.is_finite() && fit.log_likelihood.is_finite());
                assert!(
                    fit.value(ExtremesTarget::quantile(0.9))
                        .unwrap()
                        .is_finite()
                );
            }
        }
    }
}
