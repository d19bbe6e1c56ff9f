//! The discrete Fourier transform of a real record of any length, by the crates `realfft` and `rustfft`.
//!
//! They are built without instructions that only some processors have, so that the bits are the same on all.

use std::sync::{Arc, Mutex, PoisonError};

use nalgebra::Complex;
use realfft::{RealFftPlanner, RealToComplex};

/// The transform of one length.
type Plan = Arc<dyn RealToComplex<f64>>;

/// Lengths whose transforms are kept: every channel of a record has the same few.
const KEPT: usize = 4;

/// The transforms used last, the latest at the end.
static PLANS: Mutex<Vec<Plan>> = Mutex::new(Vec::new());

/// `sum over n of values[n] exp(-2 pi i k n / N)` for k from 0 to N/2; nothing of no values. The values are overwritten.
#[must_use]
pub fn real_spectrum(values: &mut [f64]) -> Vec<Complex<f64>> {
    let mut spectrum = Vec::new();
    transform(values, &mut spectrum);
    spectrum
}

/// The same into a list, whose room is used again.
pub fn transform(values: &mut [f64], spectrum: &mut Vec<Complex<f64>>) {
    spectrum.clear();
    if values.is_empty() {
        return;
    }
    let plan = plan(values.len());
    spectrum.resize(values.len() / 2 + 1, Complex::default());
    // It fails for lists of another length only.
    let done = plan.process(values, spectrum);
    debug_assert!(done.is_ok(), "{done:?}");
}

/// The transform of this length, kept or new.
fn plan(length: usize) -> Plan {
    let mut plans = PLANS.lock().unwrap_or_else(PoisonError::into_inner);
    let kept = plans.iter().position(|plan| plan.len() == length);
    let plan = match kept {
        Some(place) => plans.remove(place),
        None => RealFftPlanner::new().plan_fft_forward(length),
    };
    if plans.len() == KEPT {
        plans.remove(0);
    }
    plans.push(Arc::clone(&plan));
    plan
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn a_record_with_a_great_prime_factor_is_transformed_in_a_moment() {
        // Twice a prime: by its factors 1e11 products.
        let n = 2 * 249_989;
        let angle = |k: usize, of: usize| TAU * ((k * of) % n) as f64 / n as f64;
        let value = |k: usize| 0.25 + angle(k, 1234).cos() + 0.5 * angle(k, 100_000).sin();
        let values: Vec<f64> = (0..n).map(value).collect();
        let spectrum = real_spectrum(&mut values.clone());
        for (k, found) in spectrum.iter().enumerate() {
            let expected = match k {
                0 => Complex::new(0.25, 0.0),
                1234 => Complex::new(0.5, 0.0),
                100_000 => Complex::new(0.0, -0.25),
                _ => Complex::new(0.0, 0.0),
            };
            assert!((found / n as f64 - expected).norm() < 1e-12, "{k}: {found}");
        }
    }

    #[test]
    fn a_record_is_the_sum_of_its_components() {
        for n in [1, 2, 7, 60, 97, 210] {
            let values: Vec<f64> = (0..n)
                .map(|k| f64::from(k * k % 13) - 0.3 * f64::from(k))
                .collect();
            let spectrum = real_spectrum(&mut values.clone());
            let n = values.len();
            assert_eq!(spectrum.len(), n / 2 + 1);
            for (sample, value) in values.iter().enumerate() {
                let part = |(k, z): (usize, &Complex<f64>)| {
                    let twice = if k == 0 || 2 * k == n { 1.0 } else { 2.0 };
                    let angle = TAU * (k * sample % n) as f64 / n as f64;
                    twice * (z * Complex::new(angle.cos(), angle.sin())).re / n as f64
                };
                let sum: f64 = spectrum.iter().enumerate().map(part).sum();
                assert!((sum - value).abs() < 1e-11, "{n} {sample}");
            }
        }
    }
}
