//! What a body states of its water and its members give again.

use super::SolvedSystem;
use super::body_loads::MembersInWater;
use super::network::{Body, Network};
use crate::number::digits;

/// What to do about it.
const REMEDY: &str =
    "if that is the same water, set `drag_only = true` on the members or leave the other out";

/// Buoyancy, water-planes and added mass that bodies which float have both by themselves and by their members.
pub(super) fn displaced_twice(solved: &SolvedSystem) -> Vec<String> {
    let network = &solved.network;
    let floating = network.bodies.iter().filter(|body| body.turns());
    floating.flat_map(|body| of_body(network, body)).collect()
}

fn of_body(network: &Network, body: &Body) -> Vec<String> {
    let members = MembersInWater::of_body(body);
    let name = &body.name;
    let mut found = Vec::new();
    if body.buoyancy > 0.0 && members.volume > 0.0 {
        let stated = body.buoyancy / (network.density * network.gravity);
        found.push(format!(
            "Body {name} floats by its volume_m3 ({} m3) and by its members ({} m3 in the water at the pose given), both of which count: {REMEDY}.",
            digits(stated, 4),
            digits(members.volume, 4)
        ));
    }
    if body.waterplane.amax() > 0.0 && members.cut_by_surface {
        found.push(format!(
            "Body {name} has waterplane_stiffness and members that the surface cuts, both of which count: {REMEDY}."
        ));
    }
    let flow = body.potential_flow.as_ref();
    if flow.is_some_and(|flow| flow.radiation.is_some()) && members.have_added_mass {
        found.push(format!(
            "Body {name} has the added mass of radiation_file and that of its members, both of which count: {REMEDY}."
        ));
    }
    found
}
