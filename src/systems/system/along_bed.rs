//! What lies on a bed that slopes moves along it: its height z follows its place as b(x, y).
//!
//! With the force F and the stiffness K of what lies there, lines included, the two motions along the bed have
//!
//! ```text
//! Q = J' F      J = [1 0; 0 1; b_x b_y]      K' = J' K J - F_z [b_xx b_xy; b_xy b_yy]
//! ```
//!
//! On a level bed J leaves x and y as they are.

use nalgebra::DVector;

use super::bed::Bed;
use super::bounds::Contact;
use super::freedoms::{Freedoms, Placement};
use crate::numerics::V3;
use crate::numerics::envelope::EnvelopeMatrix;

/// Something that lies on a bed that slopes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OnSlope {
    /// Its unknown along x; those along y and z follow.
    pub first: usize,
    /// Where it is \[m\].
    pub place: V3,
    /// Slopes b_x and b_y of the bed there \[-\].
    pub slope: [f64; 2],
}

/// What lies on the bed where that is not level: points, then bodies, by the contacts of their unknowns.
#[must_use]
pub fn on_slope(
    bed: Option<&Bed>,
    (freedoms, placement): (&Freedoms, &Placement),
    contacts: &[Contact],
) -> Vec<OnSlope> {
    let Some(bed) = bed.filter(|bed| !bed.is_level()) else {
        return Vec::new();
    };
    let points = placement.points.iter().zip(&freedoms.points);
    let bodies = placement.bodies.iter().map(|pose| &pose.origin);
    let lying = points
        .chain(bodies.zip(&freedoms.bodies))
        .filter_map(|(place, first)| {
            let first = first.filter(|first| contacts[first + 2] == Contact::Bed)?;
            Some(OnSlope {
                first,
                place: *place,
                slope: bed.rise(place),
            })
        });
    lying.collect()
}

/// Turns the forces on x and y into those along the bed.
pub fn force_along(lying: &[OnSlope], force: &mut DVector<f64>) {
    for OnSlope { first, slope, .. } in lying {
        let upwards = force[first + 2];
        force[*first] += upwards * slope[0];
        force[first + 1] += upwards * slope[1];
    }
}

/// Turns the stiffness by x and y into that along the bed, where these forces act; what is by z stays as it is.
pub fn stiffness_along(
    bed: Option<&Bed>,
    lying: &[OnSlope],
    force: &DVector<f64>,
    stiffness: &mut EnvelopeMatrix,
) {
    for OnSlope {
        first,
        place,
        slope,
    } in lying
    {
        for (k, slope) in slope.iter().enumerate() {
            stiffness.add_multiple(first + k, first + 2, *slope);
        }
        if let Some(curvature) = bed.and_then(|bed| bed.curvature(place)) {
            // The curvature of the height above the bed is minus that of the bed.
            let turning = curvature.fixed_view::<2, 2>(0, 0) * force[first + 2];
            stiffness.add_block(*first, *first, &turning);
        }
    }
}
