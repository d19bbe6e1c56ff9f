//! The discrete Fourier transform of a record of any length, by the prime factors of its length (Cooley and Tukey 1965).
//!
//! The cost is that of the sum of the prime factors at each sample, a few where the length is a product of small numbers. A length with a
//! great prime factor is transformed as a convolution, of a length that is a power of two (Bluestein 1970).

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

/// `sum over n of values[n] exp(-2 pi i k n / N)` for k from 0 to N/2.
#[must_use]
pub fn real_spectrum(values: &[f64]) -> Vec<Complex<f64>> {
    let n = values.len();
    let values: Vec<Complex<f64>> = values.iter().map(|v| Complex::new(*v, 0.0)).collect();
    let mut all = match greatest_factor(n) > GREATEST_FACTOR {
        true => convolved(&values),
        false => transform(&values, &rotations(n), 1),
    };
    all.truncate(n / 2 + 1);
    all
}

/// Greatest prime factor of a length that is transformed by its factors.
const GREATEST_FACTOR: usize = 500;

/// `exp(-2 pi i k / N)` for k from 0 to N - 1: every rotation is one of these, so that none gathers the error of a recurrence.
fn rotations(n: usize) -> Vec<Complex<f64>> {
    let rotation = |k: usize| {
        let (sin, cos) = (TAU * k as f64 / n as f64).sin_cos();
        Complex::new(cos, -sin)
    };
    (0..n).map(rotation).collect()
}

/// The transform of values as a convolution: `2 k n = k^2 + n^2 - (k - n)^2` (Bluestein 1970).
fn convolved(values: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let n = values.len();
    let length = (2 * n).next_power_of_two();
    let rotations = rotations(length);
    // exp(-pi i k^2 / N), which repeats after 2 N.
    let chirp = |k: usize| {
        let (sin, cos) = (PI * (k * k % (2 * n)) as f64 / n as f64).sin_cos();
        Complex::new(cos, -sin)
    };
    let zero = Complex::new(0.0, 0.0);
    let (mut signal, mut kernel) = (vec![zero; length], vec![zero; length]);
    for (k, value) in values.iter().enumerate() {
        let rotation = chirp(k);
        signal[k] = value * rotation;
        kernel[k] = rotation.conj();
        kernel[(length - k) % length] = rotation.conj();
    }
    let signal = transform(&signal, &rotations, 1);
    let kernel = transform(&kernel, &rotations, 1);
    let product = signal.iter().zip(&kernel);
    let product: Vec<Complex<f64>> = product.map(|(a, b)| (a * b).conj()).collect();
    // The inverse transform is that of the conjugates.
    let back = transform(&product, &rotations, 1);
    let back = back.iter().take(n).enumerate();
    back.map(|(k, value)| value.conj() * chirp(k) / length as f64)
        .collect()
}

/// The greatest prime factor of a number; 1 of what has none.
fn greatest_factor(mut n: usize) -> usize {
    let mut greatest = 1;
    while n > 1 {
        greatest = least_factor(n);
        n /= greatest;
    }
    greatest
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
    fn a_record_with_a_great_prime_factor_is_transformed_in_a_moment() {
        // Twice a prime: by its factors 1e11 products.
        let n = 2 * 249_989;
        assert_eq!(greatest_factor(n), 249_989);
        let angle = |k: usize, of: usize| TAU * ((k * of) % n) as f64 / n as f64;
        let value = |k: usize| 0.25 + angle(k, 1234).cos() + 0.5 * angle(k, 100_000).sin();
        let values: Vec<f64> = (0..n).map(value).collect();
        let spectrum = real_spectrum(&values);
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
    fn both_ways_agree() {
        let values: Vec<Complex<f64>> = (0..210_i32)
            .map(|k| Complex::new(f64::from(k * k % 13), f64::from(k % 7)))
            .collect();
        let by_factors = transform(&values, &rotations(210), 1);
        for (a, b) in convolved(&values).iter().zip(&by_factors) {
            assert!((a - b).norm() < 1e-9, "{a} {b}");
        }
    }

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
