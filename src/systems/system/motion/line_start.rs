//! Lines that do not begin at rest between their ends: straight, in a shape that is given, or with a velocity.

use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::case::Start;
use crate::numerics::V3;
use crate::scene::initial_shape::shape_between;
use crate::solve::State;
use crate::system::network::Network;

/// Whether a line begins with a shape or a velocity of its own.
#[must_use]
pub(super) fn is_off_rest(network: &Network) -> bool {
    network.lines.iter().any(|line| line.start.is_some())
}

/// Puts the lines of a system at rest into the shapes that they begin in, between their ends where these begin, and sets them moving.
pub(super) fn begin(system: &MovingSystem, state: &mut SystemState) {
    for (number, line) in system.network.lines.iter().enumerate() {
        if let Some(start) = &line.start {
            begin_line(system, state, (number, start));
        }
    }
    if is_off_rest(&system.network) {
        system.follow(state);
    }
}

/// The same of a line by its number.
fn begin_line(system: &MovingSystem, state: &mut SystemState, (number, start): (usize, &Start)) {
    let [from, to] = state.attached[number].map(|joint| state.joints.x[joint]);
    let scene = &system.scenes[number];
    let own = &mut state.lines[number];
    if let Some(nodes) = shape_between(start, (from, to), &scene.line.arc) {
        *own = State {
            clamps: own.clamps,
            ..scene.state_in_shape(nodes)
        };
    }
    own.v.fill(V3::from(start.velocity_m_per_s));
}
