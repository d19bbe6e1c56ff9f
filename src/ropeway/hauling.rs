//! Hauling the bare rope out to the ship: its end tension against the distance off the platform, with the length fixed.
//!
//! What figure 9 of the Tianjin paper may show; the figure is lost. Its words, nearly flat up to 40 m and then growing,
//! fit this; "linearly" does not: the growth is convex.

use super::exact::Span;

/// End tension at the ship at a distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Haul {
    /// Distance of the ship's end off the platform \[m\].
    pub distance_m: f64,
    /// Tension there \[N\].
    pub ship_n: f64,
    /// Horizontal part of it: what pulls the ship in \[N\].
    pub horizontal_n: f64,
}

/// The bare rope of this length hauled out to the span in so many equal steps, from the platform on; distances at
/// which it has no answer are left out.
#[must_use]
pub fn haul(span: &Span, length_m: f64, steps: usize) -> Vec<Haul> {
    let at = |i: usize| {
        let distance_m = span.gap.span_m * i as f64 / steps as f64;
        let there = span.moved(distance_m - span.gap.span_m, 0.0);
        let rest = there.bare(length_m).ok()?;
        Some(Haul {
            distance_m,
            ship_n: rest.tension_b_n(),
            horizontal_n: rest.h_b_n,
        })
    };
    (0..=steps).filter_map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ropeway::bare::Gap;

    #[test]
    fn nearly_flat_to_40_m_and_steep_at_80_m() {
        let span = Span {
            gap: Gap {
                span_m: 80.0,
                rise_m: 0.0,
            },
            weight_n_per_m: 21.56,
            ea_n: 1e12,
            cargo_n: 490.0,
        };
        let hauls = haul(&span, 81.611, 8);
        // A rope hanging double carries half its weight at either end.
        assert!((hauls[0].ship_n - 0.5 * 21.56 * 81.611).abs() < 1e-3);
        assert!(hauls[4].ship_n < 1.15 * hauls[0].ship_n);
        assert!(hauls[8].ship_n > 2.9 * hauls[0].ship_n);
        let rise = |i: usize| hauls[i].ship_n - hauls[i - 1].ship_n;
        assert!(rise(8) > 2.0 * rise(7), "{hauls:?}");
    }
}
