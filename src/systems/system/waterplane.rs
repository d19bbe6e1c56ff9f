//! The stiffness of a body's water-plane: against heave, against tilt about the body's own axes, whatever its heading, and against
//! horizontal displacement and yaw.
//!
//! With the vertical `w` in the frame of the body and `w0` at the pose given, the tilt is `R0 (w x w0)`: the rotation vector of a small
//! tilt, and the same at every heading. The matrix is that of the body's axes forward, to port and up at the pose given: displacement and
//! tilt are taken along these, and moments about horizontal axes turn with the heading. It holds for small tilts.

use nalgebra::{Matrix6, Vector3};
use num_dual::DualNum;

use super::load_sum::LoadSum;
use super::moving_pose::{Dual, DualVector, MovingPose, constant};
use super::network::Body;
use super::pose::Pose;
use crate::numerics::V3;

/// The force and the moment of the water-plane.
pub(super) fn add(body: &Body, pose: &MovingPose<'_>, sum: &mut LoadSum) {
    if body.waterplane == Matrix6::zeros() {
        return;
    }
    let given = &body.pose;
    let step = pose.origin - constant(&given.origin);
    let axes = [V3::x(), V3::y(), V3::z()].map(|axis| pose.arm(&axis).z);
    let upright = constant(&(given.rotation.inverse() * V3::z()));
    let turn = given.matrix().matrix().map(Dual::from_re);
    let tilt = turn * Vector3::from(axes).cross(&upright);
    let forward = pose.arm(&V3::x());
    let yaw = yawed(&forward, given);
    let heading = Dual::from_re(given.angles()[2]);
    let [along, across] = turned([step.x, step.y], -heading);
    let [roll, pitch] = turned([tilt.x, tilt.y], -heading);
    let moved = [along, across, step.z, roll, pitch, yaw];
    let load = |row: usize| {
        let parts = moved.iter().enumerate();
        let parts = parts.map(|(column, by)| *by * -body.waterplane[(row, column)]);
        parts.fold(Dual::from_re(0.0), |sum, part| sum + part)
    };
    let [x, y] = turned([load(0), load(1)], heading);
    let [about_x, about_y] = turned([load(3), load(4)], heading + yaw);
    sum.add(&constant(&V3::zeros()), &Vector3::new(x, y, load(2)));
    sum.turn(&Vector3::new(about_x, about_y, load(5)));
}

/// The turn about the vertical from the pose given; nothing where a body stands on its end and has no heading.
fn yawed(forward: &DualVector, given: &Pose) -> Dual {
    let before = given.arm(&V3::x());
    if forward.x.re.hypot(forward.y.re) < 1e-6 || before.xy().norm() < 1e-6 {
        return Dual::from_re(0.0);
    }
    let across = forward.y * before.x - forward.x * before.y;
    let along = forward.x * before.x + forward.y * before.y;
    across.atan2(along)
}

/// Two horizontal components turned about the vertical.
fn turned([x, y]: [Dual; 2], by: Dual) -> [Dual; 2] {
    let (sin, cos) = by.sin_cos();
    [x * cos - y * sin, x * sin + y * cos]
}
