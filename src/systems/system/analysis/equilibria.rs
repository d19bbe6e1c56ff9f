//! Further equilibria of a system with free bodies: turning is not convex, so that one search need not find the only one.

use nalgebra::UnitQuaternion;

use super::super::equilibrium::{SystemEquilibrium, search_within};
use super::super::network::Network;
use super::super::start::start;
use super::super::unstable::is_same;

/// Turns \[deg\] about x, y, z from which each free body is searched in turn.
const TURNS: [[f64; 3]; 7] = [
    [0.0, 0.0, 90.0],
    [0.0, 0.0, -90.0],
    [0.0, 0.0, 180.0],
    [90.0, 0.0, 0.0],
    [0.0, 90.0, 0.0],
    [180.0, 0.0, 0.0],
    [180.0, 0.0, 90.0],
];
/// Steps of a search: those that find something take a few tens, and nothing is lost with one that does not.
const MOST_STEPS: usize = 60;

/// Equilibria beside the first: the unstable one that the search for it left, and those that searches from turned bodies find; none where no body
/// is free. Starts that find nothing are left out: they say nothing of the first.
#[must_use]
pub fn others(network: &Network, first: &SystemEquilibrium) -> Vec<SystemEquilibrium> {
    let mut found = left(first);
    let free = (0..network.bodies.len()).filter(|body| network.bodies[*body].turns());
    for body in free {
        for turn in TURNS {
            let mut from = start(network);
            let [x, y, z] = turn.map(f64::to_radians);
            let turn = UnitQuaternion::from_euler_angles(x, y, z);
            from.bodies[body].rotation = turn * from.bodies[body].rotation;
            from.carry(network);
            let Ok(rest) = search_within(network, &from, MOST_STEPS) else {
                continue;
            };
            let known = std::iter::once(first).chain(&found);
            if !known.clone().any(|other| is_same(network, other, &rest)) {
                found.push(rest);
            }
        }
    }
    found
}

/// The unstable equilibrium that the search for one left.
#[must_use]
pub fn left(first: &SystemEquilibrium) -> Vec<SystemEquilibrium> {
    first.left.iter().map(|left| (**left).clone()).collect()
}
