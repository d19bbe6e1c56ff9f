//! The likelihood of the generalized Pareto law as a function of shape over scale alone.
//!
//! At a ratio `t` the scale of greatest likelihood is the mean of `ln(1 + t y)/t` and the shape `t` times that (Grimshaw, Technometrics 35 (1993)
//! 185, not verified), so the log-likelihood a value is `-ln(scale) - shape`. Its derivative is the difference of two functions: minus that of `ln(scale)`
//! and that of the shape. Both are positive and fall with `t`: the scale is the integral of `y/(1 + s t y)` over s from 0 to 1, completely monotone
//! and so convex in its logarithm; the derivative of the shape is the mean of `y/(1 + t y)`. So the sign between two ratios is often known
//! from these functions at both, and most points of the grid on which maxima are sought need no sums.

use std::convert::Infallible;

use super::pareto_sums::{Means, UnitExcesses};
use crate::numerics::roots::false_position;

/// Shapes of a fit; below -1 the likelihood has no bound.
pub(super) const SHAPES: (f64, f64) = (-1.0, 5.0);

/// The grid of `u = ln(1 + t)`: its first point, its step, its last number and that of ratio zero.
const FIRST: f64 = -36.0;
const STEP: f64 = 0.25;
const LAST: u32 = 240;
const ZERO: u32 = 144;

/// What rounding may be of what signs are judged by.
const ROUNDING: f64 = 1e-9;

/// A relative difference of both functions that is none: a root is found to as much.
const SETTLED: f64 = 1e-14;

/// A point of the grid.
#[derive(Debug, Clone, Copy)]
struct GridPoint {
    number: u32,
    means: Means,
}

impl GridPoint {
    fn of_number(excesses: &UnitExcesses, number: u32) -> Self {
        Self {
            number,
            means: excesses.means(at(number).exp_m1()),
        }
    }

    /// Whether the likelihood rises with the ratio.
    fn rises(&self) -> bool {
        self.means.fall > self.means.rise
    }
}

/// `ln(1 + t)` at a point of the grid.
fn at(number: u32) -> f64 {
    FIRST + STEP * f64::from(number)
}

/// Whether the likelihood cannot have a maximum between two points: none with a shape that is allowed, which grows with the ratio, or
/// none since it rises or falls all the way.
fn is_monotone(from: &GridPoint, to: &GridPoint) -> bool {
    let (a, b) = (&from.means, &to.means);
    if b.log <= SHAPES.0 || a.log >= SHAPES.1 {
        return true;
    }
    // Grimshaw's equation: the derivative has the sign of s (1 + shape) - 1, s the mean of 1/(1 + t y), which falls.
    match (from.rises(), to.rises()) {
        (true, true) => {
            b.inverse * (1.0 + a.log) > 1.0 + ROUNDING || b.fall > a.rise * (1.0 + ROUNDING)
        }
        (false, false) => {
            a.inverse * (1.0 + b.log) < 1.0 - ROUNDING || a.fall < b.rise * (1.0 - ROUNDING)
        }
        _ => false,
    }
}

/// The maxima that the grid shows: pairs of neighbours with a rise at the first and none at the second.
fn maxima(excesses: &UnitExcesses, from: GridPoint, to: GridPoint, found: &mut Vec<(f64, f64)>) {
    if is_monotone(&from, &to) {
        return;
    }
    if to.number - from.number == 1 {
        if from.rises() && !to.rises() {
            found.push((at(from.number), at(to.number)));
        }
        return;
    }
    let middle = GridPoint::of_number(excesses, from.number.midpoint(to.number));
    maxima(excesses, from, middle, found);
    maxima(excesses, middle, to, found);
}

/// Scale, over the greatest excess, and shape of greatest likelihood.
pub(super) fn likely(excesses: &UnitExcesses) -> Option<(f64, f64)> {
    let mut brackets = Vec::new();
    let [first, zero, last] = [0, ZERO, LAST].map(|number| GridPoint::of_number(excesses, number));
    maxima(excesses, first, zero, &mut brackets);
    maxima(excesses, zero, last, &mut brackets);
    let excess_of_fall = |u: f64| {
        let means = excesses.means(u.exp_m1());
        let difference = means.fall / means.rise - 1.0;
        Ok::<_, Infallible>(if difference.abs() < SETTLED {
            0.0
        } else {
            difference
        })
    };
    let mut best: Option<(f64, Means)> = None;
    for bracket in brackets {
        let Ok(root) = false_position(bracket, excess_of_fall);
        let means = excesses.means(root?.exp_m1());
        let likelihood = -means.scale.ln() - means.log;
        let allowed = means.log > SHAPES.0 && means.log < SHAPES.1;
        if allowed && best.is_none_or(|(most, _)| likelihood > most) {
            best = Some((likelihood, means));
        }
    }
    best.map(|(_, means)| (means.scale, means.log))
}

#[cfg(test)]
mod tests {
    use super::super::generalized_pareto::growth;
    use super::*;
    use crate::numerics::random::Random;

    /// Uniform excesses have their greatest likelihood at the edge: there is none inside.
    #[test]
    fn no_maximum_at_the_edge() {
        let even: Vec<f64> = (1..=20).map(|k| f64::from(k) / 20.0).collect();
        assert_eq!(likely(&UnitExcesses::new(&even)), None);
    }

    /// Points that are left out because the likelihood is monotone hide no maximum.
    #[test]
    fn the_maxima_are_those_of_all_points() {
        let mut random = Random::new(5, 0);
        let mut several = 0;
        for turn in 0..400_u32 {
            let count = 3 + turn as usize % 60;
            let shape = random.between(-1.2, 2.0);
            let mut excesses: Vec<f64> = (0..count)
                .map(|_| growth(shape, -random.uniform().ln()))
                .collect();
            // Clusters far apart, whose likelihood may have two maxima.
            if turn % 3 == 0 {
                let factor = random.power(-6.0, 0.0);
                excesses.iter_mut().step_by(2).for_each(|y| *y *= factor);
            }
            let excesses = UnitExcesses::new(&excesses);
            let points: Vec<GridPoint> = (0..=LAST)
                .map(|k| GridPoint::of_number(&excesses, k))
                .collect();
            let mut found = Vec::new();
            maxima(&excesses, points[0], points[ZERO as usize], &mut found);
            let last = points[LAST as usize];
            maxima(&excesses, points[ZERO as usize], last, &mut found);
            let is_allowed =
                |pair: &&[GridPoint]| pair[1].means.log > SHAPES.0 && pair[0].means.log < SHAPES.1;
            let all: Vec<(f64, f64)> = points
                .windows(2)
                .filter(|pair| pair[0].rises() && !pair[1].rises())
                .filter(is_allowed)
                .map(|pair| (at(pair[0].number), at(pair[1].number)))
                .collect();
            assert_eq!(found, all, "{turn}");
            several += usize::from(all.len() > 1);
        }
        assert!(several > 0);
    }
}
