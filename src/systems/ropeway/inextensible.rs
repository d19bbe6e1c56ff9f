//! The model behind the tables of the Tianjin paper: the catenary of the unloaded rope with the sag of the working state, and the
//! whole weight of the cargo added to the vertical force at one end.
//!
//! The text of the paper suggests that the 7 m of sag are those of the loaded rope. Its tables agree to the printed
//! digits with the sag of the unloaded rope, `sag = a (cosh(l/2a) - 1)`, H = w a, L = 2a sinh(l/2a), `Tmax = sqrt(H² + (wL/2 + Q)²)`.

use super::unloaded::{SpanGeometry, UnloadedRope};
use super::{RopewayError, roots};

/// The quantities of the tables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InextensibleModel {
    /// The unloaded rope.
    pub rope: UnloadedRope,
    /// Greatest end tension \[N\].
    pub max_tension_n: f64,
}

/// The state with the least of these greatest tensions: "minimum tension" of table 5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MinimumTension {
    /// The tension \[N\].
    pub tension_n: f64,
    /// Sag of the unloaded rope at that length \[m\].
    pub sag_m: f64,
}

impl InextensibleModel {
    /// An unloaded rope with the weight of the whole cargo at the end of greater vertical force.
    #[must_use]
    pub fn new(rope: UnloadedRope, cargo_n: f64) -> Self {
        let (v_a, v_b) = rope.vertical_n();
        Self {
            rope,
            max_tension_n: rope.horizontal_n.hypot(v_a.max(v_b) + cargo_n),
        }
    }
}

/// The least of the greatest tensions over all lengths of the rope.
///
/// # Errors
/// Those of [`UnloadedRope::with_horizontal_tension`].
pub fn minimum_tension(
    geometry: SpanGeometry,
    weight_n_per_m: f64,
    cargo_n: f64,
) -> Result<MinimumTension, RopewayError> {
    let at = |log_tension: f64| {
        let rope =
            UnloadedRope::with_horizontal_tension(geometry, weight_n_per_m, log_tension.exp())?;
        Ok::<_, RopewayError>(InextensibleModel::new(rope, cargo_n))
    };
    // Weight dominates the tension of a slack rope, horizontal tension that of a taut one: the minimum lies between.
    let scale = (weight_n_per_m * geometry.chord_m()).ln();
    let most = (weight_n_per_m * geometry.chord_m() + cargo_n).ln() + 3.0;
    let horizontal = roots::minimum((scale - 3.0, most), |log_tension| {
        Ok(at(log_tension)?.max_tension_n.ln())
    })?;
    let found = at(horizontal)?;
    Ok(MinimumTension {
        tension_n: found.max_tension_n,
        sag_m: found.rope.sag_m(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_5_comes_out_to_the_printed_digits() {
        // Rope; H, Tmax, L, least tension and its sag as printed, with half a unit of their last digits.
        let table = [
            (80.0, 2488.8, 2840.8, (81.6, 0.05), 1725.5, (24.4, 0.05)),
            (60.0, 1410.5, 1826.0, (62.13, 0.0051), 1404.2, (17.8, 0.05)),
            (40.0, 639.7, 1149.12, (43.1, 0.05), 1085.5, (11.34, 0.005)),
        ];
        for (span_m, h, t, length, low, sag) in table {
            let geometry = SpanGeometry {
                span_m,
                rise_m: 0.0,
            };
            let found = InextensibleModel::new(
                UnloadedRope::with_sag(geometry, 21.56, 7.0).unwrap(),
                490.0,
            );
            assert!((found.rope.horizontal_n - h).abs() < 0.051, "{found:?}");
            assert!((found.max_tension_n - t).abs() < 0.02, "{found:?}");
            assert!((found.rope.length_m() - length.0).abs() < length.1);
            let least = minimum_tension(geometry, 21.56, 490.0).unwrap();
            assert!((least.tension_n - low).abs() < 0.05, "{least:?}");
            assert!((least.sag_m - sag.0).abs() < sag.1, "{least:?}");
        }
    }

    #[test]
    fn without_cargo_the_least_tension_is_the_known_one() {
        let geometry = SpanGeometry {
            span_m: 80.0,
            rise_m: 0.0,
        };
        let least = minimum_tension(geometry, 21.56, 0.0).unwrap();
        assert!((least.tension_n / (0.754_44 * 21.56 * 80.0) - 1.0).abs() < 1e-5);
    }
}
