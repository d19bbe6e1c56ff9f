//! Where ends, payloads and clumps are.

use super::source::{LETTERS, LineSource};
use super::start;
use crate::case::{
    Case, Clump, End, EndKind, MotionName, OnSection, Payload, Rotation, Section, StartShape,
};
use crate::scene::end_motion;

/// The letter of the end of the line that a clump hangs at; nothing between the ends.
pub(super) fn end_of(case: &Case, clump: &Clump) -> Option<&'static str> {
    let number = case
        .line
        .iter()
        .position(|one| clump.is_on(Some(&one.name)))?;
    let section = &case.line[number];
    match nearest(section, clump) {
        0 if number == 0 => Some(LETTERS[0]),
        node if node == section.segments && number + 1 == case.line.len() => Some(LETTERS[1]),
        _ => None,
    }
}

/// The clumps at an end, by its letter.
pub(super) fn at_end<'c>(
    source: &'c LineSource<'_>,
    letter: &'static str,
) -> impl Iterator<Item = &'c Clump> {
    let case = &source.case;
    let clumps = case.clumps.iter();
    clumps.filter(move |clump| end_of(case, clump) == Some(letter))
}

/// The clump that is the body of a free end.
pub(super) fn on_free_end<'c>(source: &'c LineSource<'_>, letter: &str) -> Option<&'c Clump> {
    let ends = &source.case.ends;
    let (letter, end) = match letter == LETTERS[0] {
        true => (LETTERS[0], &ends.a),
        false => (LETTERS[1], &ends.b),
    };
    at_end(source, letter)
        .next()
        .filter(|_| end.kind == EndKind::Free)
}

/// The node that a clump hangs at: the nearest.
fn nearest(section: &Section, clump: &Clump) -> usize {
    whole(
        (clump.at_m / section.length_m * section.segments as f64).round(),
        section,
    )
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a number of a node, between 0 and the segments of its section"
)]
fn whole(node: f64, section: &Section) -> usize {
    (node.max(0.0) as usize).min(section.segments)
}

/// Whether the motion of an end begins off its position.
pub(super) fn moves_at_rest(source: &LineSource<'_>, end: &End) -> bool {
    end.position_m
        .is_some_and(|place| begins(source, end) != place)
}

/// Where the motion of an end begins \[m\].
pub(super) fn begins(source: &LineSource<'_>, end: &End) -> [f64; 3] {
    let key = "ends";
    let motion = end_motion(&source.case, end, key).ok().flatten();
    let place = motion.map(|motion| motion.at(0.0).0.into());
    place.or(end.position_m).unwrap_or_default()
}

/// Where a free end begins or its search does \[m\], in numbers and words.
pub(super) fn begins_at(source: &LineSource<'_>, letter: &str) -> ([f64; 3], &'static str) {
    match start::is_in_shape(source) {
        true => (start::place(source, letter), "where it begins"),
        false if start::is_searched_from(source) => {
            (start::place(source, letter), "its search begins here")
        }
        false => (search_from(source, letter), "its search begins here"),
    }
}

/// Where the search for a free end begins \[m\]: the length of the line away from the other end, downwards unless the case says where to, and
/// not below the bed.
fn search_from(source: &LineSource<'_>, letter: &str) -> [f64; 3] {
    let case = &source.case;
    let other = if letter == "a" {
        &case.ends.b
    } else {
        &case.ends.a
    };
    let [x, y, z] = other.position_m.unwrap_or_default();
    let length: f64 = case.line.iter().map(|section| section.length_m).sum();
    let (elevation, azimuth) = match (other.clamp_elevation_deg, case.start.shape) {
        (Some(elevation), _) => (elevation, other.clamp_azimuth_deg),
        (None, StartShape::Straight) => (case.start.elevation_deg, case.start.azimuth_deg),
        (None, _) => (-90.0, 0.0),
    };
    let (sin, cos) = elevation.to_radians().sin_cos();
    let (across, along) = azimuth.to_radians().sin_cos();
    let bed = case
        .seabed
        .as_ref()
        .map_or(f64::NEG_INFINITY, |bed| -bed.depth_m);
    let clump = on_free_end(source, letter).map(|clump| clump.bottom_m);
    let payload = case.payload.as_ref().and_then(|payload| payload.bottom_m);
    let down = (z + length * sin).max(bed + clump.or(payload).unwrap_or(0.0));
    [x + length * cos * along, y + length * cos * across, down]
}

/// Whether an end is on a vessel, which of a system in time is a body.
pub(super) fn is_on_vessel(source: &LineSource<'_>, end: &End) -> bool {
    source.is_in_time() && end.kind == EndKind::Moving && end.motion == MotionName::Vessel
}

/// The body that an end on a vessel is on.
pub(super) fn vessel_name(end: &End) -> String {
    format!("vessel-at-{}", end.name)
}

/// The payload that turns, with its rotation, where the case has one.
pub(super) fn turning<'c>(source: &'c LineSource<'_>) -> Option<(&'c Payload, &'c Rotation)> {
    let payload = source.case.payload.as_ref()?;
    let hangs = source.case.ends.b.kind == EndKind::Payload;
    payload
        .rotation
        .as_ref()
        .filter(|_| hangs)
        .map(|rotation| (payload, rotation))
}

/// The name of the point that it hangs from.
pub(super) fn hang_point(source: &LineSource<'_>) -> String {
    format!("{}-hang-point", source.case.ends.b.name)
}

/// The name of the point of it that bears on the bed.
pub(super) fn bottom_point(source: &LineSource<'_>) -> String {
    format!("{}-bottom", source.case.ends.b.name)
}
