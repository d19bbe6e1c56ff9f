//! Loads on a body that no line brings: weight, buoyancy, water-plane, steady loads, its members in the water and on the bed, wind and current.
//!
//! Loads that hang on the pose are written once, for dual numbers in the six small motions of the body: their stiffness is exact and
//! cannot come apart from them.

use nalgebra::{Matrix6, Vector6};

use super::body_in_flow::{self, BodyRates};
use super::line_physics::LinePhysics;
use super::load_sum::LoadSum;
use super::members::{self, Placed};
use super::moving_pose::{MovingPose, near};
use super::network::{Body, BodyFoot, Network};
use super::pose::{Pose, cross};
use super::{heading_loads, waterplane};
use crate::numerics::V3;

/// Force and moment about its origin on a body, lines apart \[N, N m\], and minus their change \[N/m, N, N m\].
///
/// Wind and current count in the full physics only: they have no energy.
#[must_use]
pub fn body_loads(
    network: &Network,
    body: &Body,
    pose: &Pose,
    physics: LinePhysics,
) -> (Vector6<f64>, Matrix6<f64>) {
    let (force, stiffness) = fixed_loads(body, pose);
    let flow = physics == LinePhysics::Full && network.flows();
    let mut sum = LoadSum::none();
    let moving = MovingPose::at_rest(pose);
    add_loads_by_pose(network, body, &moving, flow, &mut sum);
    let given = (body, &Matrix6::zeros());
    body_in_flow::add(network, given, &moving, flow, &BodyRates::none(), &mut sum);
    for foot in &body.feet {
        bear_at_rest(network, foot, &moving, &mut sum);
    }
    let (by_water, by_pose) = sum.parts();
    (force + by_water, stiffness + by_pose)
}

/// The bed under a point on a body at rest.
fn bear_at_rest(network: &Network, foot: &BodyFoot, moving: &MovingPose<'_>, sum: &mut LoadSum) {
    let arm = moving.arm(&foot.at);
    let place = moving.place(&arm);
    let here = place.map(|part| part.re);
    if let Some((push, by_place)) = foot.bears.bed_at_rest(network, &here) {
        sum.add(&arm, &near((&push, &by_place), &here, &place));
    }
}

/// The members of a body that displace water, at the pose given in still water.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MembersInWater {
    /// Their volume in the water \[m³\].
    pub volume: f64,
    /// Whether the surface cuts any of them.
    pub cut_by_surface: bool,
    /// Whether any has added mass, across it or at its ends.
    pub have_added_mass: bool,
}

impl MembersInWater {
    /// Of a body.
    #[must_use]
    pub fn of_body(body: &Body) -> Self {
        let pose = MovingPose::at_rest(&body.pose);
        let mut found = Self::default();
        for member in body.members.iter().filter(|member| !member.drag_only) {
            let volume = Placed::at_pose(member, &pose, &[]).volume_in_water();
            found.volume += volume;
            found.cut_by_surface |= volume > 0.0 && volume < (1.0 - ROUNDING) * member.volume();
            found.have_added_mass |=
                member.added_mass > 0.0 || member.added_mass_ends.iter().any(|mass| *mass > 0.0);
        }
        found
    }
}

/// Share of a volume that is rounding.
const ROUNDING: f64 = 1e-9;

/// Loads that hang on the pose and, where there is flow, on the velocity.
pub(super) fn add_loads_by_pose(
    network: &Network,
    body: &Body,
    moving: &MovingPose,
    flow: bool,
    sum: &mut LoadSum,
) {
    waterplane::add(body, moving, sum);
    for (number, member) in body.members.iter().enumerate() {
        let placed = Placed::at_pose(member, moving, moving.at_member(number));
        if !member.drag_only {
            members::buoyancy(network, &placed, sum);
        }
        members::bed(network, body, member, moving, sum);
        if flow {
            members::drag(network, member, moving, &placed, sum);
            if !member.drag_only {
                members::wave_inertia(network, member, moving, &placed, sum);
            }
        }
    }
    if flow {
        heading_loads::add(network, body, moving, sum);
    }
}

/// Weight, buoyancy of the volume given, and steady loads.
pub(super) fn fixed_loads(body: &Body, pose: &Pose) -> (Vector6<f64>, Matrix6<f64>) {
    let mut force = Vector6::zeros();
    let mut stiffness = Matrix6::zeros();
    let mut at = |arm: V3, load: V3| {
        let moment = arm.cross(&load);
        for k in 0..3 {
            force[k] += load[k];
            force[k + 3] += moment[k];
        }
        let mut block = stiffness.fixed_view_mut::<3, 3>(3, 3);
        block -= cross(&load) * cross(&arm);
    };
    at(V3::zeros(), body.load);
    at(pose.arm(&body.centre_of_gravity), V3::z() * -body.weight);
    at(pose.arm(&body.centre_of_buoyancy), V3::z() * body.buoyancy);
    for k in 0..3 {
        force[k + 3] += body.moment[k];
    }
    if let Some(axis) = &body.spins_about {
        // A rod does not resist its spin, which nothing hangs on: this keeps it where it is.
        let axis = pose.arm(axis);
        let mut block = stiffness.fixed_view_mut::<3, 3>(3, 3);
        block += axis * axis.transpose() * body.spin_stiffness();
    }
    (force, stiffness)
}
