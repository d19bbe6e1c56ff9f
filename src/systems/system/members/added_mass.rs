//! Added mass of the members of a body.

use std::f64::consts::PI;

use nalgebra::Matrix6;

use super::super::moving_pose::MovingPose;
use super::placed::Placed;
use crate::numerics::{M3, V3};
use crate::system::network::{Body, Network};
use crate::system::pose::{Pose, cross};

/// Added mass of the parts of the members in still water about the origin of their body, in the earth's axes \[kg, kg m, kg m²\].
pub(in crate::system) fn added_mass(network: &Network, body: &Body, pose: &Pose) -> Matrix6<f64> {
    let mut mass = Matrix6::zeros();
    let moving = MovingPose::at_rest(pose);
    for member in body.members.iter().filter(|member| !member.drag_only) {
        let placed = Placed::at_pose(member, &moving, &[]);
        let axis = placed.axis.map(|part| part.re);
        let along = axis * axis.transpose();
        let across = M3::identity() - along;
        if member.added_mass > 0.0 {
            for slice in placed.wet_slices() {
                let volume = PI * slice.radius.re * slice.radius.re * slice.long.re;
                let here = across * (network.density * member.added_mass * volume);
                add(&mut mass, &slice.arm.map(|part| part.re), &here);
            }
        }
        for end in placed.wet_ends() {
            let here = along * (network.density * end.added_volume.re);
            add(&mut mass, &end.arm.map(|part| part.re), &here);
        }
    }
    mass
}

/// Adds a mass by direction at an arm from the origin.
fn add(mass: &mut Matrix6<f64>, arm: &V3, here: &M3) {
    let lever = cross(arm);
    let mut block = mass.fixed_view_mut::<3, 3>(0, 0);
    block += here;
    let mut block = mass.fixed_view_mut::<3, 3>(0, 3);
    block -= here * lever;
    let mut block = mass.fixed_view_mut::<3, 3>(3, 0);
    block += lever * here;
    let mut block = mass.fixed_view_mut::<3, 3>(3, 3);
    block -= lever * here * lever;
}
