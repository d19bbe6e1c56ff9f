//! How far a ship lies from its anchor: the reach of an elastic line over a flat bed at a given pull.

use crate::numerics::roots::Bracket;
use crate::statics::catenary::{Bed, CatenaryError, Ends, Line, SectionProps};

use super::model::{Mooring, Particulars};

/// The line at rest under a pull.
#[derive(Debug, Clone, PartialEq)]
pub struct MooringSolution {
    /// Horizontal distance from the anchor to the point on the ship \[m\].
    pub distance: f64,
    /// Stiffness of the line along itself, in the horizontal \[N/m\].
    pub along: f64,
    /// Stiffness across: pull over distance \[N/m\].
    pub across: f64,
    /// Tension at the ship \[N\].
    pub tension: f64,
    /// Angle of the line at the ship below the horizontal \[rad\].
    pub angle: f64,
    /// Length resting on the bed \[m\].
    pub grounded_length: f64,
    /// Pull of the line up on the anchor \[N\]; an anchor that is lifted drags.
    pub anchor_uplift: f64,
}

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MooringError {
    /// The line is too short to come up to the ship.
    #[error("the line of {length} m does not reach from the bed to the ship, {height} m above it")]
    Short {
        /// Length \[m\].
        length: f64,
        /// Height of the ship's point above the bed \[m\].
        height: f64,
    },
    /// The pull could not be met.
    #[error("no distance from the anchor was found at which the line pulls with {pull:.4e} N")]
    Unmet {
        /// The pull \[N\].
        pull: f64,
    },
    /// The catenary refused.
    #[error(transparent)]
    Catenary(#[from] CatenaryError),
}

/// The line's reach at a horizontal pull \[N\], which rises with the distance.
///
/// # Errors
/// [`MooringError`].
pub fn reach(
    particulars: &Particulars,
    mooring: &Mooring,
    pull: f64,
) -> Result<MooringSolution, MooringError> {
    let height = mooring.depth_m + mooring.fairlead_z_m;
    let length = mooring.length_m;
    if length <= height {
        return Err(MooringError::Short { length, height });
    }
    let weight = mooring.wet_weight_kg_per_m * particulars.gravity_m_per_s2;
    let sections = [SectionProps::new(length, weight, mooring.ea_n)];
    let at = |x_m: f64| {
        Line {
            ends: Ends { x_m, z_m: height },
            sections: &sections,
            bed: Some(Bed::default()),
            surface_above_a_m: None,
        }
        .solve()
    };
    // Slack, the line hangs straight down and the rest lies on the bed; taut, it is straight and stretched.
    let stretched = length * (1.0 + (pull + weight * length) / mooring.ea_n);
    let mut bracket = Bracket {
        low: 0.0,
        high: stretched.hypot(height),
    };
    let mut x = (length * length - height * height).sqrt();
    for _ in 0..200 {
        let rest = at(x)?;
        let miss = rest.h_b_n - pull;
        let slope = rest.stiffness_n_per_m[0][0];
        bracket.shrink(x, miss);
        let next = bracket.newton(x, miss, slope);
        if miss.abs() <= 1e-9 * pull || (bracket.high - bracket.low) <= 1e-12 * bracket.high {
            return Ok(MooringSolution {
                distance: x,
                along: slope,
                across: pull / x.max(f64::MIN_POSITIVE),
                tension: rest.tension_b_n(),
                angle: rest.v_b_n.atan2(rest.h_b_n),
                grounded_length: rest.on_bed_m,
                anchor_uplift: rest.v_a_n.max(0.0),
            });
        }
        x = next;
    }
    Err(MooringError::Unmet { pull })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn particulars() -> Particulars {
        toml_edit::de::from_str("title = \"\"\nlength_m = 50.0\ndraft_m = 2.0\n").unwrap()
    }

    fn mooring() -> Mooring {
        Mooring {
            length_m: 100.0,
            wet_weight_kg_per_m: 20.0,
            ea_n: 1e12,
            depth_m: 10.0,
            fairlead_z_m: 0.0,
        }
    }

    #[test]
    fn the_reach_is_that_of_the_stiff_catenary_on_a_bed() {
        let (particulars, mooring) = (particulars(), mooring());
        for pull in [2e3, 8e3, 2e4] {
            let found = reach(&particulars, &mooring, pull).unwrap();
            let w = 20.0 * particulars.gravity_m_per_s2;
            let a = pull / w;
            // h = a (cosh(x/a) - 1), s = a sinh(x/a).
            let up = a * (1.0 + 10.0 / a).acosh();
            let hung = a * (up / a).sinh();
            let expected = 100.0 - hung + up;
            assert!(
                (found.distance - expected).abs() < 1e-4,
                "{found:?} {expected}"
            );
            assert!((found.tension - (pull + w * 10.0)).abs() < 1e-3 * pull);
            assert!((found.grounded_length - (100.0 - hung)).abs() < 1e-2);
            assert_eq!(found.anchor_uplift, 0.0);
        }
    }

    #[test]
    fn a_line_pulled_taut_lifts_its_anchor_and_a_short_one_is_refused() {
        let (particulars, mut mooring) = (particulars(), mooring());
        let taut = reach(&particulars, &mooring, 1e6).unwrap();
        assert!(taut.anchor_uplift > 0.0 && taut.grounded_length == 0.0);
        assert!(taut.along > 1e4);
        let slack = reach(&particulars, &mooring, 0.0).unwrap();
        assert!(slack.distance >= 0.0 && slack.tension > 0.0);
        mooring.length_m = 9.0;
        assert!(matches!(
            reach(&particulars, &mooring, 1e3),
            Err(MooringError::Short { .. })
        ));
    }
}
