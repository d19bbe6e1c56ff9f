//! Further equilibria of a system with free bodies: turning is not convex, so that one search need not find the only one.

use nalgebra::UnitQuaternion;

use super::super::equilibrium::{Equilibrium, search_within};
use super::super::network::{Line, Network};
use super::super::start::start;

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
/// Turns \[rad\] and shares of the greatest length within which two equilibria are the same.
const SAME: f64 = 1e-5;

/// Equilibria that searches from turned bodies find beside the first; none where no body is free. Starts that find nothing are
/// left out: they say nothing of the first.
#[must_use]
pub fn others(network: &Network, first: &Equilibrium) -> Vec<Equilibrium> {
    let mut found: Vec<Equilibrium> = Vec::new();
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

/// Whether two equilibria are one, spins of rods left out.
fn is_same(network: &Network, one: &Equilibrium, two: &Equilibrium) -> bool {
    let (one, two) = (&one.placement, &two.placement);
    let size = network.lines.iter().map(Line::length);
    let near = SAME * size.fold(1.0, f64::max);
    let points = one.points.iter().zip(&two.points);
    let bodies = one.bodies.iter().zip(&two.bodies).zip(&network.bodies);
    points.into_iter().all(|(a, b)| (a - b).norm() <= near)
        && bodies.into_iter().all(|((a, b), body)| {
            let turned = match &body.spins_about {
                Some(axis) => (a.arm(axis) - b.arm(axis)).norm(),
                None => a.rotation.angle_to(&b.rotation),
            };
            turned <= SAME && (a.origin - b.origin).norm() <= near
        })
}
