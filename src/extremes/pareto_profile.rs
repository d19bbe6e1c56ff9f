//! The likelihood of the generalized Pareto law with one figure held.

use std::convert::Infallible;

use super::generalized_pareto::{ParetoFit, UnitFigure, growth};
use super::interval::Model;
use super::pareto_likelihood::SHAPES;
use crate::numerics::golden_section::golden_section;
use crate::numerics::random::Random;

/// Excesses over a threshold with their fit and the figure asked for, counted from the threshold.
#[derive(Debug, Clone)]
pub(super) struct Excesses<'a> {
    excesses: Vec<f64>,
    fit: ParetoFit,
    unit: &'a UnitFigure,
}

impl<'a> Excesses<'a> {
    pub(super) fn new(excesses: Vec<f64>, fit: ParetoFit, unit: &'a UnitFigure) -> Self {
        Self {
            excesses,
            fit,
            unit,
        }
    }

    /// Log-likelihood of a shape, with the scale that gives the figure; minus infinity where a peak lies above the upper end.
    fn likelihood(&self, figure: f64, shape: f64) -> f64 {
        let scale = figure / self.unit.at(shape);
        if scale <= 0.0 || scale.is_nan() {
            return f64::NEG_INFINITY;
        }
        let n = self.excesses.len() as f64;
        let mut sum = 0.0;
        for y in &self.excesses {
            let t = shape * y / scale;
            if t <= -1.0 {
                return f64::NEG_INFINITY;
            }
            sum += if t.abs() < 1e-9 {
                y / scale * (1.0 - 0.5 * t)
            } else {
                t.ln_1p() / shape
            };
        }
        -n * scale.ln() - (1.0 + shape) * sum
    }
}

/// Shapes tried for the greatest likelihood before it is refined.
const GRID: u32 = 48;

impl Model for Excesses<'_> {
    fn estimate(&self) -> f64 {
        self.fit.scale * self.unit.at(self.fit.shape)
    }

    fn spread(&self) -> f64 {
        self.estimate() / (self.fit.count as f64).sqrt()
    }

    fn deviance(&self, value: f64) -> f64 {
        if value <= 0.0 {
            return f64::INFINITY;
        }
        // Even steps of the square root above -1: dense where the likelihood ends abruptly.
        let width = (SHAPES.1 - SHAPES.0).sqrt();
        let shape = |i: f64| SHAPES.0 + (width * i / f64::from(GRID)).powi(2);
        let of = |i: f64| self.likelihood(value, shape(i));
        let best = (0..=GRID).map(|i| (f64::from(i), of(f64::from(i)))).fold(
            (0.0, f64::NEG_INFINITY),
            |best, next| {
                if next.1 > best.1 { next } else { best }
            },
        );
        let bounds = ((best.0 - 1.0).max(0.0), (best.0 + 1.0).min(f64::from(GRID)));
        let Ok(refined) = golden_section(bounds, 1e-9, 40, |i| Ok::<_, Infallible>(-of(i)));
        let most = of(refined).max(best.1);
        (2.0 * (self.fit.log_likelihood - most)).max(0.0)
    }

    fn redraw(&self, random: &mut Random) -> Option<Self> {
        let draw = |_: &f64| self.fit.scale * growth(self.fit.shape, -random.uniform().ln());
        let excesses: Vec<f64> = self.excesses.iter().map(draw).collect();
        let fit = ParetoFit::fit(&excesses, 0.0).ok()?;
        let other = Self::new(excesses, fit, self.unit);
        other.estimate().is_finite().then_some(other)
    }
}

#[cfg(test)]
mod tests {
    use super::super::generalized_pareto::interval;
    use super::super::interval::IntervalMethod;
    use super::super::target::Target;
    use super::*;

    fn peaks(count: u64) -> Vec<f64> {
        let mut random = Random::new(count, 4);
        (0..count)
            .map(|_| 2.0 + growth(-0.1, -random.uniform().ln()))
            .collect()
    }

    #[test]
    fn the_deviance_is_least_at_the_estimate() {
        let peaks = peaks(80);
        let fit = ParetoFit::fit(&peaks, 2.0).unwrap();
        for target in [Target::quantile(0.9), Target::expected(1000.0)] {
            let unit = UnitFigure::new(target);
            let above = peaks.iter().map(|p| p - 2.0).collect();
            let model = Excesses::new(above, fit, &unit);
            let at = model.estimate();
            assert!(model.deviance(at) < 1e-7, "{}", model.deviance(at));
            assert!(model.deviance(1.2 * at) > 0.1 && model.deviance(0.8 * at) > 0.1);
            assert_eq!(model.deviance(-1.0), f64::INFINITY);
        }
    }

    #[test]
    fn intervals_hold_their_estimate() {
        let peaks = peaks(80);
        for method in [
            IntervalMethod::ProfileLikelihood,
            IntervalMethod::Bartlett { draws: 50, seed: 1 },
            IntervalMethod::BiasCorrected {
                draws: 200,
                seed: 1,
            },
        ] {
            let found = interval(&peaks, 2.0, Target::quantile(0.99), 0.95, method).unwrap();
            assert!(found.low > 4.0 && found.low < found.estimate, "{found:?}");
            assert!(
                found.estimate < found.high && found.high < 12.0,
                "{found:?}"
            );
        }
        let refused = interval(
            &peaks,
            2.0,
            Target::quantile(0.9),
            0.95,
            IntervalMethod::Conditional,
        );
        assert!(refused.is_err());
    }
}
