//! A member where it is, as it depends on the small motions of its body.

use num_dual::DualNum;

use super::super::moving_pose::{Dual, DualVector, MovingPose, constant};
use crate::physics::sea::WaterMotion;
use crate::system::network::Member;

/// A member where it is, its lower end first.
pub(in crate::system) struct Placed<'a> {
    /// From the origin of the body to its lower end.
    pub(super) arm: DualVector,
    /// Height of the lower end above the surface, and of the upper one above that.
    pub(super) z: Dual,
    /// See `z`.
    pub(super) rise: Dual,
    /// Along its axis, upwards.
    pub(super) axis: DualVector,
    /// Its length \[m\].
    pub(super) length: f64,
    /// Radii at the lower and at the upper end.
    pub(super) radius: (f64, f64),
    /// Sine of the angle between axis and vertical, squared.
    pub(super) tilt2: Dual,
    /// Coefficients of drag and of added mass of the lower and of the upper end.
    pub(super) ends: [(f64, f64); 2],
    /// What waves make of the water at its lower end, its upper end, and along its part in the water; empty in still water.
    pub(super) waves: &'a [WaterMotion],
}

impl<'a> Placed<'a> {
    /// A member at a pose; heights are above the surface of the waves at its stations.
    pub(in crate::system) fn at_pose(
        member: &Member,
        pose: &MovingPose<'_>,
        waves: &'a [WaterMotion],
    ) -> Self {
        let (from, to) = (pose.arm(&member.from), pose.arm(&member.to));
        let coefficients = |end: usize| (member.drag_ends[end], member.added_mass_ends[end]);
        let (radius, ends) = (member.radius, [coefficients(0), coefficients(1)]);
        let (low, high, radius, ends) = if to.z.re < from.z.re {
            (to, from, (radius.1, radius.0), [ends[1], ends[0]])
        } else {
            (from, to, radius, ends)
        };
        let length = (member.to - member.from).norm();
        let axis = (high - low) / Dual::from_re(length);
        let surface = |end: usize, arm: &DualVector| {
            let flow = waves.get(end);
            flow.map_or_else(
                || Dual::from_re(0.0),
                |flow| elevation(flow, &pose.place(arm)),
            )
        };
        let (at_low, at_high) = (surface(0, &low), surface(1, &high));
        Self {
            z: pose.origin.z + low.z - at_low,
            rise: high.z - low.z - (at_high - at_low),
            tilt2: axis.x.powi(2) + axis.y.powi(2),
            arm: low,
            axis,
            length,
            radius,
            ends,
            waves,
        }
    }

    /// Its radius at a share of its length from the lower end \[m\].
    pub(super) fn radius_at(&self, share: Dual) -> Dual {
        share * (self.radius.1 - self.radius.0) + self.radius.0
    }

    /// The arm to a share of its length from the lower end \[m\].
    pub(super) fn arm_at(&self, share: Dual) -> DualVector {
        self.arm + self.axis * (share * self.length)
    }

    /// The waves at a slice; nothing in still water.
    pub(super) fn waves_at_slice(&self, number: usize) -> Option<&'a WaterMotion> {
        self.waves.get(2 + number)
    }
}

/// Height of the surface \[m\] over a place near where it is known.
fn elevation(flow: &WaterMotion, place: &DualVector) -> Dual {
    let away = place - constant(&flow.place);
    away.dot(&constant(&flow.slope)) + flow.elevation
}
