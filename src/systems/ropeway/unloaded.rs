//! The rope without cargo: the inextensible catenary of the Tianjin paper, eqs (6)-(8), between ends of any height.
//!
//! The paper states the equations at the lowest point; here x and z are from end A, with
//! u = w l / 2H and m = asinh(h / 2a sinh u), a = H/w: the lowest point lies at l/2 - a m.

use super::RopewayError;
use super::roots;

/// Horizontal and vertical distance between the supports.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpanGeometry {
    /// Horizontal distance l \[m\].
    pub span_m: f64,
    /// Height h of end B above end A \[m\].
    pub rise_m: f64,
}

impl SpanGeometry {
    /// Straight distance between the ends \[m\].
    #[must_use]
    pub fn chord_m(&self) -> f64 {
        self.span_m.hypot(self.rise_m)
    }

    /// Height of the straight line between the ends above end A at a distance from it \[m\].
    #[must_use]
    pub fn line_m(&self, x_m: f64) -> f64 {
        self.rise_m * x_m / self.span_m
    }
}

/// An inextensible rope under its own weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnloadedRope {
    /// Distances between the ends.
    pub geometry: SpanGeometry,
    /// Weight per length w \[N/m\].
    pub weight_n_per_m: f64,
    /// Horizontal tension R (or H) \[N\].
    pub horizontal_n: f64,
    /// x of its lowest point, which may lie outside of the span \[m\].
    pub lowest_x_m: f64,
}

impl UnloadedRope {
    /// The rope of this horizontal tension.
    ///
    /// # Errors
    /// [`RopewayError::TooDeep`] where its end forces overflow.
    pub fn with_horizontal_tension(
        geometry: SpanGeometry,
        weight_n_per_m: f64,
        horizontal_n: f64,
    ) -> Result<Self, RopewayError> {
        let a = horizontal_n / weight_n_per_m;
        let u = 0.5 * geometry.span_m / a;
        let m = (geometry.rise_m / (2.0 * a * u.sinh())).asinh();
        let rope = Self {
            geometry,
            weight_n_per_m,
            horizontal_n,
            lowest_x_m: 0.5 * geometry.span_m - a * m,
        };
        let (v_a, v_b) = rope.vertical_n();
        if v_a.is_finite() && v_b.is_finite() && horizontal_n > 0.0 {
            Ok(rope)
        } else {
            Err(RopewayError::TooDeep)
        }
    }

    /// The rope that hangs this far below the straight line between its ends at mid-span:
    /// sag = a cosh m (cosh u - 1).
    ///
    /// # Errors
    /// [`RopewayError::TooDeep`] where its end forces overflow.
    pub fn with_sag(
        geometry: SpanGeometry,
        weight_n_per_m: f64,
        sag_m: f64,
    ) -> Result<Self, RopewayError> {
        let first = weight_n_per_m * geometry.span_m * geometry.span_m / (8.0 * sag_m);
        Self::with_measure(geometry, weight_n_per_m, first, |rope| rope.sag_m() / sag_m)
    }

    /// The rope of this length.
    ///
    /// # Errors
    /// [`RopewayError::TooShort`] where it does not reach, [`RopewayError::TooDeep`] where its end forces overflow.
    pub fn with_length(
        geometry: SpanGeometry,
        weight_n_per_m: f64,
        length_m: f64,
    ) -> Result<Self, RopewayError> {
        let chord_m = geometry.chord_m();
        if length_m <= chord_m * (1.0 + 1e-12) {
            return Err(RopewayError::TooShort { length_m, chord_m });
        }
        let surplus = length_m - chord_m;
        let flat = weight_n_per_m * geometry.span_m * (geometry.span_m / (24.0 * surplus)).sqrt();
        Self::with_measure(geometry, weight_n_per_m, flat, |rope| {
            (rope.length_m() - chord_m) / surplus
        })
    }

    /// The rope at which a measure that decreases with the horizontal tension is one.
    fn with_measure(
        geometry: SpanGeometry,
        weight_n_per_m: f64,
        first: f64,
        measure: impl Fn(&Self) -> f64,
    ) -> Result<Self, RopewayError> {
        let rope = |log_tension: f64| {
            Self::with_horizontal_tension(geometry, weight_n_per_m, log_tension.exp())
        };
        // Too small a tension counts as too deep a rope.
        let f = |log_tension: f64| {
            Ok(rope(log_tension)
                .map_or(f64::MAX, |rope| measure(&rope))
                .ln())
        };
        let (mut low, mut high) = (first.ln() - 0.1, first.ln() + 0.1);
        for _ in 0..60 {
            if f(low)? > 0.0 {
                break;
            }
            low -= 2.0 * (high - low);
        }
        for _ in 0..60 {
            if f(high)? < 0.0 {
                break;
            }
            high += 2.0 * (high - low);
        }
        rope(roots::root(
            (low, high),
            "no horizontal tension gives this shape",
            f,
        )?)
    }

    fn a(&self) -> f64 {
        self.horizontal_n / self.weight_n_per_m
    }

    /// Height above end A, eq. (6) \[m\].
    #[must_use]
    pub fn height_m(&self, x_m: f64) -> f64 {
        let (a, from) = (self.a(), -self.lowest_x_m);
        // cosh p - cosh q, without the digits that a nearly straight rope would lose.
        let (p, q) = ((x_m + from) / a, from / a);
        2.0 * a * (0.5 * (p + q)).sinh() * (0.5 * (p - q)).sinh()
    }

    /// Slope dy/dx, eq. (7) \[-\].
    #[must_use]
    pub fn slope(&self, x_m: f64) -> f64 {
        ((x_m - self.lowest_x_m) / self.a()).sinh()
    }

    /// Tension, eq. (8) \[N\].
    #[must_use]
    pub fn tension_n(&self, x_m: f64) -> f64 {
        self.horizontal_n * ((x_m - self.lowest_x_m) / self.a()).cosh()
    }

    /// Vertical forces of the rope on its ends A and B, downward \[N\].
    #[must_use]
    pub fn vertical_n(&self) -> (f64, f64) {
        (
            -self.horizontal_n * self.slope(0.0),
            self.horizontal_n * self.slope(self.geometry.span_m),
        )
    }

    /// Length \[m\].
    #[must_use]
    pub fn length_m(&self) -> f64 {
        let a = self.a();
        (2.0 * a * (0.5 * self.geometry.span_m / a).sinh()).hypot(self.geometry.rise_m)
    }

    /// Depth below the straight line between the ends at mid-span \[m\].
    #[must_use]
    pub fn sag_m(&self) -> f64 {
        let a = self.a();
        let m = (0.5 * self.geometry.span_m - self.lowest_x_m) / a;
        2.0 * a * m.cosh() * (0.25 * self.geometry.span_m / a).sinh().powi(2)
    }

    /// Weight of the whole rope \[N\].
    #[must_use]
    pub fn weight_n(&self) -> f64 {
        self.weight_n_per_m * self.length_m()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SUPPORTS: SpanGeometry = SpanGeometry {
        span_m: 80.0,
        rise_m: 6.0,
    };

    #[test]
    fn sag_length_and_horizontal_tension_invert_each_other() {
        for horizontal in [30.0, 400.0, 2500.0, 9e5] {
            let rope = UnloadedRope::with_horizontal_tension(SUPPORTS, 21.56, horizontal).unwrap();
            let by_sag = UnloadedRope::with_sag(SUPPORTS, 21.56, rope.sag_m()).unwrap();
            assert!(
                (by_sag.horizontal_n / horizontal - 1.0).abs() < 1e-11,
                "{horizontal}"
            );
            if horizontal < 1e5 {
                let by_length =
                    UnloadedRope::with_length(SUPPORTS, 21.56, rope.length_m()).unwrap();
                assert!(
                    (by_length.horizontal_n / horizontal - 1.0).abs() < 1e-7,
                    "{horizontal}"
                );
            }
        }
    }

    #[test]
    fn forces_balance_and_the_ends_are_where_they_are() {
        let rope = UnloadedRope::with_horizontal_tension(SUPPORTS, 21.56, 900.0).unwrap();
        let (v_a, v_b) = rope.vertical_n();
        assert!((v_a + v_b - rope.weight_n()).abs() < 1e-9);
        assert!(rope.height_m(0.0).abs() < 1e-12);
        assert!((rope.height_m(80.0) - 6.0).abs() < 1e-12);
        let below = SUPPORTS.line_m(40.0) - rope.height_m(40.0);
        assert!((below - rope.sag_m()).abs() < 1e-12);
        assert!((rope.tension_n(80.0) - v_b.hypot(900.0)).abs() < 1e-9);
        let (h, x) = (1e-4, 17.0);
        let slope = (rope.height_m(x + h) - rope.height_m(x - h)) / (2.0 * h);
        assert!((slope - rope.slope(x)).abs() < 1e-8);
    }

    #[test]
    fn a_rope_that_does_not_reach_or_hangs_without_end_is_refused() {
        assert!(matches!(
            UnloadedRope::with_length(SUPPORTS, 21.56, 80.0),
            Err(RopewayError::TooShort { .. })
        ));
        assert_eq!(
            UnloadedRope::with_horizontal_tension(SUPPORTS, 21.56, 1e-9),
            Err(RopewayError::TooDeep)
        );
    }
}
