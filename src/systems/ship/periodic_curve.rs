//! Periodic functions of an angle, for load coefficients against the angle of attack: a Fourier series, or a table with linear
//! or periodic cubic spline interpolation.

use std::f64::consts::{PI, TAU};

use super::model::Interpolation;
use crate::numerics::spline::periodic_second_derivatives;

/// A function of an angle \[rad\] with period 2π.
#[derive(Debug, Clone, PartialEq)]
pub enum PeriodicCurve {
    /// `Σ cos[n] cos(n α) + sin[n] sin(n α)`, n from 0.
    Fourier {
        /// Cosine amplitudes, the mean first.
        cos: Vec<f64>,
        /// Sine amplitudes; that of n = 0 has no effect.
        sin: Vec<f64>,
    },
    /// A table over 2π, interpolated linearly or by a cubic spline.
    Table {
        /// Angles, ascending from 0, all below 2π \[rad\].
        at: Vec<f64>,
        /// Values at the angles.
        value: Vec<f64>,
        /// Second derivatives at the angles; all zero for linear interpolation.
        second_derivative: Vec<f64>,
    },
}

/// Symmetry by which a table over 0 to π extends to 2π.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parity {
    /// Even, as the surge force.
    Even,
    /// Odd, as the sway force and the yaw moment.
    Odd,
}

impl PeriodicCurve {
    /// Interpolates points. Angles \[rad\] ascend from 0 and end at π (the other half then follows by `parity`) or below
    /// 2π.
    #[must_use]
    pub fn through(
        angles: &[f64],
        values: &[f64],
        parity: Parity,
        interpolation: Interpolation,
    ) -> Self {
        let (at, value) = extended(angles, values, parity);
        let second_derivative = match interpolation {
            Interpolation::Linear => vec![0.0; at.len()],
            Interpolation::Cubic => periodic_second_derivatives(&at, &value, TAU),
        };
        Self::Table {
            at,
            value,
            second_derivative,
        }
    }

    /// Value and first derivative by the angle \[rad\].
    #[must_use]
    pub fn at(&self, angle: f64) -> (f64, f64) {
        match self {
            Self::Fourier { cos, sin } => {
                let mut sum = (0.0, 0.0);
                for (n, a) in cos.iter().enumerate() {
                    let n = n as f64;
                    let (s, c) = (n * angle).sin_cos();
                    sum = (sum.0 + a * c, sum.1 - a * n * s);
                }
                for (n, b) in sin.iter().enumerate() {
                    let n = n as f64;
                    let (s, c) = (n * angle).sin_cos();
                    sum = (sum.0 + b * s, sum.1 + b * n * c);
                }
                sum
            }
            Self::Table {
                at,
                value,
                second_derivative,
            } => {
                let angle = angle.rem_euclid(TAU);
                let (i, j, h) = interval(at, angle);
                let s = angle - at[i];
                let (left, right) = (h - s, s);
                let (m, n) = (second_derivative[i] / 6.0, second_derivative[j] / 6.0);
                let (p, q) = (value[i] / h - m * h, value[j] / h - n * h);
                (
                    (m * left.powi(3) + n * right.powi(3)) / h + p * left + q * right,
                    3.0 * (n * right * right - m * left * left) / h + q - p,
                )
            }
        }
    }

    /// Upper bound of the magnitude of the second derivative on the interval around an angle.
    #[must_use]
    pub fn second_derivative_bound(&self, angle: f64) -> f64 {
        match self {
            Self::Fourier { cos, sin } => {
                let of = |list: &[f64]| -> f64 {
                    let each = list.iter().enumerate();
                    each.map(|(n, a)| (n * n) as f64 * a.abs()).sum()
                };
                of(cos) + of(sin)
            }
            Self::Table {
                at,
                second_derivative,
                ..
            } => {
                let (i, j, _) = interval(at, angle.rem_euclid(TAU));
                second_derivative[i].abs().max(second_derivative[j].abs())
            }
        }
    }

    /// Bound of the magnitude: the sum of the amplitudes, or the largest value of the table.
    #[must_use]
    pub fn bound(&self) -> f64 {
        match self {
            Self::Fourier { cos, sin } => cos.iter().chain(sin).map(|a| a.abs()).sum(),
            Self::Table { value, .. } => value.iter().fold(0.0, |m, v| m.max(v.abs())),
        }
    }

    /// Angles at which the curve is not smooth \[rad\].
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        match self {
            Self::Fourier { .. } => &[],
            Self::Table { at, .. } => at,
        }
    }
}

/// The interval of the table around an angle: its first point, its second, its width \[rad\].
fn interval(at: &[f64], angle: f64) -> (usize, usize, f64) {
    let after = at.partition_point(|a| *a <= angle);
    let first = after.saturating_sub(1);
    if after < at.len() {
        (first, after, at[after] - at[first])
    } else {
        (first, 0, TAU + at[0] - at[first])
    }
}

/// Points over 2π from points over 2π or over π.
fn extended(angles: &[f64], values: &[f64], parity: Parity) -> (Vec<f64>, Vec<f64>) {
    let (mut at, mut value) = (angles.to_vec(), values.to_vec());
    let last = at.last().copied().unwrap_or(0.0);
    if (last - PI).abs() > 1e-9 {
        return (at, value);
    }
    let sign = match parity {
        Parity::Even => 1.0,
        Parity::Odd => -1.0,
    };
    for i in (1..angles.len().saturating_sub(1)).rev() {
        at.push(TAU - angles[i]);
        value.push(sign * values[i]);
    }
    (at, value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(n: usize) -> Vec<f64> {
        (0..=n).map(|i| PI * i as f64 / n as f64).collect()
    }

    #[test]
    fn a_spline_follows_a_sine_to_the_fourth_order() {
        let error = |n: usize| {
            let at = grid(n);
            let values: Vec<f64> = at.iter().map(|a| a.sin()).collect();
            let curve = PeriodicCurve::through(&at, &values, Parity::Odd, Interpolation::Cubic);
            (0..997)
                .map(|i| 0.0123 + f64::from(i) * TAU / 997.0)
                .map(|a| (curve.at(a).0 - a.sin()).abs())
                .fold(0.0, f64::max)
        };
        let rate = (error(8) / error(16)).log2();
        assert!((3.7..4.3).contains(&rate), "{rate}");
    }

    #[test]
    fn slopes_are_derivatives_and_bends_are_bounded() {
        let at = grid(6);
        let values = [1.0, 0.7, 0.2, -0.1, -0.4, -0.9, -1.1];
        let curves = [
            PeriodicCurve::through(&at, &values, Parity::Even, Interpolation::Cubic),
            PeriodicCurve::through(&at, &values, Parity::Even, Interpolation::Linear),
            PeriodicCurve::Fourier {
                cos: vec![0.1, 0.9, 0.2],
                sin: vec![0.0, 0.3, -0.4, 0.1],
            },
        ];
        for curve in &curves {
            for i in 0..200 {
                let a = -4.0 + 0.0437 * f64::from(i);
                let h = 1e-5;
                let slope = (curve.at(a + h).0 - curve.at(a - h).0) / (2.0 * h);
                assert!((slope - curve.at(a).1).abs() < 1e-6, "{a}");
                let bend = (curve.at(a + h).1 - curve.at(a - h).1) / (2.0 * h);
                assert!(
                    bend.abs() <= curve.second_derivative_bound(a) + 1e-4,
                    "{a}: {bend}"
                );
            }
        }
    }

    #[test]
    fn a_table_over_half_a_turn_is_mirrored() {
        let at = grid(4);
        let odd = PeriodicCurve::through(
            &at,
            &[0.0, 0.8, 1.0, 0.6, 0.0],
            Parity::Odd,
            Interpolation::Cubic,
        );
        for i in 1..30 {
            let a = 0.1 * f64::from(i);
            assert!((odd.at(a).0 + odd.at(-a).0).abs() < 1e-14);
        }
    }
}
