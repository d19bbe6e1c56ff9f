//! A body whose added mass has a centre, in current and waves: what flows past that centre acts on the added mass and on the volume.
//!
//! With U the velocity of the water at the centre and U' its acceleration in waves, momentum and angular momentum of the added mass are those
//! of the velocity `v - U` and the acceleration `a - U'`: what is left of Kirchhoff's equations at a constant velocity is Munk's moment, which
//! turns a body across the flow (Lamb 1932, art. 124). The pressure of the waves acts on the volume at its centre of buoyancy. Across the
//! surface all of these count, as drag does, by the share of a ball of that volume that is in the water; the buoyancy lost above it derives
//! from a potential. It is the law of a payload of a line (`engine/scene/elements/rigid_payload`), for a body of any form.

use nalgebra::Matrix6;

use super::immersion::Immersion;
use super::load_sum::LoadSum;
use super::moving_pose::{Dual, DualVector, MovingPose, constant, near};
use super::network::{Body, Network};
use crate::numerics::V3;

/// How a body moves beside its pose: the acceleration of its origin in the earth's directions, angular velocity and its rate along its own axes.
pub(super) struct BodyRates {
    pub(super) acceleration: DualVector,
    pub(super) spin: DualVector,
    pub(super) spin_rate: DualVector,
}

impl BodyRates {
    /// At rest.
    pub(super) fn none() -> Self {
        let still = constant(&V3::zeros());
        Self {
            acceleration: still,
            spin: still,
            spin_rate: still,
        }
    }
}

/// Adds the loads on the added mass and volume of a body, beside its buoyancy and what inertia with this part of the added mass counts already.
pub(super) fn add(
    network: &Network,
    (body, counted): (&Body, &Matrix6<f64>),
    moving: &MovingPose<'_>,
    flow: bool,
    rates: &BodyRates,
    sum: &mut LoadSum,
) {
    let Some(centre) = &body.centre_of_added_mass else {
        return;
    };
    let share = share_in_water(network, body, moving);
    let lifted = moving.arm(&body.centre_of_buoyancy);
    if share != Dual::from_re(1.0) {
        let lost = (share - 1.0) * body.buoyancy;
        sum.add(&lifted, &(constant(&V3::z()) * lost));
    }
    let flow = flow && (network.current.is_some() || moving.at_station().is_some());
    if !flow && share == Dual::from_re(1.0) && *counted == body.added_mass {
        return;
    }
    let place = moving.place(&moving.arm(centre));
    let (mut water, mut gain) = (constant(&V3::zeros()), constant(&V3::zeros()));
    if flow {
        (water, gain) = water_at(network, moving, &place);
        let displaced = displaced_mass(network, body);
        sum.add(&lifted, &(gain * (share * displaced)));
    }
    let relative = Momentum {
        velocity: moving.velocity - water,
        acceleration: rates.acceleration - gain,
    };
    let own = Momentum {
        velocity: moving.velocity,
        acceleration: rates.acceleration,
    };
    let needs = relative.rates(moving, &body.added_mass, rates);
    let counted = own.rates(moving, counted, rates);
    let beyond = |k: usize| moving.to_earth(&(needs[k] * share - counted[k]));
    sum.add(&constant(&V3::zeros()), &-beyond(0));
    sum.turn(&-beyond(1));
}

/// Velocity of the origin and its acceleration, in the earth's directions.
pub(super) struct Momentum {
    pub(super) velocity: DualVector,
    pub(super) acceleration: DualVector,
}

impl Momentum {
    /// Force and moment about the origin that a mass matrix about it needs, along the axes of the body: `P' + w x P` and
    /// `L' + w x L + u x P` (Fossen 2011, sec. 6.3).
    pub(super) fn rates(
        &self,
        moving: &MovingPose<'_>,
        mass: &Matrix6<f64>,
        rates: &BodyRates,
    ) -> [DualVector; 2] {
        let spin = &rates.spin;
        let velocity = moving.to_body(&self.velocity);
        let rate = moving.to_body(&self.acceleration) - spin.cross(&velocity);
        let (momentum, angular_momentum) = product(mass, &velocity, spin);
        let (force, moment) = product(mass, &rate, &rates.spin_rate);
        [
            force + spin.cross(&momentum),
            moment + spin.cross(&angular_momentum) + velocity.cross(&momentum),
        ]
    }
}

/// A matrix times a vector of two parts.
pub(super) fn product(
    matrix: &Matrix6<f64>,
    first: &DualVector,
    second: &DualVector,
) -> (DualVector, DualVector) {
    let block = |row: usize, column: usize| {
        let block = matrix.fixed_view::<3, 3>(row, column).into_owned();
        block.map(Dual::from_re)
    };
    (
        block(0, 0) * first + block(0, 3) * second,
        block(3, 0) * first + block(3, 3) * second,
    )
}

/// Velocity of the water at a place, and its acceleration in waves.
fn water_at(
    network: &Network,
    moving: &MovingPose<'_>,
    place: &DualVector,
) -> (DualVector, DualVector) {
    let here = place.map(|part| part.re);
    let (mut velocity, mut gain) = (constant(&V3::zeros()), constant(&V3::zeros()));
    if let Some(current) = &network.current {
        let (still, gradient) = current.flow(&here);
        velocity += near((&still, &gradient), &here, place);
    }
    if let Some(flow) = moving.at_station() {
        velocity += near((&flow.velocity, &flow.gradient), &flow.place, place);
        let acceleration = (&flow.acceleration, &flow.acceleration_gradient);
        gain += near(acceleration, &flow.place, place);
    }
    (velocity, gain)
}

/// Mass of the water that a body displaces \[kg\].
fn displaced_mass(network: &Network, body: &Body) -> f64 {
    match network.gravity > 0.0 {
        true => body.buoyancy / network.gravity,
        false => 0.0,
    }
}

/// The share of a body with a centre of added mass that is in the water: of a ball of its volume about its centre of buoyancy.
pub(super) fn share_in_water(network: &Network, body: &Body, moving: &MovingPose<'_>) -> Dual {
    let one = Dual::from_re(1.0);
    if !network.crossed || body.centre_of_added_mass.is_none() || network.density <= 0.0 {
        return one;
    }
    let volume = displaced_mass(network, body) / network.density;
    let centre = moving.place(&moving.arm(&body.centre_of_buoyancy));
    let mut above = centre.z;
    if let Some(flow) = moving.at_station() {
        let along = (centre - constant(&flow.place)).dot(&constant(&flow.slope));
        above -= along + flow.elevation;
    }
    let ball = Immersion::of_ball(volume, above.re);
    (above - above.re) * ball.by_height + ball.share
}
