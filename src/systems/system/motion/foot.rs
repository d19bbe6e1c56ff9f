//! What of a body bears on the bed: points on it that have an area there, which tip it; its bottom, a point below its origin, whose push and
//! friction act at the origin, so that a body on the bed does not tip; of a free point its bottom.

use nalgebra::{Matrix6, Vector6};

use super::super::load_sum::LoadSum;
use super::super::moving_pose::{Dual, DualVector, MovingPose, constant};
use super::body_equation::MovingBody;
use super::joints::Joints;
use super::point_loads::{BedHold, bed_load};
use crate::numerics::{M3, V3};
use crate::system::network::{Body, BodyFoot, FreePoint, Network};

/// What of a body bears on the bed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Foot {
    /// The joint that it is at: the origin of its body, or a point.
    pub joint: usize,
    /// Where that is in the frame of the body \[m\].
    pub at: V3,
    /// How far it is below that \[m\].
    pub below: f64,
    /// Its weight, mass and friction.
    pub point: FreePoint,
}

impl Foot {
    /// The bottom of a body, by its mass matrix along its axes and the joint of its origin.
    #[must_use]
    pub fn bottom(body: &Body, mass: &Matrix6<f64>, joint: usize) -> Option<Self> {
        body.bottom.map(|below| Self {
            joint,
            at: V3::zeros(),
            below,
            point: FreePoint {
                weight: body.weight,
                buoyancy: body.buoyancy,
                moving_mass: V3::repeat(mass[(2, 2)]),
                friction: body.bed_friction,
                slip_speed: body.slip_speed,
                ..FreePoint::default()
            },
        })
    }

    /// A point on a body, by the mass matrix of that along its axes and the joint of the point.
    #[must_use]
    pub fn on_body(foot: &BodyFoot, mass: &Matrix6<f64>, joint: usize) -> Self {
        Self {
            joint,
            at: foot.at,
            below: 0.0,
            point: FreePoint {
                moving_mass: V3::repeat(mass_along_z(mass, &foot.at)),
                ..foot.bears
            },
        }
    }

    /// Where it is, by the place of its joint \[m\].
    #[must_use]
    pub fn place(&self, joint: &V3) -> V3 {
        joint - V3::z() * self.below
    }

    /// Adds the load of the bed under it.
    pub(super) fn bear(
        &self,
        network: &Network,
        moving: &MovingPose<'_>,
        hold: BedHold<'_>,
        sum: &mut LoadSum,
    ) {
        let at = |vector: &DualVector| vector.map(|part| part.re);
        let arm = moving.arm(&self.at);
        let (joint, speed) = (moving.place(&arm), moving.velocity_at(&arm));
        let (here, velocity) = (at(&joint), at(&speed));
        let load = bed_load(network, &self.point, (&self.place(&here), &velocity), hold);
        if load.force == V3::zeros() {
            return;
        }
        let near =
            |value: &DualVector, at: &V3, by: &M3| by.map(Dual::from_re) * (value - constant(at));
        let force = constant(&load.force)
            + near(&joint, &here, &load.by_position)
            + near(&speed, &velocity, &load.by_velocity);
        sum.add(&arm, &force);
    }
}

/// The mass that a force along z finds at a place of a body \[kg\].
fn mass_along_z(mass: &Matrix6<f64>, at: &V3) -> f64 {
    let Some(mobility) = mass.try_inverse() else {
        return mass[(2, 2)];
    };
    let moment = at.cross(&V3::z());
    let push = Vector6::new(0.0, 0.0, 1.0, moment.x, moment.y, moment.z);
    1.0 / push.dot(&(mobility * push))
}

/// The feet of each body that turns.
#[must_use]
pub fn feet(network: &Network, joints: &Joints) -> Vec<Vec<Foot>> {
    let bodies = network.bodies.iter().enumerate();
    let feet = |(number, body): (usize, &Body)| {
        if !body.turns() {
            return Vec::new();
        }
        let mass = MovingBody::new(network, number, &body.pose).mass;
        let bottom = Foot::bottom(body, &mass, joints.bodies[number]).filter(|_| body.free);
        let on_body = body.feet.iter();
        let on_body = on_body.map(|foot| Foot::on_body(foot, &mass, joints.points[foot.point]));
        bottom.into_iter().chain(on_body).collect()
    };
    bodies.map(feet).collect()
}
