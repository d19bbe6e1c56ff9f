//! How well a generalized Pareto law fits peaks: the Anderson-Darling distance, with its probability by simulation.

use super::error::ExtremesError;
use super::generalized_pareto::ParetoFit;
use crate::numerics::random::Random;

/// Distance of peaks from a law: `-n - mean((2 i - 1)(ln F_i + ln(1 - F_(n+1-i))))` of the peaks in ascending order (Anderson and
/// Darling 1954).
#[must_use]
pub(super) fn distance(peaks: &[f64], law: &ParetoFit) -> f64 {
    // Away from 0 and 1, which a peak at the end of the law would give.
    let mut probabilities: Vec<f64> = peaks
        .iter()
        .map(|p| law.probability(*p).clamp(1e-15, 1.0 - 1e-15))
        .collect();
    probabilities.sort_by(f64::total_cmp);
    let n = peaks.len() as f64;
    let backwards = probabilities.iter().rev();
    let sum: f64 = probabilities
        .iter()
        .zip(backwards)
        .enumerate()
        .map(|(i, (low, high))| (2.0 * i as f64 + 1.0) * (low.ln() + (-high).ln_1p()))
        .sum();
    -n - sum / n
}

/// The share of samples drawn from the fitted law and fitted themselves that lie as far from their fit: the probability of the
/// distance with both parameters estimated (Stute, Gonzalez Manteiga and Presedo Quindimil, Metrika 40 (1993) 243).
///
/// # Errors
/// Where none of the samples has a fit.
pub(super) fn p_value(
    distance_found: f64,
    law: &ParetoFit,
    draws: u32,
    seed: u64,
) -> Result<f64, ExtremesError> {
    let redrawn = (0..u64::from(draws)).filter_map(|draw| {
        let mut random = Random::new(seed, draw);
        let peaks: Vec<f64> = (0..law.count).map(|_| law.draw(&mut random)).collect();
        // Rounding may put a peak onto the threshold: such a sample has no fit.
        let fit = ParetoFit::fit(&peaks, law.threshold).ok()?;
        Some(distance(&peaks, &fit))
    });
    let (over, count) = redrawn.fold((0.0, 0.0), |(over, count), d| {
        (over + f64::from(u8::from(d >= distance_found)), count + 1.0)
    });
    if count == 0.0 {
        return Err(ExtremesError::NoMaximum("generalized Pareto"));
    }
    Ok((over + 1.0) / (count + 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exponential(scale: f64, count: usize) -> ParetoFit {
        ParetoFit {
            threshold: 0.0,
            scale,
            shape: 0.0,
            count,
            log_likelihood: 0.0,
        }
    }

    #[test]
    fn distance_of_one_peak() {
        // At the median: -1 - 2 ln(1/2).
        let found = distance(&[2.0_f64.ln()], &exponential(1.0, 1));
        assert!((found - (2.0 * 2.0_f64.ln() - 1.0)).abs() < 1e-14);
    }

    /// Of samples of the law itself the probability is uniform; of another law it is small.
    #[test]
    fn tells_a_pareto_law_from_another() {
        let mut sum = 0.0;
        for seed in 0..24 {
            let mut random = Random::new(seed, 1);
            let peaks: Vec<f64> = (0..40).map(|_| -random.uniform().ln()).collect();
            let fit = ParetoFit::fit(&peaks, 0.0).unwrap();
            sum += p_value(distance(&peaks, &fit), &fit, 60, seed).unwrap() / 24.0;
        }
        // The mean of 24 uniform numbers: 0.06 standard deviation.
        assert!((sum - 0.5).abs() < 0.18, "{sum}");
        let mut random = Random::new(1, 1);
        let rayleigh: Vec<f64> = (0..200)
            .map(|_| (-random.uniform().ln()).powf(0.35))
            .collect();
        let fit = ParetoFit::fit(&rayleigh, 0.0).unwrap();
        assert!(p_value(distance(&rayleigh, &fit), &fit, 60, 1).unwrap() < 0.05);
    }
}
