//! Exact intervals of laws with a location and a scale, given the configuration of the sample.
//!
//! The distribution of the pivots given the ancillary `(x - mode)/scale` of the sample is that of the parameters under the
//! density 1/scale (Fisher, Proc. R. Soc. A 144 (1934) 285; Lawless, Statistical Models and Methods for Lifetime Data, 2003,
//! section 5.2 and appendix E). Of Gumbel's law, `exp(mode/scale) sum(exp(-x/scale))` then has the gamma law of shape n whatever
//! the scale, so one integral over the scale is left:
//!
//! `P(mode + c scale < t) = integral of p(s) P(n, exp((t - c s)/s) sum(exp(-x/s))) ds`,
//! `p(s) ~ s^-n exp(-sum(x)/s) sum(exp(-x/s))^-n`.

use std::convert::Infallible;

use super::error::{ExtremesError, check_spread};
use super::gumbel::GumbelFit;
use super::location_scale::Offset;
use super::special::{incomplete_gamma_with, ln_gamma};
use crate::numerics::elementary::sum_exp;
use crate::numerics::roots::{Bracket, bisect, false_position};

/// Points of the integral over the scale by the trapezoidal rule, whose error falls exponentially where the density vanishes at
/// both ends: confidences to 1e-6, as a test with eight times as many holds.
const POINTS: u32 = 200;
/// Parts of the density below exp(-this) of its greatest are left out.
const NEGLIGIBLE: f64 = 40.0;

/// One scale of the integral.
#[derive(Debug, Clone, Copy)]
struct ScalePoint {
    weight: f64,
    scale: f64,
    /// Logarithm of the sum of exp(-x/scale).
    ln_sum: f64,
    offset: f64,
}

/// What a sample says about one figure of its law.
#[derive(Debug)]
pub(super) struct Posterior {
    points: Vec<ScalePoint>,
    count: f64,
    ln_gamma: f64,
    /// The figures are taken from the least value, over the range of values.
    low: f64,
    range: f64,
    estimate: f64,
    spread: f64,
}

impl Posterior {
    pub(super) fn new(values: &[f64], offset: &Offset) -> Result<Self, ExtremesError> {
        // The density of few values falls slowly to one side: its range is wide.
        let more = 1200 / values.len().max(1) as u32;
        Self::with_points(values, offset, POINTS + more)
    }

    fn with_points(values: &[f64], offset: &Offset, count: u32) -> Result<Self, ExtremesError> {
        let (low, high) = check_spread(values, 2)?;
        let range = high - low;
        let above: Vec<f64> = values.iter().map(|v| (v - low) / range).collect();
        let fit = GumbelFit::fit(&above)?;
        let scaled_offset = |scale: f64| offset.at(scale * range).0 / range;
        let points = points(&above, fit.scale, count, scaled_offset);
        let count = values.len() as f64;
        Ok(Self {
            points,
            count,
            ln_gamma: ln_gamma(count),
            low,
            range,
            estimate: fit.mode + scaled_offset(fit.scale),
            spread: fit.scale / count.sqrt(),
        })
    }

    /// The confidence that the figure lies below a limit.
    pub(super) fn below(&self, limit: f64) -> f64 {
        self.below_scaled((limit - self.low) / self.range)
    }

    fn below_scaled(&self, limit: f64) -> f64 {
        // Nine deviations of the gamma law, wider above where its tail is exponential: beyond, the confidence is 0 or 1.
        let deviation = self.count.sqrt();
        let most = self.count + 9.0 * deviation + 45.0;
        let part = |p: &ScalePoint| {
            let gamma = (p.ln_sum + (limit - p.offset) / p.scale).exp();
            if gamma > most {
                p.weight
            } else {
                p.weight * incomplete_gamma_with(self.count, self.ln_gamma, gamma).0
            }
        };
        self.points.iter().map(part).sum()
    }

    /// The limit below which the figure lies with a confidence.
    pub(super) fn quantile(&self, confidence: f64) -> Result<f64, ExtremesError> {
        // Confidences alike to 1e-11 are the same: the search ends there.
        let tolerance = 1e-11_f64.min(1e-6 * confidence.min(1.0 - confidence));
        let off = |limit: f64| settled(self.below_scaled(limit) - confidence, tolerance);
        let side = if off(self.estimate) < 0.0 { 1.0 } else { -1.0 };
        let mut reach = self.spread;
        while side * off(self.estimate + side * reach) < 0.0 {
            reach *= 2.0;
            if reach > 1e30 {
                return Err(ExtremesError::Unbounded);
            }
        }
        let bounds = (self.estimate, self.estimate + side * reach);
        let Ok(found) = false_position(bounds, |x| Ok::<_, Infallible>(off(x)));
        found
            .map(|x| self.low + self.range * x)
            .ok_or(ExtremesError::Unbounded)
    }
}

/// A difference, zero within a tolerance.
pub(super) fn settled(difference: f64, tolerance: f64) -> f64 {
    if difference.abs() <= tolerance {
        0.0
    } else {
        difference
    }
}

/// The scales of the integral with their weights, evenly spaced in the logarithm.
fn points(above: &[f64], likely: f64, count: u32, offset: impl Fn(f64) -> f64) -> Vec<ScalePoint> {
    let n = above.len() as f64;
    let total: f64 = above.iter().sum();
    let ln_sum = |scale: f64| sum_exp(above, -1.0 / scale).ln();
    // Of the logarithm of the scale, given that of the sum.
    let density_with = |log: f64, ln_sum: f64| (1.0 - n) * log - total / log.exp() - n * ln_sum;
    let density = |log: f64| density_with(log, ln_sum(log.exp()));
    let centre = likely.ln();
    let floor = density(centre) - NEGLIGIBLE;
    let end = |side: f64| {
        let mut reach = 1.0 / n.sqrt();
        while density(centre + side * reach) > floor {
            reach *= 2.0;
        }
        let bracket = Bracket {
            low: 0.0,
            high: reach,
        };
        let inside = |d: f64| density(centre + side * d) > floor;
        centre + side * bisect(bracket, 8, Bracket::middle, inside).high
    };
    let (first, last) = (end(-1.0), end(1.0));
    let mut points: Vec<ScalePoint> = (0..=count)
        .map(|i| first + (last - first) * f64::from(i) / f64::from(count))
        .map(|log| {
            let scale = log.exp();
            let ln_sum = ln_sum(scale);
            ScalePoint {
                weight: (density_with(log, ln_sum) - floor - NEGLIGIBLE).exp(),
                scale,
                ln_sum,
                offset: offset(scale),
            }
        })
        .collect();
    let sum: f64 = points.iter().map(|p| p.weight).sum();
    for point in &mut points {
        point.weight /= sum;
    }
    points.retain(|p| p.weight > 1e-15);
    points
}

#[cfg(test)]
mod tests {
    use super::super::interval::IntervalMethod;
    use super::super::target::ExtremesTarget;
    use super::*;
    use crate::numerics::random::Random;

    /// The pivot (mode - fit)/scale given the ancillary: over many samples the confidence is uniform.
    #[test]
    fn the_confidence_is_uniform_at_three_values() {
        let offset = Offset::Linear(ExtremesTarget::quantile(0.9).gumbel_offset());
        let truth = offset.at(2.0).0 + 7.0;
        let mut counts = [0_u32; 4];
        for draw in 0..800 {
            let mut random = Random::new(21, draw);
            let values: Vec<f64> = (0..3)
                .map(|_| 7.0 - 2.0 * (-random.uniform().ln()).ln())
                .collect();
            let confidence = Posterior::new(&values, &offset).unwrap().below(truth);
            counts[(4.0 * confidence) as usize] += 1;
        }
        // Chi-squared of three degrees of freedom: 11.3 at 99 %.
        let off: f64 = counts
            .iter()
            .map(|c| (f64::from(*c) - 200.0).powi(2) / 200.0)
            .sum();
        assert!(off < 11.3, "{counts:?}");
    }

    #[test]
    fn quantiles_are_where_the_confidence_says() {
        let values = [3.0, 3.5, 2.8, 4.4, 3.9];
        let offset = Offset::Linear(5.0);
        let posterior = Posterior::new(&values, &offset).unwrap();
        for confidence in [0.001, 0.025, 0.5, 0.975, 0.999] {
            let limit = posterior.quantile(confidence).unwrap();
            assert!((posterior.below(limit) - confidence).abs() < 1e-10);
        }
    }

    #[test]
    fn the_integral_has_converged() {
        let mut random = Random::new(8, 0);
        for count in [2, 3, 40] {
            let values: Vec<f64> = (0..count).map(|_| -(-random.uniform().ln()).ln()).collect();
            for scales in [0.0, 10.0] {
                let offset = Offset::Linear(scales);
                let few = Posterior::new(&values, &offset).unwrap();
                let many = Posterior::with_points(&values, &offset, 8 * (POINTS + 600)).unwrap();
                for confidence in [0.001, 0.5, 0.975] {
                    let limit = many.quantile(confidence).unwrap();
                    let off = (few.below(limit) - confidence).abs();
                    assert!(off < 1e-6, "{count} {scales} {confidence} {off}");
                }
            }
        }
    }

    #[test]
    fn agrees_with_the_profile_for_many_values() {
        let mut random = Random::new(5, 0);
        let values: Vec<f64> = (0..3000).map(|_| -(-random.uniform().ln()).ln()).collect();
        let of = |method| {
            super::super::gumbel::interval(&values, ExtremesTarget::quantile(0.9), 0.95, method)
                .unwrap()
        };
        let (exact, profile) = (
            of(IntervalMethod::Conditional),
            of(IntervalMethod::ProfileLikelihood),
        );
        let width = exact.high - exact.low;
        assert!((exact.low - profile.low).abs() < 0.02 * width);
        assert!((exact.high - profile.high).abs() < 0.02 * width);
    }
}
