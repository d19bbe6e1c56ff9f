//! How often a record crosses a level upwards.

use super::error::{ExtremesError, check_finite, check_inside};
use crate::numerics::statistics::mean;

/// A step of time: finite and above zero.
pub(super) fn check_step(step: f64) -> Result<(), ExtremesError> {
    check_inside("the time step", step, (0.0, f64::INFINITY), "above 0 s")
}

/// Upward crossings of a level, as indices of the first value above it.
pub(super) fn up_crossings(values: &[f64], level: f64) -> impl Iterator<Item = usize> {
    values
        .windows(2)
        .enumerate()
        .filter(move |(_, pair)| matches!(pair, [a, b] if *a <= level && *b > level))
        .map(|(index, _)| index + 1)
}

/// Upward crossings of each level per second, of a record of `step` seconds between its values.
///
/// # Errors
/// Where the record has fewer than two values, a value or a level is not finite, or the step is not above zero.
pub fn crossing_rates(
    values: &[f64],
    step: f64,
    levels: &[f64],
) -> Result<Vec<f64>, ExtremesError> {
    check_finite(values, 2)?;
    check_finite(levels, 0)?;
    check_step(step)?;
    let duration = step * (values.len() - 1) as f64;
    let rate = |level: &f64| up_crossings(values, *level).count() as f64 / duration;
    Ok(levels.iter().map(rate).collect())
}

/// Upward crossings of the mean per second.
///
/// # Errors
/// As [`crossing_rates`].
pub fn mean_crossing_rate(values: &[f64], step: f64) -> Result<f64, ExtremesError> {
    let rates = crossing_rates(values, step, &[mean(values)])?;
    Ok(rates.first().copied().unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn of_a_sine() {
        let values: Vec<f64> = (0..=10_000)
            .map(|i| 3.0 + (TAU * 0.1 * 0.05 * f64::from(i) - 1.0).sin())
            .collect();
        let rates = crossing_rates(&values, 0.05, &[2.5, 3.0, 3.9, 4.1]).unwrap();
        assert_eq!(rates, [0.1, 0.1, 0.1, 0.0]);
        assert!((mean_crossing_rate(&values, 0.05).unwrap() - 0.1).abs() < 1e-12);
    }

    #[test]
    fn bad_records_are_refused() {
        assert!(crossing_rates(&[1.0], 0.1, &[0.0]).is_err());
        assert!(crossing_rates(&[1.0, f64::NAN], 0.1, &[0.0]).is_err());
        assert!(crossing_rates(&[1.0, 2.0], 0.0, &[0.0]).is_err());
        assert!(crossing_rates(&[1.0, 2.0], 0.1, &[f64::NAN]).is_err());
        assert_eq!(mean_crossing_rate(&[2.0, 2.0, 2.0], 1.0), Ok(0.0));
    }
}
