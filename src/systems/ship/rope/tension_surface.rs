//! Tension at the ship of the rope made fast, as a function of the position of the hang-off point: interpolated in Chebyshev
//! polynomials.

use std::f64::consts::PI;

use crate::ropeway::winch::ShipOffset;
use crate::ropeway::{RopewayError, SolvedRopeway};

/// Polynomials along x and z.
const NX: usize = 48;
const NZ: usize = 8;

/// Width of the surface relative to the range of the record, for records that go further.
const MARGIN: f64 = 1.6;

/// Tension at the ship over the positions of the hang-off point.
pub(super) struct TensionSurface {
    /// Centre and half width along x and z \[m\].
    domain: [(f64, f64); 2],
    /// Coefficients of the products of Chebyshev polynomials, x first.
    coefficients: Vec<[f64; NZ]>,
}

impl TensionSurface {
    /// None where the rope is too short over part of the domain.
    pub(super) fn new(
        worked: &SolvedRopeway,
        series: &[ShipOffset],
    ) -> Result<Option<Self>, RopewayError> {
        let exact = exact_tension(worked)?;
        let domain = [range(series, |p| p.x_m), range(series, |p| p.z_m)];
        let place = |(middle, half): (f64, f64), s: f64| middle + half * s;
        let mut values = vec![[0.0; NZ]; NX];
        for (i, row) in values.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                let (x, z) = (place(domain[0], node(i, NX)), place(domain[1], node(j, NZ)));
                match exact(x, z) {
                    Some(tension) => *value = tension,
                    None => return Ok(None),
                }
            }
        }
        Ok(Some(Self {
            domain,
            coefficients: coefficients(&values),
        }))
    }

    pub(super) fn at(&self, x: f64, z: f64) -> f64 {
        let local = |v: f64, (middle, half): (f64, f64)| ((v - middle) / half).clamp(-1.0, 1.0);
        let (s, t) = (local(x, self.domain[0]), local(z, self.domain[1]));
        let mut rows = [0.0; NX];
        for (out, row) in rows.iter_mut().zip(&self.coefficients) {
            *out = clenshaw(row, t);
        }
        clenshaw(&rows, s)
    }
}

/// The exact tension at the ship \[N\] for a displacement of the hang-off point \[m\]; none where the rope is too short.
pub(super) fn exact_tension(
    worked: &SolvedRopeway,
) -> Result<impl Fn(f64, f64) -> Option<f64> + Sync + '_, RopewayError> {
    let start = worked.equilibrium(worked.ropeway.cargo.position)?;
    Ok(move |x: f64, z: f64| {
        let span = worked.rope.moved(x, z);
        let rest = span.with_cargo_at(start.length_m, start.arc_m);
        rest.ok().map(|rest| rest.ship_n())
    })
}

/// Zero `i` of the Chebyshev polynomial of degree `n`.
fn node(i: usize, n: usize) -> f64 {
    (PI * (i as f64 + 0.5) / n as f64).cos()
}

/// Centre and half width of the range of a series, with the margin.
fn range(series: &[ShipOffset], of: impl Fn(&ShipOffset) -> f64) -> (f64, f64) {
    let low = series.iter().map(&of).fold(f64::INFINITY, f64::min);
    let high = series.iter().map(&of).fold(f64::NEG_INFINITY, f64::max);
    (0.5 * (low + high), (0.5 * MARGIN * (high - low)).max(1e-6))
}

/// Sum of Chebyshev polynomials by Clenshaw's recurrence.
fn clenshaw(coefficients: &[f64], s: f64) -> f64 {
    let (mut one, mut two) = (0.0, 0.0);
    for c in coefficients.iter().skip(1).rev() {
        (one, two) = (c + 2.0 * s * one - two, one);
    }
    coefficients.first().map_or(0.0, |c| c + s * one - two)
}

/// Coefficients from values at the nodes.
fn coefficients(values: &[[f64; NZ]]) -> Vec<[f64; NZ]> {
    let basis = |k: usize, i: usize, n: usize| {
        let weight = if k == 0 { 1.0 } else { 2.0 } / n as f64;
        weight * (PI * k as f64 * (i as f64 + 0.5) / n as f64).cos()
    };
    let mut out = vec![[0.0; NZ]; NX];
    for (k, row) in out.iter_mut().enumerate() {
        for (l, c) in row.iter_mut().enumerate() {
            for (i, line) in values.iter().enumerate() {
                for (j, value) in line.iter().enumerate() {
                    *c += basis(k, i, NX) * basis(l, j, NZ) * value;
                }
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_reproduced() {
        let f = |s: f64, t: f64| 1.0 + s * s * s - 2.0 * s * t + t.powi(4);
        let values: Vec<[f64; NZ]> = (0..NX)
            .map(|i| std::array::from_fn(|j| f(node(i, NX), node(j, NZ))))
            .collect();
        let surface = TensionSurface {
            domain: [(0.0, 1.0); 2],
            coefficients: coefficients(&values),
        };
        for (s, t) in [(0.3, -0.7), (-1.0, 1.0), (0.0, 0.2)] {
            assert!((surface.at(s, t) - f(s, t)).abs() < 1e-12);
        }
    }
}
