//! The inextensible rope with the cargo on it: two catenaries that meet at the cargo, of the same horizontal tension;
//! mean tensions of both parts by the Tianjin paper, eqs (9)-(10), corrected.
//!
//! As printed, the equations take k as the ratio AD/DB, also in the second argument; they follow from eq. (8) with
//! k = AD/l0 and without it there:
//! `Tm = R/2S (l + R/w sinh(wl/R) cosh(w (l - 2 xc)/R))`, S the part's length, l its span, xc its lowest point.

use super::unloaded::{SpanGeometry, UnloadedRope};
use super::{RopewayError, roots};

/// An inextensible rope with the cargo on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadedRope {
    /// The part from end A to the cargo.
    pub left: UnloadedRope,
    /// The part from the cargo to end B.
    pub right: UnloadedRope,
    /// Weight of the cargo \[N\].
    pub cargo_n: f64,
}

impl LoadedRope {
    /// The rope of this horizontal tension, the cargo at `x_m` from end A, inside the span.
    ///
    /// # Errors
    /// Those of [`UnloadedRope::with_horizontal_tension`].
    pub fn with_horizontal_tension(
        geometry: SpanGeometry,
        weight_n_per_m: f64,
        horizontal_n: f64,
        cargo: (f64, f64),
    ) -> Result<Self, RopewayError> {
        let (x_m, cargo_n) = cargo;
        let parts = |height: f64| {
            let (first, second) = cut(geometry, x_m, height);
            let part = |geometry| {
                UnloadedRope::with_horizontal_tension(geometry, weight_n_per_m, horizontal_n)
            };
            Ok::<_, RopewayError>((part(first)?, part(second)?))
        };
        // Vertical force of both parts at the cargo less its weight; it grows as the cargo sinks.
        let surplus = |height: f64| {
            let (left, right) = parts(height)?;
            let rise = |part: &UnloadedRope| part.vertical_n();
            Ok(-(rise(&left).1 + rise(&right).0) - cargo_n)
        };
        // Without rope weight the cargo hangs here; rope weight lowers it by no more than the sag of the unloaded rope there.
        let unloaded =
            UnloadedRope::with_horizontal_tension(geometry, weight_n_per_m, horizontal_n)?;
        let straight = cargo_n * x_m * (geometry.span_m - x_m) / (geometry.span_m * horizontal_n);
        let rope = geometry.line_m(x_m) - unloaded.height_m(x_m);
        let reach = 2.0 * (straight + rope) + 1e-6 * geometry.span_m;
        let top = geometry.line_m(x_m) - 0.5 * rope.min(straight);
        let height = roots::root(
            (top, top - reach),
            "no height of the cargo is in equilibrium",
            surplus,
        )?;
        let (left, right) = parts(height)?;
        Ok(Self {
            left,
            right,
            cargo_n,
        })
    }

    /// The rope with this sag of the cargo below the straight line between the ends \[m\].
    ///
    /// # Errors
    /// Those of [`UnloadedRope::with_horizontal_tension`].
    pub fn with_sag(
        geometry: SpanGeometry,
        weight_n_per_m: f64,
        cargo: (f64, f64),
        sag_m: f64,
    ) -> Result<Self, RopewayError> {
        let at = |log_tension: f64| {
            Self::with_horizontal_tension(geometry, weight_n_per_m, log_tension.exp(), cargo)
        };
        let (x, q) = cargo;
        let first =
            (x * (geometry.span_m - x) * (0.5 * weight_n_per_m + q / geometry.span_m) / sag_m).ln();
        let f = |log_tension: f64| Ok(at(log_tension).map_or(f64::MAX, |l| l.sag_m() / sag_m).ln());
        let horizontal = roots::root(
            (first - 3.0, first + 3.0),
            "no horizontal tension gives this sag",
            f,
        )?;
        at(horizontal)
    }

    /// Horizontal tension \[N\].
    #[must_use]
    pub fn horizontal_n(&self) -> f64 {
        self.left.horizontal_n
    }

    /// Depth of the cargo below the straight line between the ends \[m\].
    #[must_use]
    pub fn sag_m(&self) -> f64 {
        let (l, r) = (&self.left.geometry, &self.right.geometry);
        (l.rise_m + r.rise_m) * l.span_m / (l.span_m + r.span_m) - l.rise_m
    }

    /// Length of the whole rope \[m\].
    #[must_use]
    pub fn length_m(&self) -> f64 {
        self.left.length_m() + self.right.length_m()
    }

    /// Tensions at the ends A and B \[N\].
    #[must_use]
    pub fn end_tensions_n(&self) -> (f64, f64) {
        (
            self.left.tension_n(0.0),
            self.right.tension_n(self.right.geometry.span_m),
        )
    }

    /// Mean tensions of both parts over their lengths, eqs (9) and (10) \[N\].
    #[must_use]
    pub fn mean_tensions_n(&self) -> (f64, f64) {
        (mean_tension_n(&self.left), mean_tension_n(&self.right))
    }
}

/// Mean tension of a part over its length \[N\].
fn mean_tension_n(part: &UnloadedRope) -> f64 {
    let (r, l) = (part.horizontal_n, part.geometry.span_m);
    let a = r / part.weight_n_per_m;
    0.5 * r / part.length_m() * (l + a * (l / a).sinh() * ((l - 2.0 * part.lowest_x_m) / a).cosh())
}

/// Distances from end A to a point at this height, and from there to end B.
fn cut(geometry: SpanGeometry, x_m: f64, height_m: f64) -> (SpanGeometry, SpanGeometry) {
    (
        SpanGeometry {
            span_m: x_m,
            rise_m: height_m,
        },
        SpanGeometry {
            span_m: geometry.span_m - x_m,
            rise_m: geometry.rise_m - height_m,
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn geometry(span_m: f64) -> SpanGeometry {
        SpanGeometry {
            span_m,
            rise_m: 0.0,
        }
    }

    #[test]
    fn with_the_cargo_at_mid_span_and_7_m_of_sag_in_all_the_pull_is_half_as_high_again() {
        // By two catenaries; to be held against table 5 of the Tianjin paper, whose 7 m are those of the unloaded rope.
        let known = [
            (80.0, 3890.5, 4049.1, 81.377),
            (60.0, 2463.0, 2626.0, 61.780),
            (40.0, 1343.6, 1516.7, 42.542),
        ];
        for (span, horizontal, end, length) in known {
            let rope =
                LoadedRope::with_sag(geometry(span), 21.56, (0.5 * span, 490.0), 7.0).unwrap();
            assert!((rope.horizontal_n() - horizontal).abs() < 0.06, "{rope:?}");
            assert!((rope.end_tensions_n().0 - end).abs() < 0.06);
            assert!((rope.length_m() - length).abs() < 6e-4);
        }
    }

    #[test]
    fn mean_tensions_are_the_integrals_of_the_tension_along_the_rope() {
        let uneven = SpanGeometry {
            span_m: 60.0,
            rise_m: 5.0,
        };
        let rope =
            LoadedRope::with_horizontal_tension(uneven, 21.56, 800.0, (17.0, 490.0)).unwrap();
        for (part, mean) in [
            (rope.left, rope.mean_tensions_n().0),
            (rope.right, rope.mean_tensions_n().1),
        ] {
            let n = 20_000;
            let step = part.geometry.span_m / f64::from(n);
            let sum: f64 = (0..n)
                .map(|i| {
                    let x = (f64::from(i) + 0.5) * step;
                    part.tension_n(x) * part.slope(x).hypot(1.0) * step
                })
                .sum();
            assert!((sum / part.length_m() / mean - 1.0).abs() < 1e-8);
        }
    }

    #[test]
    fn the_cargo_is_held_up_wherever_it_hangs() {
        for x in [0.01, 3.0, 40.0, 79.0] {
            let rope =
                LoadedRope::with_horizontal_tension(geometry(80.0), 21.56, 2000.0, (x, 490.0))
                    .unwrap();
            let held = rope.left.vertical_n().0 + rope.right.vertical_n().1;
            let weight = rope.left.weight_n() + rope.right.weight_n() + 490.0;
            assert!((held - weight).abs() < 1e-7 * weight, "{x}");
        }
    }
}
