//! Lines, and what comes off them.

use std::collections::HashMap;

use super::case_text::{CaseText, number, numbers, text};
use super::context::Context;
use super::joints::{Chain, chains};
use super::materials;
use super::materials::Pasts;
use super::points::name_of;
use crate::import::mooring::{Attachment, Hold, Mooring, Rod};
use crate::numerics::V3;
use crate::system::pose::Pose;

/// The fewest segments of a line here.
const FEWEST: usize = 2;

/// Writes the lines.
pub fn write(case: &mut CaseText<'_>, context: &Context<'_>) {
    let mooring = context.mooring;
    let ways = Ways {
        pasts: Pasts::of_mooring(mooring),
        failures: failures_by_line(mooring),
    };
    for chain in chains(mooring, &context.joints) {
        one_line(case, context, &chain, &ways);
    }
}

/// What lines are looked up by.
struct Ways {
    pasts: Pasts,
    /// Of each line that comes off alone, the rows that say so.
    failures: HashMap<usize, Vec<usize>>,
}

fn failures_by_line(mooring: &Mooring) -> HashMap<usize, Vec<usize>> {
    let mut by_line: HashMap<usize, Vec<usize>> = HashMap::new();
    for (number, failure) in mooring.failures.iter().enumerate() {
        if let [line] = failure.lines.as_slice() {
            by_line.entry(*line).or_default().push(number);
        }
    }
    by_line
}

fn one_line(case: &mut CaseText<'_>, context: &Context<'_>, chain: &Chain, ways: &Ways) {
    let mooring = context.mooring;
    let first = &mooring.lines[chain.pieces[0].0];
    case.table("[[lines]]", Some(&first.span));
    let name = &context.names.lines[chain.pieces[0].0];
    case.line(&format!("name = {}", text(name)), Some(&first.span));
    for (key, end) in ["from", "to"].iter().zip(chain.ends) {
        let name = text(&name_of(context, end));
        case.line(&format!("{key} = {name}"), Some(&first.span));
    }
    if let [(only, _)] = chain.pieces.as_slice() {
        let line = &mooring.lines[*only];
        let material = text(&materials::name_of(
            mooring,
            &context.names,
            &ways.pasts,
            *only,
        ));
        case.given("material", &material, &line.of_type.span, "LineType");
        case.given(
            "length_m",
            &number(line.length.value),
            &line.length.span,
            "UnstrLen",
        );
    }
    segments(case, mooring, chain);
    if let Some(flag) = &first.without_bed {
        case.given("bed_contact", "false", flag, "OMIT_CONTACT");
    }
    // Below 0 it is not used: where it would act it is refused.
    let friction = &mooring.line_types[first.of_type.value].friction;
    if let Some(friction) = friction.as_ref().filter(|given| given.value >= 0.0) {
        case.given("friction", &number(friction.value), &friction.span, "CB");
    }
    repeats(case, mooring);
    clamps(case, context, chain);
    releases(case, context, chain, ways);
    if chain.pieces.len() > 1 {
        sections(case, context, chain, &ways.pasts);
    }
}

/// The segments of all pieces of a line together.
fn segments(case: &mut CaseText<'_>, mooring: &Mooring, chain: &Chain) {
    let pieces = chain.pieces.iter();
    let segments: usize = pieces
        .map(|(line, _)| mooring.lines[*line].segments.value)
        .sum();
    if segments == 0 {
        return;
    }
    let value = segments.max(FEWEST).to_string();
    let what = match segments < FEWEST {
        true => "NumSegs; no line here has fewer",
        false => "NumSegs",
    };
    let first = &mooring.lines[chain.pieces[0].0];
    case.given("segments", &value, &first.segments.span, what);
}

/// Angles at which all lines are repeated about the vertical axis.
fn repeats(case: &mut CaseText<'_>, mooring: &Mooring) {
    let Some(first) = mooring.repeats.first() else {
        return;
    };
    let mut angles = vec![0.0];
    // MAP++ turns them clockwise as seen from above (expand_node_position_z of its src/mapinit.c).
    let repeats = mooring.repeats.iter();
    angles.extend(repeats.map(|angle| (-angle.value).rem_euclid(360.0)));
    case.given("repeat_at_deg", &numbers(&angles), &first.span, "repeat");
}

/// Directions of lines that bend, at the rods that hold them.
fn clamps(case: &mut CaseText<'_>, context: &Context<'_>, chain: &Chain) {
    let mooring = context.mooring;
    for (end, letter) in ["a", "b"].iter().enumerate() {
        let Attachment::Rod(rod, rod_end) = chain.ends[end] else {
            continue;
        };
        let piece = if end == 0 {
            chain.pieces.first()
        } else {
            chain.pieces.last()
        };
        let bends = piece.is_some_and(|(line, _)| {
            let of_type = mooring.lines[*line].of_type.value;
            mooring.line_types[of_type].bending.value > 0.0
        });
        let rod = &mooring.rods[rod];
        // A joint that turns has no directions of its own.
        let holds = !(rod.is_joint() && rod.hold.value.turns());
        let axis = axis_of(mooring, rod);
        if !bends || !holds || axis.norm() == 0.0 {
            continue;
        }
        // The line goes on where the rod ends: out of its end at A, into it at B.
        let outwards = if rod_end == 1 { axis } else { -axis };
        let along = if end == 0 { outwards } else { -outwards }.normalize();
        let elevation = along.z.clamp(-1.0, 1.0).asin().to_degrees();
        let span = &rod.ends[0][0].span;
        case.given(
            &format!("clamp_{letter}_elevation_deg"),
            &number(elevation),
            span,
            "axis of the rod",
        );
        let azimuth = along.y.atan2(along.x).to_degrees();
        if azimuth != 0.0 {
            case.given(
                &format!("clamp_{letter}_azimuth_deg"),
                &number(azimuth),
                span,
                "",
            );
        }
    }
}

/// The axis of a rod in space, from its end A to its end B \[m\]: of one on a body, in the frame of that, where the file puts the body.
fn axis_of(mooring: &Mooring, rod: &Rod) -> V3 {
    let axis = V3::from(rod.end(1)) - V3::from(rod.end(0));
    let Hold::Body(body) = rod.hold.value.base() else {
        return axis;
    };
    let angles = mooring.bodies[*body].angles.each_ref();
    let angles = angles.map(|angle| angle.value.to_radians());
    Pose::of_roll_first(V3::zeros(), angles).arm(&axis)
}

fn sections(case: &mut CaseText<'_>, context: &Context<'_>, chain: &Chain, pasts: &Pasts) {
    for (number_of, _) in &chain.pieces {
        let line = &context.mooring.lines[*number_of];
        case.table("[[lines.sections]]", Some(&line.span));
        let material = text(&materials::name_of(
            context.mooring,
            &context.names,
            pasts,
            *number_of,
        ));
        case.given("material", &material, &line.of_type.span, "LineType");
        case.given(
            "length_m",
            &number(line.length.value),
            &line.length.span,
            "UnstrLen",
        );
    }
}

/// Ends that come off in motion.
fn releases(case: &mut CaseText<'_>, context: &Context<'_>, chain: &Chain, ways: &Ways) {
    let pieces = chain.pieces.iter();
    let mut rows: Vec<usize> = pieces
        .filter_map(|(line, _)| ways.failures.get(line))
        .flatten()
        .copied()
        .collect();
    rows.sort_unstable();
    for failure in rows.into_iter().map(|row| &context.mooring.failures[row]) {
        let Some(end) = (0..2).find(|end| chain.ends[*end] == failure.from.value) else {
            continue;
        };
        let letter = ["a", "b"][end];
        if let Some(time) = &failure.time {
            let key = format!("release_{letter}_s");
            case.given(&key, &number(time.value), &time.span, "FailTime");
        }
        if let Some(tension) = &failure.tension {
            let key = format!("release_{letter}_n");
            case.given(&key, &number(tension.value), &tension.span, "FailTen");
        }
    }
}
