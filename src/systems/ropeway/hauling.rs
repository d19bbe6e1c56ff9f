//! Hauling the unloaded rope out to the ship: end tension against distance from the platform, with the length fixed.
//!
//! Figure 9 of the Tianjin paper, which is lost, may show this. Its text, nearly constant up to 40 m and then growing
//! linearly, agrees but for "linearly": the growth is convex.

use super::elastic::ElasticRope;

/// End tension at a distance of the ship.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HaulingPoint {
    /// Distance of the ship's end from the platform \[m\].
    pub distance_m: f64,
    /// Tension there \[N\].
    pub ship_n: f64,
    /// Horizontal component \[N\].
    pub horizontal_n: f64,
}

/// The unloaded rope of this length hauled out to the span in equal steps from the platform; distances without a
/// solution are left out.
#[must_use]
pub fn haul(span: &ElasticRope, length_m: f64, steps: usize) -> Vec<HaulingPoint> {
    let at = |i: usize| {
        let distance_m = span.geometry.span_m * i as f64 / steps as f64;
        let there = span.moved(distance_m - span.geometry.span_m, 0.0);
        let rest = there.unloaded(length_m).ok()?;
        Some(HaulingPoint {
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
    use crate::ropeway::unloaded::SpanGeometry;

    #[test]
    fn nearly_flat_to_40_m_and_steep_at_80_m() {
        let span = ElasticRope {
            geometry: SpanGeometry {
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
