//! Loads of the surroundings that a part of a system has no way to feel: waves, current, wind, friction of the bed.
//!
//! A part whose file gives no means for a load (no member, area, coefficient or response) moves as if that load were not there. That may
//! be meant, so that each is a remark, with the names of all parts it is true of, and what would let them feel it.

use super::bounds::Contact;
use super::network::{Body, FreePoint, Held, Line, Network};
use super::solved::SolvedSystem;
use crate::case::{Clump, FrictionLaw, OneOrMany, Seabed};
use crate::numerics::V3;

/// Names that a remark lists.
const NAMED: usize = 4;

/// Remarks on loads that parts of a system at rest or in time do not feel.
#[must_use]
pub fn loads_without_effect(solved: &SolvedSystem) -> Vec<String> {
    let network = &solved.network;
    let mut found = Vec::new();
    if network.sea.is_some() && solved.file.in_time().is_some() {
        found.extend(waves(network));
    }
    let current = network.current.as_ref();
    if current.is_some_and(|current| current.max_speed() > 0.0) {
        found.extend(current_of(network));
    }
    if network.wind != V3::zeros() {
        found.extend(wind(network));
    }
    if solved
        .file
        .seabed
        .as_ref()
        .is_some_and(|bed| bed.friction > Some(0.0) || bed.friction_lateral > Some(0.0))
    {
        found.extend(friction(solved));
    }
    found.extend(friction_in_motion(solved));
    found.extend(friction_across(solved));
    found.extend(friction_by_velocity(solved));
    found
}

/// A remark on parts of a kind; nothing where there are none.
fn remark<'n>(
    load: &str,
    kind: &str,
    names: impl Iterator<Item = &'n str>,
    remedy: &str,
) -> Option<String> {
    let names: Vec<&str> = names.collect();
    let shown = names[..names.len().min(NAMED)].join(", ");
    let more = match names.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let plural = if names.len() == 1 { "" } else { "s" };
    (!names.is_empty()).then(|| format!("{load} {kind}{plural} {shown}{more}: {remedy}."))
}

/// Bodies whose motion is computed, rods among them.
fn moving(network: &Network) -> impl Iterator<Item = &Body> {
    network.bodies.iter().filter(|body| body.turns())
}

/// Free points with their names, those of a mass or a volume: others are junctions, which have nothing that a flow acts on.
fn clumps(network: &Network) -> impl Iterator<Item = (&str, &FreePoint)> {
    network.points.iter().filter_map(|point| match &point.held {
        Held::Free(free) if free.weight > 0.0 || free.buoyancy > 0.0 => {
            Some((point.name.as_str(), free))
        }
        _ => None,
    })
}

/// Lines that are not said to be in still water.
fn exposed(network: &Network) -> impl Iterator<Item = &Line> {
    network.lines.iter().filter(|line| !line.still_water)
}

/// How waves act on a body.
#[derive(Clone, Copy, PartialEq)]
enum WaveExcitation {
    /// By what it displaces, or by its responses.
    Whole,
    /// By drag alone.
    Drag,
    /// Not at all.
    None,
}

fn excitation(body: &Body) -> WaveExcitation {
    let flow = body.potential_flow.as_ref();
    let by_flow = flow.is_some_and(|flow| flow.excitation.is_some());
    let by_itself = body.centre_of_added_mass.is_some();
    if by_flow || by_itself || body.members.iter().any(|member| !member.drag_only) {
        return WaveExcitation::Whole;
    }
    let drags = body.members.iter().any(|member| member.drag > 0.0);
    match drags || body.drag_area != V3::zeros() {
        true => WaveExcitation::Drag,
        false => WaveExcitation::None,
    }
}

fn waves(network: &Network) -> impl Iterator<Item = String> {
    let of = |kind: WaveExcitation| {
        moving(network)
            .filter(move |body| excitation(body) == kind)
            .map(|body| body.name.as_str())
    };
    let points = clumps(network).filter(|(_, point)| {
        point.buoyancy == 0.0 && point.added_mass == V3::zeros() && point.drag_area == V3::zeros()
    });
    let clumped = exposed(network).filter(|line| has_weights(line));
    [
        remark(
            "The waves do not act on",
            "body",
            of(WaveExcitation::None),
            "give members, or a response_file or excitation_file",
        ),
        remark(
            "The waves act by drag alone on",
            "body",
            of(WaveExcitation::Drag),
            "what lifts and pushes it comes of members, or of a response_file or excitation_file",
        ),
        remark(
            "The waves do not act on",
            "point",
            points.map(|(name, _)| name),
            "give volume_m3, wet_mass_kg, added_mass_kg or drag_area_m2",
        ),
        remark(
            "The waves do not act on the clumps of",
            "line",
            clumped.map(|line| line.name.as_str()),
            "give the clumps a drag area, or a mass beyond their weight in water",
        ),
    ]
    .into_iter()
    .flatten()
}

/// Whether a line has a clump that is a weight alone.
fn has_weights(line: &Line) -> bool {
    let Some(divided) = &line.discretised else {
        return line.sections.iter().any(|section| section.clump_n != 0.0);
    };
    let is_weight = |clump: &Clump| {
        let [drag, added] = [&clump.drag_area_m2, &clump.added_mass_kg];
        let none = OneOrMany::One(0.0);
        let is_passed = *drag != none || clump.has_aligned_drag() || clump.has_aligned_added_mass();
        clump.mass_kg <= clump.wet_mass_kg.abs() && !is_passed && *added == none
    };
    divided.case().clumps.iter().any(is_weight)
}

fn current_of(network: &Network) -> impl Iterator<Item = String> {
    let bodies = moving(network).filter(|body| {
        let drags = body.members.iter().any(|member| member.drag > 0.0);
        let turns_it = body.centre_of_added_mass.is_some();
        !drags && !turns_it && body.current_loads.is_none() && body.drag_area == V3::zeros()
    });
    let points = clumps(network).filter(|(_, point)| point.drag_area == V3::zeros());
    [
        remark(
            "The current does not act on",
            "body",
            bodies.map(|body| body.name.as_str()),
            "give drag_area_m2, current_loads, or members with drag_normal",
        ),
        remark(
            "The current does not act on",
            "point",
            points.map(|(name, _)| name),
            "give drag_area_m2",
        ),
    ]
    .into_iter()
    .flatten()
}

/// Wind acts by the loads of bodies alone.
fn wind(network: &Network) -> Option<String> {
    let floats = |body: &&Body| {
        let pierces = |body: &Body| {
            let ends = body
                .members
                .iter()
                .flat_map(|member| [member.from, member.to]);
            ends.map(|end| body.pose.origin.z + body.pose.arm(&end).z)
                .any(|z| z > 0.0)
        };
        body.waterplane.amax() > 0.0 || pierces(body)
    };
    let still = moving(network)
        .filter(|body| body.wind_loads.is_none())
        .filter(floats);
    remark(
        "The wind does not act on",
        "body",
        still.map(|body| body.name.as_str()),
        "give wind_loads",
    )
}

/// Whether a point lies on the bed, or has sunk into it.
fn lies(SolvedSystem { network, rest, .. }: &SolvedSystem, point: usize) -> bool {
    let sunk = || match (&network.points[point].held, &network.bed) {
        (Held::Free(free), Some(bed)) if free.bearing.is_some() => {
            bed.height(&free.bottom(&rest.placement.points[point])) < 0.0
        }
        _ => false,
    };
    rest.contact(point) == Contact::Bed || sunk()
}

/// Points on the bed whose own friction is not given, where lines beside them have some.
fn friction(solved: &SolvedSystem) -> Option<String> {
    let points = solved.network.points.iter().enumerate();
    let lying = points.filter(|(index, _)| lies(solved, *index));
    let smooth = lying.filter_map(|(_, point)| match &point.held {
        Held::Free(free) if free.weight > 0.0 && free.friction == 0.0 => Some(point.name.as_str()),
        _ => None,
    });
    remark(
        "The friction of the bed does not act on",
        "point",
        smooth,
        "give bed_friction, which holds in motion",
    )
}

/// Points and bodies that rest on the bed with a friction of their own, which acts in motion alone. At rest friction may hold them anywhere near;
/// where they balance without it is one of these places, and no place that they were laid in is known that would single out another.
fn friction_in_motion(solved: &SolvedSystem) -> impl Iterator<Item = String> {
    let SolvedSystem { network, rest, .. } = solved;
    let points = network.points.iter().enumerate();
    let points = points.filter_map(|(index, point)| match &point.held {
        Held::Free(free) if free.friction > 0.0 && lies(solved, index) => Some(point.name.as_str()),
        _ => None,
    });
    let bodies = network.bodies.iter().zip(&rest.freedoms.bodies);
    let bodies = bodies.filter_map(|(body, first)| {
        let lies = first.is_some_and(|first| rest.contacts[first + 2] == Contact::Bed);
        (lies && body.bed_friction > 0.0).then_some(body.name.as_str())
    });
    let (load, why) = (
        "At rest the friction of the bed is left out of",
        "what rests is where all balances without, one of the places that friction allows; bed_friction holds in motion, from there",
    );
    [
        remark(load, "point", points, why),
        remark(load, "body", bodies, why),
    ]
    .into_iter()
    .flatten()
}

/// Lines on the bed at rest by their closed form, where friction across them is not that along: they lie in the vertical plane of their ends, and
/// nothing moves them across it.
fn friction_across(solved: &SolvedSystem) -> Option<String> {
    let SolvedSystem { network, rest, .. } = solved;
    let lines = network.lines.iter().zip(&rest.balance.lines);
    let lines = lines.filter(|(line, at_rest)| {
        line.friction_lateral != line.friction
            && at_rest.discretised.is_none()
            && !line.is_buoyant()
            && at_rest.on_bed() > 0.0
    });
    remark(
        "At rest the friction of the bed across lines does not act on",
        "line",
        lines.map(|(line, _)| line.name.as_str()),
        "a closed form lies in the vertical plane of its ends; friction_lateral acts in motion",
    )
}

/// Lines on the bed at rest whose friction goes with the velocity.
fn friction_by_velocity(solved: &SolvedSystem) -> Option<String> {
    let SolvedSystem {
        network,
        rest,
        file,
        ..
    } = solved;
    let by_velocity = |bed: &Seabed| bed.friction_law == FrictionLaw::Zhu2017;
    file.seabed.as_ref().filter(|bed| by_velocity(bed))?;
    let lines = network.lines.iter().zip(&rest.balance.lines);
    let lines = lines.filter(|(line, at_rest)| !line.is_buoyant() && at_rest.on_bed() > 0.0);
    remark(
        "At rest the friction of the bed does not act on",
        "line",
        lines.map(|(line, _)| line.name.as_str()),
        "by `zhu-2017` it holds nothing; it acts in motion",
    )
}
