//! Clamps of lines on bodies: they turn with these.
//!
//! The angles of a clamp are those of the line in space where the file puts the body. In the frame of the body the direction stays the same.

use std::array::from_fn;

use nalgebra::Rotation3;

use super::freedoms::{Follower, Freedoms, Placement};
use super::model::LineInputs;
use super::network::{Held, Line, Network};
use super::parts::Part;
use crate::numerics::V3;
use crate::scene::direction;

/// The directions of the clamps of a copy of a line of these parts, turned by this angle \[deg\], in the frames of the bodies at its ends; its
/// points are those of the system. Like the points on a body, a copy turns about the z axis of the body. Nothing where the line does not
/// bend at that end.
#[must_use]
pub fn on_bodies(
    network: &Network,
    (line, parts): (&LineInputs, &[Part]),
    angle: f64,
    points: [usize; 2],
) -> [Option<V3>; 2] {
    let at_ends = [parts.first(), parts.last()];
    let given = [
        (line.clamp_a_elevation_deg, line.clamp_a_azimuth_deg),
        (line.clamp_b_elevation_deg, line.clamp_b_azimuth_deg),
    ];
    from_fn(|end| {
        let (elevation, azimuth) = given[end];
        at_ends[end].filter(|part| part.material.ei_n_m2 > 0.0)?;
        let Held::On(body, _) = network.points[points[end]].held else {
            return None;
        };
        let along = direction(azimuth.to_radians(), elevation?.to_radians());
        let own = network.bodies[body].pose.rotation.inverse() * along;
        let turn = Rotation3::from_axis_angle(&V3::z_axis(), angle.to_radians());
        Some(if angle == 0.0 { own } else { turn * own })
    })
}

/// The directions of the clamps of a line on bodies in these poses, from A to B.
#[must_use]
pub fn directions(network: &Network, line: &Line, placement: &Placement) -> [Option<V3>; 2] {
    from_fn(|end| {
        let (body, own) = clamp_on(network, line, end)?;
        Some(placement.bodies[body].arm(&own))
    })
}

/// The body that holds the clamp of a line at an end, and the direction of that in its frame.
#[must_use]
pub fn clamp_on(network: &Network, line: &Line, end: usize) -> Option<(usize, V3)> {
    match network.points[[line.from, line.to][end]].held {
        Held::On(body, _) => Some((body, line.clamps[end]?)),
        Held::At(_) | Held::Free(_) => None,
    }
}

/// How the direction of a clamp follows the unknowns: as a place at the arm of the direction, but for displacements of the body.
#[must_use]
pub fn follower(
    network: &Network,
    freedoms: &Freedoms,
    placement: &Placement,
    (line, end): (&Line, usize),
) -> Option<Follower> {
    let (body, own) = clamp_on(network, line, end)?;
    let first = freedoms.bodies[body]?;
    Some(Follower::turning(first, placement.bodies[body].arm(&own)))
}

/// Whether any line is clamped on a body that turns.
#[must_use]
pub fn any_on_what_turns(network: &Network) -> bool {
    on_which(network).any(|(body, _)| network.bodies[body].turns())
}

/// The bodies that hold clamps, and the directions of these there.
fn on_which(network: &Network) -> impl Iterator<Item = (usize, V3)> {
    let lines = network.lines.iter();
    lines.flat_map(move |line| (0..2).filter_map(move |end| clamp_on(network, line, end)))
}

/// Sine of the angle between a clamp and the axis of its rod below which the rod spins freely.
const ALONG: f64 = 1e-6;

/// Bodies with a centre of added mass that turn about their z axis without resistance: nothing is on them, nor acts on them, off that axis.
pub fn let_spin(network: &mut Network) {
    let off_axis = |place: &V3| place.x != 0.0 || place.y != 0.0;
    let points = network.points.iter();
    let held: Vec<usize> = points
        .filter_map(|point| match point.held {
            Held::On(body, at) if off_axis(&at) => Some(body),
            _ => None,
        })
        .collect();
    for (number, body) in network.bodies.iter_mut().enumerate() {
        let centres = [
            body.centre_of_gravity,
            body.centre_of_buoyancy,
            body.centre_of_drag,
        ];
        let centre = body.centre_of_added_mass;
        let is_on_axis = !centres.iter().chain(&centre).any(off_axis) && !held.contains(&number);
        let turned = body.waterplane.row(5).amax() + body.moment.amax();
        let is_loaded = turned > 0.0
            || !body.members.is_empty()
            || body.wind_loads.is_some()
            || body.drift_loads.is_some();
        if centre.is_some() && is_on_axis && !is_loaded {
            body.spins_about = Some(V3::z());
        }
    }
}

/// Rods that a clamp keeps from spinning: those that it does not hold along their axis.
pub fn keep_from_spinning(network: &mut Network) {
    let clamps: Vec<(usize, V3)> = on_which(network).collect();
    for (body, own) in clamps {
        let axis = &mut network.bodies[body].spins_about;
        *axis = axis.filter(|axis| axis.cross(&own).norm() < ALONG);
    }
}
