//! How well a generalized Pareto law fits peaks: the Anderson-Darling distance, with its probability by simulation.

use super::generalized_pareto::{ParetoFit, growth};
use super::pareto_sums::UnitExcesses;
use crate::numerics::elementary::{exp_m1_each, ln_1p_each, ln_each};
use crate::numerics::random::Random;

/// The least probability of a peak below and above it; a peak at the end of the law would have none.
const LEAST: f64 = 1e-15;

/// Probabilities whose logarithms are taken together: as products, the least of them to the power of fifteen, which does not underflow.
const TOGETHER: usize = 6;

/// Distance of excesses in ascending order from a law of a scale and a shape: `-n - mean((2 i - 1)(ln F_i + ln(1 - F_(n+1-i))))` (Anderson and
/// Darling 1954).
#[must_use]
pub(super) fn distance(ascending: &[f64], scale: f64, shape: f64) -> f64 {
    let most = -LEAST.ln();
    let n = ascending.len() as f64;
    let mut exponents = exponents(ascending, scale, shape);
    let mut sum = 0.0;
    for (i, exponent) in exponents.iter_mut().enumerate() {
        *exponent = -exponent.min(most);
        sum += (2.0 * (n - i as f64) - 1.0) * *exponent;
    }
    exp_m1_each(&mut exponents);
    let mut weight = 1.0;
    for part in exponents.chunks(TOGETHER) {
        let mut below = [1.0; TOGETHER];
        for (below, exponential) in below.iter_mut().zip(part) {
            *below = (-exponential).max(LEAST);
        }
        sum += weighted_logs(&below, weight);
        weight += 2.0 * TOGETHER as f64;
    }
    -n - sum / n
}

/// Minus the logarithms of the probabilities of greater excesses: `ln(1 + shape y/scale)/shape`.
fn exponents(excesses: &[f64], scale: f64, shape: f64) -> Vec<f64> {
    if shape.abs() < 1e-12 {
        return excesses.iter().map(|y| y / scale).collect();
    }
    // An excess at the upper end has the least probability, whatever the shape.
    let least = -1.0 + 0.5 * f64::EPSILON;
    let scaled = excesses.iter().map(|y| (shape * y / scale).max(least));
    let mut exponents: Vec<f64> = scaled.collect();
    ln_1p_each(&mut exponents);
    for exponent in &mut exponents {
        *exponent /= shape;
    }
    exponents
}

/// The sum of `(weight + 2 i) ln f_i`, i from zero on.
fn weighted_logs(factors: &[f64; TOGETHER], weight: f64) -> f64 {
    let (mut product, mut powers) = (1.0, 1.0);
    for factor in factors[1..].iter().rev() {
        product *= factor;
        powers *= product;
    }
    weight * (factors[0] * product).ln() + 2.0 * powers.ln()
}

/// One draw of the simulation: variables of the standard exponential law in ascending order, each with its place in the order drawn.
///
/// The variables of a draw are the first of one stream of random numbers, whatever their number: fewer are a part of more.
#[derive(Debug)]
pub(super) struct ExponentialDraw {
    values: Vec<f64>,
    places: Vec<u32>,
}

impl ExponentialDraw {
    pub(super) fn new(seed: u64, draw: u64, count: usize) -> Self {
        let mut random = Random::new(seed, draw);
        let uniform: Vec<f64> = (0..count).map(|_| random.uniform()).collect();
        // The greatest uniform numbers are the least exponential ones; in even parts, of which each holds about one.
        let part = |u: f64| ((1.0 - u) * count as f64) as usize;
        let mut ends = vec![0_usize; count + 1];
        for u in &uniform {
            ends[part(*u).min(count)] += 1;
        }
        let mut sum = 0;
        for end in &mut ends {
            sum += *end;
            *end = sum - *end;
        }
        let mut ordered = vec![(0.0, 0_u32); count];
        for (place, u) in uniform.iter().enumerate() {
            let end = &mut ends[part(*u).min(count)];
            ordered[*end] = (*u, place as u32);
            *end += 1;
        }
        // Within a part by insertion.
        for i in 1..count {
            let mut k = i;
            while k > 0 && ordered[k - 1].0 < ordered[k].0 {
                ordered.swap(k - 1, k);
                k -= 1;
            }
        }
        let (mut values, places): (Vec<f64>, Vec<u32>) = ordered.into_iter().unzip();
        ln_each(&mut values);
        for value in &mut values {
            *value = -*value;
        }
        Self { values, places }
    }

    /// Keeps the first so many in the order drawn.
    pub(super) fn keep(&mut self, count: usize) {
        let mut kept = 0;
        for i in 0..self.values.len() {
            let place = self.places[i];
            (self.values[kept], self.places[kept]) = (self.values[i], place);
            kept += usize::from((place as usize) < count);
        }
        self.values.truncate(kept);
        self.places.truncate(kept);
    }

    /// Excesses of these variables under a law of a scale of one, in ascending order.
    fn excesses(&self, shape: f64) -> Vec<f64> {
        if shape.abs() < 1e-9 {
            return self.values.iter().map(|z| growth(shape, *z)).collect();
        }
        let mut excesses: Vec<f64> = self.values.iter().map(|z| shape * z).collect();
        exp_m1_each(&mut excesses);
        for excess in &mut excesses {
            *excess /= shape;
        }
        excesses
    }
}

/// The probability of a distance from a fit by samples of the fitted law that are fitted themselves: the share of those that lie as far from
/// their fit, with both parameters estimated (Stute, Gonzalez Manteiga and Presedo Quindimil, Metrika 40 (1993) 243). Samples are added one by one;
/// the share of them all is known between two bounds.
#[derive(Debug, Clone)]
pub(super) struct Simulation {
    shape: f64,
    distance: f64,
    /// Samples drawn, those with a fit, and those as far from it.
    drawn: u32,
    fitted: u32,
    over: u32,
}

impl Simulation {
    /// Of a fit at a distance.
    pub(super) fn new(fit: &ParetoFit, distance: f64) -> Self {
        Self {
            shape: fit.shape,
            distance,
            drawn: 0,
            fitted: 0,
            over: 0,
        }
    }

    /// Adds a sample, of as many variables as values were fitted. The distance does not depend on the scale.
    pub(super) fn add(&mut self, draw: &ExponentialDraw) {
        let excesses = draw.excesses(self.shape);
        self.drawn += 1;
        if let Ok(fit) = ParetoFit::of_excesses(&UnitExcesses::new(&excesses), 0.0) {
            self.fitted += 1;
            let found = distance(&excesses, fit.scale, fit.shape);
            self.over += u32::from(found >= self.distance);
        }
    }

    /// Whether a sample has a fit.
    pub(super) fn is_fitted(&self) -> bool {
        self.fitted > 0
    }

    /// Least and greatest probability that so many draws in all may show; the same once they are all drawn.
    pub(super) fn bounds(&self, draws: u32) -> [f64; 2] {
        let left = draws.saturating_sub(self.drawn);
        let share = |over: u32| f64::from(over + 1) / f64::from(self.fitted + left + 1);
        [share(self.over), share(self.over + left)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Distance and probability of some excesses.
    fn judged(excesses: &[f64], draws: u32, seed: u64) -> [f64; 2] {
        let mut ascending = excesses.to_vec();
        ascending.sort_by(f64::total_cmp);
        let fit = ParetoFit::fit(&ascending, 0.0).unwrap();
        let mut simulation = Simulation::new(&fit, distance(&ascending, fit.scale, fit.shape));
        for draw in 0..u64::from(draws) {
            let before = simulation.bounds(draws);
            simulation.add(&ExponentialDraw::new(seed, draw, fit.count));
            let after = simulation.bounds(draws);
            assert!(before[0] <= after[0] && after[1] <= before[1]);
        }
        simulation.bounds(draws)
    }

    #[test]
    fn distance_of_one_peak() {
        // At the median: -1 - 2 ln(1/2).
        let found = distance(&[2.0_f64.ln()], 1.0, 0.0);
        assert!((found - (2.0 * 2.0_f64.ln() - 1.0)).abs() < 1e-14);
    }

    #[test]
    fn logarithms_together_are_those_of_each() {
        for factors in [
            [0.9, 0.1, 1e-3, 0.5, 0.7, 1.0],
            [LEAST; TOGETHER],
            [1.0; TOGETHER],
        ] {
            let each = factors.iter().enumerate();
            let sum: f64 = each.map(|(i, f)| (7.0 + 2.0 * i as f64) * f.ln()).sum();
            assert!((weighted_logs(&factors, 7.0) - sum).abs() <= 1e-13 * sum.abs());
        }
    }

    #[test]
    fn draws_ascend_and_fewer_are_a_part_of_more() {
        for count in [0, 1, 2, 7, 500] {
            let mut draw = ExponentialDraw::new(3, 5, count);
            let mut random = Random::new(3, 5);
            let mut plain: Vec<f64> = (0..count).map(|_| -random.uniform().ln()).collect();
            for kept in [count, count / 2] {
                draw.keep(kept);
                plain.truncate(kept);
                let mut ascending = plain.clone();
                ascending.sort_by(f64::total_cmp);
                let found = draw.excesses(0.0);
                assert_eq!(found.len(), kept);
                for (found, value) in found.iter().zip(&ascending) {
                    assert!((found / value - 1.0).abs() < 1e-14);
                }
            }
        }
    }

    /// Of samples of the law itself the probability is uniform; of another law it is small.
    #[test]
    fn tells_a_pareto_law_from_another() {
        let mut sum = 0.0;
        for seed in 0..24 {
            let mut random = Random::new(seed, 1);
            let peaks: Vec<f64> = (0..40).map(|_| -random.uniform().ln()).collect();
            let [p, same] = judged(&peaks, 60, seed);
            assert_eq!(p, same);
            sum += p / 24.0;
        }
        // The mean of 24 uniform numbers: 0.06 standard deviation.
        assert!((sum - 0.5).abs() < 0.18, "{sum}");
        let mut random = Random::new(1, 1);
        let rayleigh: Vec<f64> = (0..200)
            .map(|_| (-random.uniform().ln()).powf(0.35))
            .collect();
        assert!(judged(&rayleigh, 60, 1)[0] < 0.05);
    }
}
