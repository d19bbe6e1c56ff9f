//! Parabola theory: the path of the cargo and the greatest deflection, the Tianjin paper, eqs (11) and (13).
//!
//! The weight of the rope is uniform along the straight line between the ends. q of eq. (11) must be a weight per
//! length; the paper calls it a mass.

use super::unloaded::SpanGeometry;

/// Weight of the rope and of the cargo.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParabolaLoad {
    /// Weight of the rope per length q \[N/m\].
    pub weight_n_per_m: f64,
    /// Weight of the cargo Q \[N\].
    pub cargo_n: f64,
}

/// Depth of the cargo below the straight line between the ends with the cargo at `x_m` \[m\]; at
/// mid-span and level ends the greatest deflection of eq. (13).
#[must_use]
pub fn sag_m(geometry: SpanGeometry, load: ParabolaLoad, horizontal_n: f64, x_m: f64) -> f64 {
    let secant = geometry.chord_m() / geometry.span_m;
    let by_rope = 0.5 * load.weight_n_per_m * secant / horizontal_n;
    let by_cargo = load.cargo_n / (horizontal_n * geometry.span_m);
    (by_rope + by_cargo) * (geometry.span_m - x_m) * x_m
}

/// Slope of the cargo's path at `x_m`, positive where it climbs towards end B \[-\]: the derivative of eq. (11).
#[must_use]
pub fn slope(geometry: SpanGeometry, load: ParabolaLoad, horizontal_n: f64, x_m: f64) -> f64 {
    let secant = geometry.chord_m() / geometry.span_m;
    let by_rope = 0.5 * load.weight_n_per_m * secant / horizontal_n;
    let by_cargo = load.cargo_n / (horizontal_n * geometry.span_m);
    (by_rope + by_cargo) * (2.0 * x_m - geometry.span_m) + geometry.rise_m / geometry.span_m
}

/// Tensions at the ends A and B with the cargo at `x_m`: half the rope's weight and the cargo's share by the lever, with
/// the horizontal tension \[N\].
#[must_use]
pub fn end_tensions_n(
    geometry: SpanGeometry,
    load: ParabolaLoad,
    horizontal_n: f64,
    x_m: f64,
) -> (f64, f64) {
    let rope = 0.5 * load.weight_n_per_m * geometry.chord_m();
    let share = x_m / geometry.span_m;
    let slope = horizontal_n * geometry.rise_m / geometry.span_m;
    let v_a = rope + load.cargo_n * (1.0 - share) - slope;
    let v_b = rope + load.cargo_n * share + slope;
    (horizontal_n.hypot(v_a), horizontal_n.hypot(v_b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ropeway::loaded::LoadedRope;

    const LOAD: ParabolaLoad = ParabolaLoad {
        weight_n_per_m: 21.56,
        cargo_n: 490.0,
    };

    #[test]
    fn at_mid_span_it_is_eq_13() {
        let geometry = SpanGeometry {
            span_m: 80.0,
            rise_m: 0.0,
        };
        let h = 2488.8;
        let f = 21.56 * 80.0 * 80.0 / (8.0 * h) + 490.0 * 80.0 / (4.0 * h);
        assert!((sag_m(geometry, LOAD, h, 40.0) - f).abs() < 1e-12);
        // With this horizontal tension the cargo hangs 10.9 m deep, not 7 m.
        assert!((f - 10.87).abs() < 0.01);
    }

    #[test]
    fn the_slope_is_that_of_the_path() {
        let geometry = SpanGeometry {
            span_m: 80.0,
            rise_m: 5.0,
        };
        let (h, step) = (2488.8, 1e-4);
        let height = |x: f64| geometry.rise_m * x / geometry.span_m - sag_m(geometry, LOAD, h, x);
        for x in [5.0, 40.0, 70.0] {
            let difference = (height(x + step) - height(x - step)) / (2.0 * step);
            assert!(
                (slope(geometry, LOAD, h, x) - difference).abs() < 1e-8,
                "{x}"
            );
        }
    }

    #[test]
    fn a_tight_rope_is_a_parabola() {
        let geometry = SpanGeometry {
            span_m: 80.0,
            rise_m: 8.0,
        };
        for x in [10.0, 40.0, 71.0] {
            let h = 1e6;
            let exact =
                LoadedRope::with_horizontal_tension(geometry, 21.56, h, (x, 490.0)).unwrap();
            let sag = sag_m(geometry, LOAD, h, x);
            assert!((exact.sag_m() / sag - 1.0).abs() < 1e-3, "{x}");
            let ends = end_tensions_n(geometry, LOAD, h, x);
            assert!((exact.end_tensions_n().0 / ends.0 - 1.0).abs() < 1e-5);
            assert!((exact.end_tensions_n().1 / ends.1 - 1.0).abs() < 1e-5);
        }
    }
}
