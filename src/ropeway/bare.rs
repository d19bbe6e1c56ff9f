//! The rope without cargo: the catenary of the Tianjin paper, eqs (6)-(8), between ends of any height.
//!
//! It cannot stretch. The equations stand at its lowest point; here they are seen from end A, with
//! u = w l / 2H and m = asinh(h / 2a sinh u), a = H/w: the lowest point lies at l/2 - a m.

use super::Trouble;
use super::search;

/// What lies between the ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Horizontal distance l \[m\].
    pub span_m: f64,
    /// Height h of end B above end A \[m\].
    pub rise_m: f64,
}

impl Gap {
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

/// A rope that hangs by its own weight and cannot stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bare {
    /// What it spans.
    pub gap: Gap,
    /// Weight per length w \[N/m\].
    pub weight_n_per_m: f64,
    /// Horizontal pull R (or H) \[N\].
    pub horizontal_n: f64,
    /// x of its lowest point, which may lie outside of the span \[m\].
    pub lowest_x_m: f64,
}

impl Bare {
    /// The rope with this horizontal pull.
    ///
    /// # Errors
    /// [`Trouble::TooDeep`] where its end forces are no numbers any more.
    pub fn with_pull(gap: Gap, weight_n_per_m: f64, horizontal_n: f64) -> Result<Self, Trouble> {
        let a = horizontal_n / weight_n_per_m;
        let u = 0.5 * gap.span_m / a;
        let m = (gap.rise_m / (2.0 * a * u.sinh())).asinh();
        let rope = Self {
            gap,
            weight_n_per_m,
            horizontal_n,
            lowest_x_m: 0.5 * gap.span_m - a * m,
        };
        let (v_a, v_b) = rope.vertical_n();
        if v_a.is_finite() && v_b.is_finite() && horizontal_n > 0.0 {
            Ok(rope)
        } else {
            Err(Trouble::TooDeep)
        }
    }

    /// The rope that hangs this far below the straight line between its ends at mid-span:
    /// sag = a cosh m (cosh u - 1).
    ///
    /// # Errors
    /// [`Trouble::TooDeep`] where that is further than numbers reach.
    pub fn with_sag(gap: Gap, weight_n_per_m: f64, sag_m: f64) -> Result<Self, Trouble> {
        let first = weight_n_per_m * gap.span_m * gap.span_m / (8.0 * sag_m);
        Self::search(gap, weight_n_per_m, first, |rope| rope.sag_m() / sag_m)
    }

    /// The rope of this length.
    ///
    /// # Errors
    /// [`Trouble::TooShort`] where it does not reach, [`Trouble::TooDeep`] where it is so long that numbers end.
    pub fn with_length(gap: Gap, weight_n_per_m: f64, length_m: f64) -> Result<Self, Trouble> {
        let chord_m = gap.chord_m();
        if length_m <= chord_m * (1.0 + 1e-12) {
            return Err(Trouble::TooShort { length_m, chord_m });
        }
        let surplus = length_m - chord_m;
        let flat = weight_n_per_m * gap.span_m * (gap.span_m / (24.0 * surplus)).sqrt();
        Self::search(gap, weight_n_per_m, flat, |rope| {
            (rope.length_m() - chord_m) / surplus
        })
    }

    /// The pull at which a measure that falls as the pull grows is one.
    fn search(
        gap: Gap,
        weight_n_per_m: f64,
        first: f64,
        measure: impl Fn(&Self) -> f64,
    ) -> Result<Self, Trouble> {
        let rope = |log_pull: f64| Self::with_pull(gap, weight_n_per_m, log_pull.exp());
        // Too small a pull is too deep a rope: it counts as such.
        let f = |log_pull: f64| Ok(rope(log_pull).map_or(f64::MAX, |rope| measure(&rope)).ln());
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
        rope(search::root((low, high), "no pull gives this shape", f)?)
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

    /// Vertical forces of the rope on its ends A and B, downwards \[N\].
    #[must_use]
    pub fn vertical_n(&self) -> (f64, f64) {
        (
            -self.horizontal_n * self.slope(0.0),
            self.horizontal_n * self.slope(self.gap.span_m),
        )
    }

    /// Length \[m\].
    #[must_use]
    pub fn length_m(&self) -> f64 {
        let a = self.a();
        (2.0 * a * (0.5 * self.gap.span_m / a).sinh()).hypot(self.gap.rise_m)
    }

    /// Depth below the straight line between the ends at mid-span \[m\].
    #[must_use]
    pub fn sag_m(&self) -> f64 {
        let a = self.a();
        let m = (0.5 * self.gap.span_m - self.lowest_x_m) / a;
        2.0 * a * m.cosh() * (0.25 * self.gap.span_m / a).sinh().powi(2)
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

    const GAP: Gap = Gap {
        span_m: 80.0,
        rise_m: 6.0,
    };

    #[test]
    fn sag_length_and_pull_lead_back_to_each_other() {
        for pull in [30.0, 400.0, 2500.0, 9e5] {
            let rope = Bare::with_pull(GAP, 21.56, pull).unwrap();
            let by_sag = Bare::with_sag(GAP, 21.56, rope.sag_m()).unwrap();
            assert!((by_sag.horizontal_n / pull - 1.0).abs() < 1e-11, "{pull}");
            if pull < 1e5 {
                let by_length = Bare::with_length(GAP, 21.56, rope.length_m()).unwrap();
                assert!((by_length.horizontal_n / pull - 1.0).abs() < 1e-7, "{pull}");
            }
        }
    }

    #[test]
    fn forces_balance_and_the_ends_are_where_they_are() {
        let rope = Bare::with_pull(GAP, 21.56, 900.0).unwrap();
        let (v_a, v_b) = rope.vertical_n();
        assert!((v_a + v_b - rope.weight_n()).abs() < 1e-9);
        assert!(rope.height_m(0.0).abs() < 1e-12);
        assert!((rope.height_m(80.0) - 6.0).abs() < 1e-12);
        let below = GAP.line_m(40.0) - rope.height_m(40.0);
        assert!((below - rope.sag_m()).abs() < 1e-12);
        assert!((rope.tension_n(80.0) - v_b.hypot(900.0)).abs() < 1e-9);
        let (h, x) = (1e-4, 17.0);
        let slope = (rope.height_m(x + h) - rope.height_m(x - h)) / (2.0 * h);
        assert!((slope - rope.slope(x)).abs() < 1e-8);
    }

    #[test]
    fn a_rope_that_does_not_reach_or_hangs_without_end_is_refused() {
        assert!(matches!(
            Bare::with_length(GAP, 21.56, 80.0),
            Err(Trouble::TooShort { .. })
        ));
        assert_eq!(Bare::with_pull(GAP, 21.56, 1e-9), Err(Trouble::TooDeep));
    }
}
