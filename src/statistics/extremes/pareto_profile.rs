//! The likelihood of the generalized Pareto law with one figure held.

use std::convert::Infallible;

use super::generalized_pareto::{ParetoFit, UnitFigure, growth};
use super::interval::Model;
use super::pareto_likelihood::SHAPES;
use super::pareto_sums::UnitExcesses;
use crate::numerics::minimum::{Middle, parabolic_minimum};
use crate::numerics::random::Random;

/// Excesses over a threshold with their fit and the figure asked for, counted from the threshold.
#[derive(Debug, Clone)]
pub(super) struct Excesses<'a> {
    excesses: UnitExcesses,
    fit: ParetoFit,
    unit: &'a UnitFigure,
    /// The figure over the scale at the shapes of the grid.
    grid: Vec<f64>,
}

impl<'a> Excesses<'a> {
    pub(super) fn new(excesses: &[f64], fit: ParetoFit, unit: &'a UnitFigure) -> Self {
        let places = (0..=GRID).map(|i| unit.at(shape(f64::from(i))));
        Self {
            excesses: UnitExcesses::new(excesses),
            fit,
            unit,
            grid: places.collect(),
        }
    }

    /// Log-likelihood of a shape, with the scale that gives the figure, which is `unit` scales; minus infinity where a peak lies
    /// above the upper end.
    fn likelihood(&self, figure: f64, shape: f64, unit: f64) -> f64 {
        let scale = figure / unit;
        let greatest = self.excesses.greatest();
        let ratio = shape * (greatest / scale);
        if scale <= 0.0 || scale.is_nan() || ratio <= -1.0 || !ratio.is_finite() {
            return f64::NEG_INFINITY;
        }
        // The mean of ln(1 + shape y/scale)/shape.
        let mean = self.excesses.means(ratio).scale * (greatest / scale);
        -(self.excesses.count() as f64) * (scale.ln() + (1.0 + shape) * mean)
    }
}

/// Shapes tried for the greatest likelihood before it is refined.
const GRID: u32 = 48;

/// The shape at a place of the grid: even steps of the square root above -1, dense where the likelihood ends abruptly.
fn shape(place: f64) -> f64 {
    let width = (SHAPES.1 - SHAPES.0).sqrt();
    SHAPES.0 + (width * place / f64::from(GRID)).powi(2)
}

/// How near to the greatest likelihood a place of the grid is refined: by the square of it, of the likelihood nothing is left.
const REFINED: f64 = 1e-7;

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
        let fall = |place: f64, unit: f64| -self.likelihood(value, shape(place), unit);
        let places = (0..=GRID).map(f64::from);
        let values: Vec<f64> = places.zip(&self.grid).map(|(i, u)| fall(i, *u)).collect();
        let least = (0..values.len()).fold(0, |best, i| match values[i] < values[best] {
            true => i,
            false => best,
        });
        let ends = [least.saturating_sub(1), (least + 1).min(values.len() - 1)];
        let bracket = Middle {
            ends: ends.map(|end| (end as f64, values[end])),
            middle: (least as f64, values[least]),
        };
        let refined = |place: f64| Ok::<_, Infallible>(fall(place, self.unit.at(shape(place))));
        let Ok((_, least)) = parabolic_minimum(bracket, REFINED, 60, refined);
        (2.0 * (self.fit.log_likelihood + least)).max(0.0)
    }

    fn redraw(&self, random: &mut Random) -> Option<Self> {
        let draw = |_| self.fit.scale * growth(self.fit.shape, -random.uniform().ln());
        let excesses: Vec<f64> = (0..self.excesses.count()).map(draw).collect();
        let fit = ParetoFit::fit(&excesses, 0.0).ok()?;
        let other = Self {
            excesses: UnitExcesses::new(&excesses),
            fit,
            unit: self.unit,
            grid: self.grid.clone(),
        };
        other.estimate().is_finite().then_some(other)
    }
}

#[cfg(test)]
mod tests {
    use super::super::generalized_pareto::interval;
    use super::super::interval::IntervalMethod;
    use super::super::target::ExtremesTarget;
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
        for target in [
            ExtremesTarget::quantile(0.9),
            ExtremesTarget::expected(1000.0),
        ] {
            let unit = UnitFigure::new(target);
            let above: Vec<f64> = peaks.iter().map(|p| p - 2.0).collect();
            let model = Excesses::new(&above, fit, &unit);
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
        ] {
            let found =
                interval(&peaks, 2.0, ExtremesTarget::quantile(0.99), 0.95, method).unwrap();
            assert!(found.low > 4.0 && found.low < found.estimate, "{found:?}");
            assert!(
                found.estimate < found.high && found.high < 12.0,
                "{found:?}"
            );
        }
        let refused = interval(
            &peaks,
            2.0,
            ExtremesTarget::quantile(0.9),
            0.95,
            IntervalMethod::Conditional,
        );
        assert!(refused.is_err());
    }
}
