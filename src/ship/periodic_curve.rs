//! Coefficients of a load against the angle between ship and flow: periodic curves, as a Fourier series or as a table
//! with straight lines or a periodic cubic spline between its points.

use std::f64::consts::{PI, TAU};

use nalgebra::{DMatrix, DVector};

/// A coefficient against an angle \[rad\], periodic over a full turn.
#[derive(Debug, Clone, PartialEq)]
pub enum PeriodicCurve {
    /// `Σ cos[n] cos(n α) + sin[n] sin(n α)`, n from 0.
    Fourier {
        /// Amplitudes of the cosines, the mean first.
        cos: Vec<f64>,
        /// Amplitudes of the sines; that of n = 0 has no effect.
        sin: Vec<f64>,
    },
    /// Points on a full turn, with straight lines or a spline between.
    Points {
        /// Angles, rising from 0, all below a full turn \[rad\].
        at: Vec<f64>,
        /// Values at the angles.
        value: Vec<f64>,
        /// Second derivatives at the angles; all nought for straight lines.
        bend: Vec<f64>,
    },
}

/// What lies between the points of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Between {
    /// Straight lines.
    Linear,
    /// The cubic spline that is periodic with its first and second derivative.
    Cubic,
}

/// How a table over half a turn goes on beyond it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parity {
    /// The same to port and starboard, as the force along the ship.
    Even,
    /// The opposite to port and starboard, as side force and yaw moment.
    Odd,
}

impl PeriodicCurve {
    /// A curve through points. Angles \[rad\] rise from 0, and end at half a turn (the other half then follows by
    /// `parity`) or below a full one.
    #[must_use]
    pub fn through(angles: &[f64], values: &[f64], parity: Parity, between: Between) -> Self {
        let (at, value) = full_turn(angles, values, parity);
        let bend = match between {
            Between::Linear => vec![0.0; at.len()],
            Between::Cubic => periodic_spline(&at, &value),
        };
        Self::Points { at, value, bend }
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
            Self::Points { at, value, bend } => {
                let angle = angle.rem_euclid(TAU);
                let (i, j, h) = piece(at, angle);
                let s = angle - at[i];
                let (left, right) = (h - s, s);
                let (m, n) = (bend[i] / 6.0, bend[j] / 6.0);
                let (p, q) = (value[i] / h - m * h, value[j] / h - n * h);
                (
                    (m * left.powi(3) + n * right.powi(3)) / h + p * left + q * right,
                    3.0 * (n * right * right - m * left * left) / h + q - p,
                )
            }
        }
    }

    /// A bound of the second derivative's size on the piece that holds an angle.
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
            Self::Points { at, bend, .. } => {
                let (i, j, _) = piece(at, angle.rem_euclid(TAU));
                bend[i].abs().max(bend[j].abs())
            }
        }
    }

    /// A bound of the value's size, reached or nearly.
    #[must_use]
    pub fn size(&self) -> f64 {
        match self {
            Self::Fourier { cos, sin } => cos.iter().chain(sin).map(|a| a.abs()).sum(),
            Self::Points { value, .. } => value.iter().fold(0.0, |m, v| m.max(v.abs())),
        }
    }

    /// The angles at which the curve is not smooth \[rad\].
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        match self {
            Self::Fourier { .. } => &[],
            Self::Points { at, .. } => at,
        }
    }
}

/// The piece that holds an angle within the turn: its first point, its second, its width.
fn piece(at: &[f64], angle: f64) -> (usize, usize, f64) {
    let after = at.partition_point(|a| *a <= angle);
    let first = after.saturating_sub(1);
    if after < at.len() {
        (first, after, at[after] - at[first])
    } else {
        (first, 0, TAU + at[0] - at[first])
    }
}

/// Points on the whole turn from points on it or on half of it.
fn full_turn(angles: &[f64], values: &[f64], parity: Parity) -> (Vec<f64>, Vec<f64>) {
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

/// Second derivatives of the periodic cubic spline through points on a full turn.
fn periodic_spline(at: &[f64], value: &[f64]) -> Vec<f64> {
    let n = at.len();
    if n < 3 {
        return vec![0.0; n];
    }
    let width = |i: usize| {
        if i + 1 < n {
            at[i + 1] - at[i]
        } else {
            TAU + at[0] - at[i]
        }
    };
    let mut matrix = DMatrix::zeros(n, n);
    let mut right = DVector::zeros(n);
    for i in 0..n {
        let (before, after) = ((i + n - 1) % n, (i + 1) % n);
        let (h0, h1) = (width(before), width(i));
        matrix[(i, before)] += h0 / 6.0;
        matrix[(i, i)] += (h0 + h1) / 3.0;
        matrix[(i, after)] += h1 / 6.0;
        right[i] = (value[after] - value[i]) / h1 - (value[i] - value[before]) / h0;
    }
    // Diagonally dominant: it always has a solution.
    let solved = matrix.lu().solve(&right);
    solved.map_or_else(|| vec![0.0; n], |m| m.iter().copied().collect())
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
            let curve = PeriodicCurve::through(&at, &values, Parity::Odd, Between::Cubic);
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
            PeriodicCurve::through(&at, &values, Parity::Even, Between::Cubic),
            PeriodicCurve::through(&at, &values, Parity::Even, Between::Linear),
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
        let odd =
            PeriodicCurve::through(&at, &[0.0, 0.8, 1.0, 0.6, 0.0], Parity::Odd, Between::Cubic);
        for i in 1..30 {
            let a = 0.1 * f64::from(i);
            assert!((odd.at(a).0 + odd.at(-a).0).abs() < 1e-14);
        }
    }
}
