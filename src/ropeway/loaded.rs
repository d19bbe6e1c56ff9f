//! The rope with the cargo on it: two catenaries that meet at the cargo, with the same horizontal pull;
//! mean tensions of both parts by the Tianjin paper, eqs (9)-(10), corrected.
//!
//! Neither part stretches. As printed, the equations take k for the ratio AD/DB and carry it into the second argument;
//! they follow from eq. (8) with k = AD/l0 and without it:
//! `Tm = R/2S (l + R/w sinh(wl/R) cosh(w (l - 2 xc)/R))`, S the part's length, l its span, xc its lowest point.

use super::bare::{Bare, Gap};
use super::{Trouble, search};

/// A rope with cargo, that cannot stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loaded {
    /// The part from end A to the cargo.
    pub left: Bare,
    /// The part from the cargo to end B.
    pub right: Bare,
    /// Weight of the cargo \[N\].
    pub cargo_n: f64,
}

impl Loaded {
    /// The rope with this horizontal pull, the cargo at `x_m` from end A, inside the span.
    ///
    /// # Errors
    /// Those of [`Bare::with_pull`].
    pub fn with_pull(
        gap: Gap,
        weight_n_per_m: f64,
        horizontal_n: f64,
        cargo: (f64, f64),
    ) -> Result<Self, Trouble> {
        let (x_m, cargo_n) = cargo;
        let parts = |height: f64| {
            let (first, second) = cut(gap, x_m, height);
            let part = |gap| Bare::with_pull(gap, weight_n_per_m, horizontal_n);
            Ok::<_, Trouble>((part(first)?, part(second)?))
        };
        // Surplus of what both parts hold up at the cargo; it grows as the cargo sinks.
        let held = |height: f64| {
            let (left, right) = parts(height)?;
            let rise = |part: &Bare| part.vertical_n();
            Ok(-(rise(&left).1 + rise(&right).0) - cargo_n)
        };
        // Without rope weight the cargo hangs here; rope weight lowers it by no more than the bare rope's sag there.
        let bare = Bare::with_pull(gap, weight_n_per_m, horizontal_n)?;
        let straight = cargo_n * x_m * (gap.span_m - x_m) / (gap.span_m * horizontal_n);
        let rope = gap.line_m(x_m) - bare.height_m(x_m);
        let reach = 2.0 * (straight + rope) + 1e-6 * gap.span_m;
        let top = gap.line_m(x_m) - 0.5 * rope.min(straight);
        let height = search::root(
            (top, top - reach),
            "no place of the cargo is in balance",
            held,
        )?;
        let (left, right) = parts(height)?;
        Ok(Self {
            left,
            right,
            cargo_n,
        })
    }

    /// The rope with the cargo this far below the straight line between the ends.
    ///
    /// # Errors
    /// Those of [`Bare::with_pull`].
    pub fn with_sag(
        gap: Gap,
        weight_n_per_m: f64,
        cargo: (f64, f64),
        sag_m: f64,
    ) -> Result<Self, Trouble> {
        let at = |log_pull: f64| Self::with_pull(gap, weight_n_per_m, log_pull.exp(), cargo);
        let (x, q) = cargo;
        let first = (x * (gap.span_m - x) * (0.5 * weight_n_per_m + q / gap.span_m) / sag_m).ln();
        let f = |log_pull: f64| Ok(at(log_pull).map_or(f64::MAX, |l| l.sag_m() / sag_m).ln());
        let pull = search::root((first - 3.0, first + 3.0), "no pull gives this sag", f)?;
        at(pull)
    }

    /// Horizontal pull \[N\].
    #[must_use]
    pub fn horizontal_n(&self) -> f64 {
        self.left.horizontal_n
    }

    /// Depth of the cargo below the straight line between the ends \[m\].
    #[must_use]
    pub fn sag_m(&self) -> f64 {
        let (l, r) = (&self.left.gap, &self.right.gap);
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
            self.right.tension_n(self.right.gap.span_m),
        )
    }

    /// Mean tensions of both parts over their lengths, eqs (9) and (10) \[N\].
    #[must_use]
    pub fn mean_tensions_n(&self) -> (f64, f64) {
        (mean_tension_n(&self.left), mean_tension_n(&self.right))
    }
}

/// Mean tension of a part over its length \[N\].
fn mean_tension_n(part: &Bare) -> f64 {
    let (r, l) = (part.horizontal_n, part.gap.span_m);
    let a = r / part.weight_n_per_m;
    0.5 * r / part.length_m() * (l + a * (l / a).sinh() * ((l - 2.0 * part.lowest_x_m) / a).cosh())
}

/// What lies before and behind a point at this height above end A.
fn cut(gap: Gap, x_m: f64, height_m: f64) -> (Gap, Gap) {
    (
        Gap {
            span_m: x_m,
            rise_m: height_m,
        },
        Gap {
            span_m: gap.span_m - x_m,
            rise_m: gap.rise_m - height_m,
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gap(span_m: f64) -> Gap {
        Gap {
            span_m,
            rise_m: 0.0,
        }
    }

    #[test]
    fn with_the_cargo_at_mid_span_and_7_m_of_sag_in_all_the_pull_is_half_as_high_again() {
        // By two catenaries; to be held against table 5 of the Tianjin paper, whose 7 m are those of the bare rope.
        let known = [
            (80.0, 3890.5, 4049.1, 81.377),
            (60.0, 2463.0, 2626.0, 61.780),
            (40.0, 1343.6, 1516.7, 42.542),
        ];
        for (span, pull, end, length) in known {
            let rope = Loaded::with_sag(gap(span), 21.56, (0.5 * span, 490.0), 7.0).unwrap();
            assert!((rope.horizontal_n() - pull).abs() < 0.06, "{rope:?}");
            assert!((rope.end_tensions_n().0 - end).abs() < 0.06);
            assert!((rope.length_m() - length).abs() < 6e-4);
        }
    }

    #[test]
    fn mean_tensions_are_the_integrals_of_the_tension_along_the_rope() {
        let uneven = Gap {
            span_m: 60.0,
            rise_m: 5.0,
        };
        let rope = Loaded::with_pull(uneven, 21.56, 800.0, (17.0, 490.0)).unwrap();
        for (part, mean) in [
            (rope.left, rope.mean_tensions_n().0),
            (rope.right, rope.mean_tensions_n().1),
        ] {
            let n = 20_000;
            let step = part.gap.span_m / f64::from(n);
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
            let rope = Loaded::with_pull(gap(80.0), 21.56, 2000.0, (x, 490.0)).unwrap();
            let held = rope.left.vertical_n().0 + rope.right.vertical_n().1;
            let weight = rope.left.weight_n() + rope.right.weight_n() + 490.0;
            assert!((held - weight).abs() < 1e-7 * weight, "{x}");
        }
    }
}
