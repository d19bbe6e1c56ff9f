//! Integrals: the trapezoidal rule over a grid, Gauss's rule for a function.

use std::f64::consts::PI;

/// Gauss's rule on 0 to 1: `N` nodes and weights, exact to the degree `2 N - 1`. The nodes are the roots of Legendre's polynomial, by Newton's
/// method from their asymptotic places (Abramowitz and Stegun 1964, 25.4.30 and 22.16.6).
#[must_use]
pub fn gauss_legendre<const N: usize>() -> [(f64, f64); N] {
    const NEWTON_STEPS: usize = 8;
    std::array::from_fn(|k| {
        let mut x = -(PI * (k as f64 + 0.75) / (N as f64 + 0.5)).cos();
        for _ in 0..NEWTON_STEPS {
            let (value, slope) = legendre(N, x);
            x -= value / slope;
        }
        let (_, slope) = legendre(N, x);
        (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// Legendre's polynomial of a degree from 1 on, and its derivative, between -1 and 1.
fn legendre(degree: usize, x: f64) -> (f64, f64) {
    let (mut before, mut here) = (1.0, x);
    for k in 1..degree {
        let k = k as f64;
        let next = ((2.0 * k + 1.0) * x * here - k * before) / (k + 1.0);
        (before, here) = (here, next);
    }
    let slope = degree as f64 * (before - x * here) / (1.0 - x * x);
    (here, slope)
}

/// The area of each interval of an ascending grid.
fn areas(grid: &[f64], values: &[f64]) -> impl Iterator<Item = f64> {
    let pieces = grid.windows(2).zip(values.windows(2));
    pieces.map(|(x, y)| 0.5 * (x[1] - x[0]) * (y[0] + y[1]))
}

/// The integral over the whole grid.
#[must_use]
pub fn trapezoid(grid: &[f64], values: &[f64]) -> f64 {
    areas(grid, values).sum()
}

/// The integral from the first point of the grid to each.
#[must_use]
pub fn cumulative_trapezoid(grid: &[f64], values: &[f64]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut all = vec![0.0; grid.len().min(1)];
    all.extend(areas(grid, values).map(|area| {
        sum += area;
        sum
    }));
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gauss_is_exact_to_its_degree() {
        fn check<const N: usize>() {
            let rule = gauss_legendre::<N>();
            for degree in 0..2 * N {
                let power = i32::try_from(degree).unwrap();
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(power)).sum();
                let exact = 1.0 / (degree as f64 + 1.0);
                assert!((sum / exact - 1.0).abs() < 1e-13, "{N}, {degree}: {sum}");
            }
        }
        check::<1>();
        check::<2>();
        check::<12>();
        check::<16>();
    }

    #[test]
    fn exact_for_straight_lines() {
        let (grid, values) = ([0.0, 1.0, 3.0], [0.0, 2.0, 6.0]);
        assert_eq!(trapezoid(&grid, &values), 9.0);
        assert_eq!(cumulative_trapezoid(&grid, &values), [0.0, 1.0, 9.0]);
        assert!(cumulative_trapezoid(&[], &[]).is_empty());
    }
}
