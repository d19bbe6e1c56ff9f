//! How far the mean of a correlated record has converged.

use super::error::{ExtremesError, check_finite, check_spread};
use super::special::normal_probability;
use crate::numerics::fourier::transform;
use crate::numerics::statistics::{mean, variance};

/// The mean of a record with its standard error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanEstimate {
    /// Mean, in the unit of the record.
    pub mean: f64,
    /// Standard error of the mean by the integrated autocorrelation time.
    pub error: f64,
    /// Standard error of the mean by the scatter of 20 batch means, without assumption on the sign of correlations.
    pub batch_error: f64,
    /// Integrated autocorrelation time in steps, 1 for independent values.
    pub correlation_steps: f64,
    /// Independent values with the same standard error: the number of values over the correlation time.
    pub effective: f64,
}

/// Batches of [`MeanEstimate::batch_error`]: ten to thirty serve (Schmeiser, Oper. Res. 30 (1982) 556).
const BATCHES: usize = 20;

impl MeanEstimate {
    /// Of a stationary record at even steps, of 40 values or more.
    ///
    /// The autocorrelations are summed in pairs while the pairs are positive and made to fall (Geyer's initial monotone sequence,
    /// Statist. Sci. 7 (1992) 473). In an oscillating record the sum ends in the first trough and the error is an upper one;
    /// the batches count the troughs too.
    ///
    /// # Errors
    /// Where values are fewer than 40, not finite or all the same.
    pub fn of_record(values: &[f64]) -> Result<Self, ExtremesError> {
        let (low, high) = check_spread(values, 2 * BATCHES)?;
        let range = high - low;
        let scaled: Vec<f64> = values.iter().map(|v| (v - low) / range).collect();
        let n = values.len() as f64;
        let centre = mean(&scaled);
        let correlation_steps = correlation_steps(&autocorrelation(&scaled, centre));
        let error = (variance(&scaled, centre) * correlation_steps / n).sqrt();
        Ok(Self {
            mean: low + range * centre,
            error: range * error,
            batch_error: range * batch_error(&scaled),
            correlation_steps,
            effective: n / correlation_steps,
        })
    }
}

/// The first half of a record against the second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Halves {
    /// The first.
    pub first: MeanEstimate,
    /// The second.
    pub second: MeanEstimate,
    /// Second mean less first over the standard error of the difference.
    pub difference: f64,
    /// Probability of as great a difference in a stationary record (normal law, both errors by correlation time).
    pub p_value: f64,
}

impl Halves {
    /// Of a record of 80 values or more. A small probability says that the record drifts: leave out its beginning.
    ///
    /// # Errors
    /// Where values are fewer than 80, not finite, or all the same in a half.
    pub fn of_record(values: &[f64]) -> Result<Self, ExtremesError> {
        check_finite(values, 4 * BATCHES)?;
        let (first, second) = values.split_at(values.len() / 2);
        let (first, second) = (
            MeanEstimate::of_record(first)?,
            MeanEstimate::of_record(second)?,
        );
        let difference = (second.mean - first.mean) / first.error.hypot(second.error);
        Ok(Self {
            first,
            second,
            difference,
            p_value: 2.0 * normal_probability(-difference.abs()),
        })
    }
}

/// Autocorrelations at all lags, by the transform of the power spectrum of the record with zeros appended.
fn autocorrelation(values: &[f64], centre: f64) -> Vec<f64> {
    let length = (2 * values.len()).next_power_of_two();
    let mut padded = vec![0.0; length];
    for (place, value) in padded.iter_mut().zip(values) {
        *place = value - centre;
    }
    let mut spectrum = Vec::new();
    transform(&mut padded, &mut spectrum);
    for (k, z) in spectrum.iter().enumerate() {
        let power = z.norm_sqr();
        padded[k] = power;
        padded[(length - k) % length] = power;
    }
    transform(&mut padded, &mut spectrum);
    let zero = spectrum.first().map_or(1.0, |z| z.re);
    padded.clear();
    padded.extend(spectrum.iter().take(values.len()).map(|z| z.re / zero));
    padded
}

/// One plus twice the sum of the autocorrelations, as far as pairs of them are positive.
fn correlation_steps(correlation: &[f64]) -> f64 {
    let (mut sum, mut before) = (0.0, f64::INFINITY);
    for pair in correlation.chunks_exact(2) {
        let together: f64 = pair.iter().sum();
        if together <= 0.0 {
            break;
        }
        before = together.min(before);
        sum += before;
    }
    // Not below what a record of alternating values could claim.
    (2.0 * sum - 1.0).max(1.0 / correlation.len() as f64)
}

fn batch_error(values: &[f64]) -> f64 {
    let length = values.len() / BATCHES;
    let means: Vec<f64> = values
        .chunks_exact(length)
        .take(BATCHES)
        .map(mean)
        .collect();
    (variance(&means, mean(&means)) / (BATCHES - 1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;
    use std::f64::consts::TAU;

    /// First-order autoregression: its correlation time is (1 + a)/(1 - a).
    fn autoregression(a: f64, count: usize, seed: u64) -> Vec<f64> {
        let mut random = Random::new(seed, 0);
        let mut value = 0.0;
        let mut next = || {
            value = a * value + 12.0_f64.sqrt() * (random.uniform() - 0.5);
            value
        };
        (0..count + 200).map(|_| next()).skip(200).collect()
    }

    #[test]
    fn correlation_time_of_an_autoregression() {
        for (a, exact) in [(0.0, 1.0), (0.5, 3.0), (0.9, 19.0)] {
            let found = MeanEstimate::of_record(&autoregression(a, 60_000, 5)).unwrap();
            assert!(
                (found.correlation_steps / exact - 1.0).abs() < 0.12,
                "{found:?}"
            );
            let error = 1.0 / (1.0 - a) / 60_000.0_f64.sqrt();
            assert!((found.error / error - 1.0).abs() < 0.08, "{found:?}");
            // 19 degrees of freedom: 16 % standard deviation.
            assert!((found.batch_error / error - 1.0).abs() < 0.5, "{found:?}");
        }
    }

    #[test]
    fn the_error_is_that_of_the_mean_over_records() {
        // Three standard errors of a share of 120.
        let (mut within, records) = (0, 120);
        for seed in 0..records {
            let found = MeanEstimate::of_record(&autoregression(0.8, 1200, seed)).unwrap();
            within += u64::from(found.mean.abs() < 1.96 * found.error);
        }
        let share = within as f64 / records as f64;
        assert!((share - 0.95).abs() < 0.06, "{share}");
    }

    #[test]
    fn autocorrelation_by_transform_is_the_sum() {
        let values = autoregression(0.6, 50, 2);
        let centre = mean(&values);
        let direct = |lag: usize| -> f64 {
            values
                .iter()
                .zip(values.iter().skip(lag))
                .map(|(a, b)| (a - centre) * (b - centre))
                .sum()
        };
        for (lag, found) in autocorrelation(&values, centre).iter().enumerate() {
            assert!((found - direct(lag) / direct(0)).abs() < 1e-13);
        }
    }

    #[test]
    fn halves_tell_a_drift() {
        let steady = autoregression(0.7, 4000, 9);
        assert!(Halves::of_record(&steady).unwrap().p_value > 0.01);
        let drifting: Vec<f64> = steady
            .iter()
            .enumerate()
            .map(|(k, v)| v + 0.0005 * k as f64)
            .collect();
        let found = Halves::of_record(&drifting).unwrap();
        assert!(found.difference > 4.0 && found.p_value < 1e-4, "{found:?}");
    }

    #[test]
    fn oscillations_and_bad_records() {
        let sine: Vec<f64> = (0..5000)
            .map(|k| (TAU * 0.02 * f64::from(k)).sin())
            .collect();
        let found = MeanEstimate::of_record(&sine).unwrap();
        assert!(found.error > found.batch_error && found.mean.abs() < found.error);
        let alternating: Vec<f64> = (0..100).map(|k| f64::from(k % 2)).collect();
        assert!(
            MeanEstimate::of_record(&alternating)
                .unwrap()
                .error
                .is_finite()
        );
        assert!(MeanEstimate::of_record(&[1.0; 50]).is_err());
        assert!(MeanEstimate::of_record(&sine[..39]).is_err());
        assert!(Halves::of_record(&sine[..79]).is_err());
        let huge: Vec<f64> = sine.iter().map(|v| 1e306 * v).collect();
        assert!(MeanEstimate::of_record(&huge).unwrap().error.is_finite());
    }
}
