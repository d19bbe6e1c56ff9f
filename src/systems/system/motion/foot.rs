//! What of a body bears on the bed: its foot, a point below its origin; of a free point its bottom. The push and the friction of the bed act at the origin, so that a body
//! on the bed does not tip.

use nalgebra::Matrix6;

use super::super::load_sum::LoadSum;
use super::super::moving_pose::{Dual, DualVector, MovingPose, constant};
use super::body_equation::MovingBody;
use super::point_loads::bed_load;
use crate::numerics::{M3, V3};
use crate::physics::FrictionAnchor;
use crate::system::network::{Body, FreePoint, Network};

/// What of a body bears on the bed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Foot {
    /// How far it is below the origin \[m\].
    pub below: f64,
    /// Its weight, mass and friction.
    pub point: FreePoint,
}

impl Foot {
    /// Of a body that bears on the bed, by its mass matrix along its axes.
    #[must_use]
    pub fn of_body(body: &Body, mass: &Matrix6<f64>) -> Option<Self> {
        body.bottom.map(|below| Self {
            below,
            point: FreePoint {
                weight: body.weight,
                buoyancy: body.buoyancy,
                moving_mass: V3::repeat(mass[(2, 2)]),
                friction: body.bed_friction,
                ..FreePoint::default()
            },
        })
    }

    /// Where it is, by the place of the origin \[m\].
    #[must_use]
    pub fn place(&self, origin: &V3) -> V3 {
        origin - V3::z() * self.below
    }

    /// Adds the load of the bed under it.
    pub(super) fn bear(
        &self,
        network: &Network,
        moving: &MovingPose<'_>,
        grip: Option<&FrictionAnchor>,
        sum: &mut LoadSum,
    ) {
        let at = |vector: &DualVector| vector.map(|part| part.re);
        let (origin, velocity) = (at(&moving.origin), at(&moving.velocity));
        let here = (&self.place(&origin), &velocity);
        let load = bed_load(network, &self.point, here, grip);
        if load.force == V3::zeros() {
            return;
        }
        let near =
            |value: &DualVector, at: &V3, by: &M3| by.map(Dual::from_re) * (value - constant(at));
        let force = constant(&load.force)
            + near(&moving.origin, &origin, &load.by_position)
            + near(&moving.velocity, &velocity, &load.by_velocity);
        sum.add(&constant(&V3::zeros()), &force);
    }
}

/// The feet of all bodies.
#[must_use]
pub fn feet(network: &Network) -> Vec<Option<Foot>> {
    let bodies = network.bodies.iter().enumerate();
    let foot = |(number, body): (usize, &Body)| {
        let moving = MovingBody::new(network, number, &body.pose);
        Foot::of_body(body, &moving.mass)
    };
    bodies.map(foot).collect()
}
