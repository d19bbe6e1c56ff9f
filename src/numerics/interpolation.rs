//! Straight lines between the points of a table over an ascending grid.

use std::ops::{Add, Mul, Sub};

/// The interval of an ascending grid of two points or more that holds `x`: `grid[i] <= x < grid[i + 1]`, the first or last
/// one beyond the ends.
#[inline(always)]
#[must_use]
pub fn interval(grid: &[f64], x: f64) -> usize {
    grid.partition_point(|g| *g <= x).clamp(1, grid.len() - 1) - 1
}

/// As [`interval`], with a point of the grid in the interval that ends there: `grid[i] < x <= grid[i + 1]`.
#[inline(always)]
#[must_use]
pub fn interval_closed_above(grid: &[f64], x: f64) -> usize {
    grid.partition_point(|g| *g < x).clamp(1, grid.len() - 1) - 1
}

/// The share of the way from `grid[i]` to `grid[i + 1]` at which `x` lies; below 0 or above 1 outside of the interval.
#[inline(always)]
#[must_use]
pub fn share(grid: &[f64], i: usize, x: f64) -> f64 {
    (x - grid[i]) / (grid[i + 1] - grid[i])
}

/// The value a share of the way between two.
#[inline(always)]
#[must_use]
pub fn mix<T>(from: T, to: T, share: f64) -> T
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
{
    from + (to - from) * share
}

/// The value at `x`, extrapolated from the outer intervals.
#[must_use]
pub fn linear(grid: &[f64], values: &[f64], x: f64) -> f64 {
    let i = interval_closed_above(grid, x);
    mix(values[i], values[i + 1], share(grid, i, x))
}

/// The value at `x`, constant beyond the ends.
#[must_use]
pub fn linear_clamped(grid: &[f64], values: &[f64], x: f64) -> f64 {
    let i = interval_closed_above(grid, x);
    mix(values[i], values[i + 1], share(grid, i, x).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    const GRID: [f64; 3] = [1.0, 2.0, 4.0];
    const VALUES: [f64; 3] = [10.0, 20.0, 0.0];

    #[test]
    fn intervals_hold_their_points() {
        let found = [0.0, 1.0, 2.0, 3.0, 4.0, 9.0].map(|x| interval(&GRID, x));
        assert_eq!(found, [0, 0, 1, 1, 1, 1]);
        let found = [0.0, 1.0, 2.0, 3.0, 4.0, 9.0].map(|x| interval_closed_above(&GRID, x));
        assert_eq!(found, [0, 0, 0, 1, 1, 1]);
    }

    #[test]
    fn straight_between_points_and_beyond() {
        let at = |x| linear(&GRID, &VALUES, x);
        assert_eq!(
            [at(0.0), at(1.5), at(3.0), at(5.0)],
            [0.0, 15.0, 10.0, -10.0]
        );
        let at = |x| linear_clamped(&GRID, &VALUES, x);
        assert_eq!(
            [at(0.0), at(1.5), at(3.0), at(5.0)],
            [10.0, 15.0, 10.0, 0.0]
        );
    }
}
