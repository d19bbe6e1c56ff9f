//! The mooring line: an elastic catenary on a flat seabed at a given horizontal pull.

use crate::numerics::roots::Bracket;
use crate::statics::catenary::{
    CatenaryError, CatenaryLine, EndOffset, RigidBed, SectionProperties,
};

use super::model::{Mooring, Particulars};

/// The mooring line in equilibrium under a horizontal pull.
#[derive(Debug, Clone, PartialEq)]
pub struct MooringSolution {
    /// Horizontal extent, from the anchor to the fairlead \[m\].
    pub distance: f64,
    /// Horizontal stiffness in the direction of the line \[N/m\].
    pub stiffness_along: f64,
    /// Horizontal stiffness across the line: pull over horizontal extent \[N/m\].
    pub stiffness_across: f64,
    /// Tension at the fairlead \[N\].
    pub tension: f64,
    /// Angle of the line at the fairlead below the horizontal \[rad\].
    pub angle: f64,
    /// Length on the seabed \[m\].
    pub grounded_length: f64,
    /// Vertical force up on the anchor \[N\]; a drag anchor may drag under uplift.
    pub anchor_uplift: f64,
}

/// Why the mooring line has no solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MooringError {
    /// The line is shorter than the height of the fairlead above the seabed.
    #[error("the line of {length} m is too short for a fairlead {height} m above the seabed")]
    TooShort {
        /// Length \[m\].
        length: f64,
        /// Height of the fairlead above the seabed \[m\].
        height: f64,
    },
    /// The iteration for the pull did not converge.
    #[error("the horizontal extent at which the line pulls with {pull:.4e} N was not found")]
    NotConverged {
        /// The pull \[N\].
        pull: f64,
    },
    /// The catenary has no solution.
    #[error(transparent)]
    Catenary(#[from] CatenaryError),
}

/// Solves the line for a horizontal pull \[N\], which increases with the horizontal extent: Newton in a bracket.
///
/// # Errors
/// [`MooringError`].
pub fn solve_mooring(
    particulars: &Particulars,
    mooring: &Mooring,
    pull: f64,
) -> Result<MooringSolution, MooringError> {
    let height = mooring.depth_m + mooring.fairlead_z_m;
    let length = mooring.length_m;
    if length <= height {
        return Err(MooringError::TooShort { length, height });
    }
    let weight = mooring.wet_weight_kg_per_m * particulars.gravity_m_per_s2;
    let sections = [SectionProperties::new(length, weight, mooring.ea_n)];
    let at = |x_m: f64| {
        CatenaryLine {
            ends: EndOffset { x_m, z_m: height },
            sections: &sections,
            bed: Some(RigidBed::default()),
            surface_above_a_m: None,
        }
        .solve()
    };
    // From slack, hanging vertically with the rest on the seabed, to taut, straight and stretched.
    let stretched = length * (1.0 + (pull + weight * length) / mooring.ea_n);
    let mut bracket = Bracket {
        low: 0.0,
        high: stretched.hypot(height),
    };
    let mut x = (length * length - height * height).sqrt();
    for _ in 0..200 {
        let line = at(x)?;
        let residual = line.h_b_n - pull;
        let stiffness = line.stiffness_n_per_m[0][0];
        bracket.shrink(x, residual);
        let next = bracket.newton(x, residual, stiffness);
        if residual.abs() <= 1e-9 * pull || (bracket.high - bracket.low) <= 1e-12 * bracket.high {
            return Ok(MooringSolution {
                distance: x,
                stiffness_along: stiffness,
                stiffness_across: pull / x.max(f64::MIN_POSITIVE),
                tension: line.tension_b_n(),
                angle: line.v_b_n.atan2(line.h_b_n),
                grounded_length: line.on_bed_m,
                anchor_uplift: line.v_a_n.max(0.0),
            });
        }
        x = next;
    }
    Err(MooringError::NotConverged { pull })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn particulars() -> Particulars {
        Particulars {
            length_m: 50.0,
            draft_m: 2.0,
            ..Particulars::default()
        }
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
    fn the_extent_is_that_of_the_inextensible_catenary_on_a_seabed() {
        let (particulars, mooring) = (particulars(), mooring());
        for pull in [2e3, 8e3, 2e4] {
            let found = solve_mooring(&particulars, &mooring, pull).unwrap();
            let w = 20.0 * particulars.gravity_m_per_s2;
            let a = pull / w;
            // h = a (cosh(x/a) - 1), s = a sinh(x/a).
            let up = a * (1.0 + 10.0 / a).acosh();
            let suspended = a * (up / a).sinh();
            let expected = 100.0 - suspended + up;
            assert!(
                (found.distance - expected).abs() < 1e-4,
                "{found:?} {expected}"
            );
            assert!((found.tension - (pull + w * 10.0)).abs() < 1e-3 * pull);
            assert!((found.grounded_length - (100.0 - suspended)).abs() < 1e-2);
            assert_eq!(found.anchor_uplift, 0.0);
        }
    }

    #[test]
    fn a_taut_line_lifts_its_anchor_and_a_short_one_is_an_error() {
        let (particulars, mut mooring) = (particulars(), mooring());
        let taut = solve_mooring(&particulars, &mooring, 1e6).unwrap();
        assert!(taut.anchor_uplift > 0.0 && taut.grounded_length == 0.0);
        assert!(taut.stiffness_along > 1e4);
        let slack = solve_mooring(&particulars, &mooring, 0.0).unwrap();
        assert!(slack.distance >= 0.0 && slack.tension > 0.0);
        mooring.length_m = 9.0;
        assert!(matches!(
            solve_mooring(&particulars, &mooring, 1e3),
            Err(MooringError::TooShort { .. })
        ));
    }
}
