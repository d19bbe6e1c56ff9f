//! The discrete Fourier transform of a record of any length, by the prime factors of its length (Cooley and Tukey 1965).
//!
//! The cost is that of the sum of the prime factors at each sample: a few where the length is a product of small numbers, half the
//! length at worst.

use std::f64::consts::TAU;

use nalgebra::Complex;

/// `sum over n of values[n] exp(-2 pi i k n / N)` for k from 0 to N/2.
#[must_use]
pub fn real_spectrum(values: &[f64]) -> Vec<Complex<f64>> {
    let n = values.len();
    // Every rotation is one of these, so that none gathers the error of a recurrence.
    let rotations: Vec<Complex<f64>> = (0..n)
        .map(|k| {
            let (sin, cos) = (TAU * k as f64 / n as f64).sin_cos();
            Complex::new(cos, -sin)
        })
        .collect();
    let values: Vec<Complex<f64>> = values.iter().map(|v| Complex::new(*v, 0.0)).collect();
    let mut all = transform(&values, &rotations, 1);
    all.truncate(n / 2 + 1);
    all
}

/// The transform of these values, whose rotation by k steps is number `k * stride`.
fn transform(
    values: &[Complex<f64>],
    rotations: &[Complex<f64>],
    stride: usize,
) -> Vec<Complex<f64>> {
    let n = values.len();
    if n <= 1 {
        return values.to_vec();
    }
    let factor = least_factor(n);
    let part = n / factor;
    let parts: Vec<Vec<Complex<f64>>> = (0..factor)
        .map(|first| {
            let every: Vec<Complex<f64>> =
                values.iter().skip(first).step_by(factor).copied().collect();
            transform(&every, rotations, stride * factor)
        })
        .collect();
    let sum = |k: usize| {
        let turned = |(first, part_values): (usize, &Vec<Complex<f64>>)| {
            part_values[k % part] * rotations[(first * k % n) * stride]
        };
        parts.iter().enumerate().map(turned).sum()
    };
    (0..n).map(sum).collect()
}

/// The least factor of a number above 1.
fn least_factor(n: usize) -> usize {
    let found = (2..)
        .take_while(|k| k * k <= n)
        .find(|k| n.is_multiple_of(*k));
    found.unwrap_or(n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_is_the_sum_of_its_components() {
        for n in [1, 2, 7, 60, 97, 210] {
            let values: Vec<f64> = (0..n)
                .map(|k| f64::from(k * k % 13) - 0.3 * f64::from(k))
                .collect();
            let spectrum = real_spectrum(&values);
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
