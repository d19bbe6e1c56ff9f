//! The energy of a system in motion: `d(energy)/dt = supplied - dissipated + growth`.
//!
//! Energy is that of the lines and of free points, and the kinetic energy of free bodies. What water, bed and steady loads do to a body
//! counts as power in, whatever its sign.

use super::body_equation::{MovingBody, rotation_jacobian};
use super::joints::Role;
use super::moving_system::MovingSystem;
use super::payout_border::drives;
use super::pins::pin_force;
use super::point_loads::{PointLoad, point_load};
use super::system_state::SystemState;
use crate::numerics::V3;
use crate::scene::EnergyRates;
use crate::solve::Factors;
use crate::system::network::Held;

/// Adds what points, bodies and drives have to the energy and the powers of the lines, at time t \[s\]; `bodies` are those that turn,
/// with their mass.
pub fn add_beside_lines(
    system: &MovingSystem,
    bodies: &[MovingBody],
    (t, state): (f64, &SystemState),
    sum: &mut EnergyRates,
) {
    for (kinetic, load) in free_points(system, state) {
        sum.kinetic += kinetic;
        sum.energy += kinetic + load.energy;
        sum.dissipated += load.lost;
    }
    // It came with the mesh: neither a drive nor a load does it.
    let remeshed = system.surplus_power(state);
    sum.remeshed += remeshed;
    sum.supplied -= remeshed;
    sum.supplied += system.power_on_clamps(state);
    for drive in drives(system, t, state) {
        sum.add(&drive);
    }
    for body in bodies {
        let kinetic = body.kinetic_energy(&system.body(state, body.number));
        sum.kinetic += kinetic;
        sum.energy += kinetic;
        sum.supplied += power_of_loads(system, body, state);
        sum.supplied += power_of_pin(system, body, state);
    }
}

/// The energy of it in a state \[J\], as the balance counts it.
pub(super) fn stored(system: &MovingSystem, bodies: &[MovingBody], state: &SystemState) -> f64 {
    let lines = system.lines(state).map(|(scene, line)| scene.energy(line));
    let points = free_points(system, state).map(|(kinetic, load)| kinetic + load.energy);
    let bodies = bodies.iter();
    let bodies = bodies.map(|body| body.kinetic_energy(&system.body(state, body.number)));
    lines.chain(points).chain(bodies).sum()
}

/// Kinetic energy of every free point \[J\], and its load.
fn free_points(
    system: &MovingSystem,
    state: &SystemState,
) -> impl Iterator<Item = (f64, PointLoad)> {
    system.joints.free.clone().filter_map(move |joint| {
        let Role::Free(number) = system.joints.roles[joint] else {
            return None;
        };
        let Held::Free(point) = &system.network.points[number].held else {
            return None;
        };
        let (x, v) = (&state.joints.x[joint], &state.joints.v[joint]);
        let around = system.around(&state.joints, joint);
        let load = point_load(&system.network, point, (x, v), around);
        Some((load.kinetic_energy(v), load))
    })
}

/// The power of what moves the origin of a body that is pinned to it \[W\]; none between bodies that both turn.
fn power_of_pin(system: &MovingSystem, body: &MovingBody, state: &SystemState) -> f64 {
    let bodies = &system.network.bodies;
    let pinned = &bodies[body.number];
    let on_unknown = pinned
        .carrier
        .is_some_and(|(carrier, _)| bodies[carrier].turns());
    let velocity = system.body(state, body.number).velocity;
    if !pinned.pinned || on_unknown || velocity == V3::zeros() {
        return 0.0;
    }
    pin_force(system, std::slice::from_ref(body), state, body.number).dot(&velocity)
}

/// The power of all loads on a body that turns but those of lines \[W\].
fn power_of_loads(system: &MovingSystem, body: &MovingBody, state: &SystemState) -> f64 {
    const STILL: Factors = Factors {
        mass: 0.0,
        damping: 0.0,
        stiffness: 0.0,
    };
    let motion = system.body(state, body.number);
    let loads = body.loads_beside_inertia();
    let jacobian = rotation_jacobian(&motion.pose.rotation, &V3::zeros());
    let (residual, _) = loads.residual(
        &system.network,
        &motion,
        &system.water_around(state, body.number),
        &jacobian,
        STILL,
    );
    let spin = motion.pose.rotation * motion.spin;
    let force = residual.fixed_rows::<3>(0).into_owned();
    let moment = residual.fixed_rows::<3>(3).into_owned();
    -force.dot(&motion.velocity) - moment.dot(&spin)
}
