//! The ends of the line as points.

use super::copied::{bare, value_of};
use super::end_clumps;
use super::payload;
use super::places::on_free_end;
use super::source::{LETTERS, LineSource};
use super::start;
use super::turning_payload;
use crate::case::{End, EndKind, MotionName, StartShape};
use crate::import::to_case::case_text::{CaseText, numbers, text};
use crate::scene::end_motion;

/// Writes the points at both ends.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let ends = &source.case.ends;
    for (letter, end) in LETTERS.into_iter().zip([&ends.a, &ends.b]) {
        if let Some(payload) = turning_payload::turning(source).filter(|_| letter == LETTERS[1]) {
            let (hang, _) = begins_at(source, letter);
            turning_payload::write(system, source, payload, hang);
            continue;
        }
        let header = format!("[points.{}]", bare(&end.name));
        system.table(&header, source.span(&["ends", letter]));
        match end.kind {
            EndKind::Fixed | EndKind::Anchor => held(system, source, letter, "fixed"),
            EndKind::Moving if !source.is_in_time() => at_rest(system, source, letter, end),
            EndKind::Moving if end.motion == MotionName::Vessel => {
                on_vessel(system, source, letter, end);
            }
            EndKind::Moving => moved(system, source, letter, end),
            EndKind::Free | EndKind::Payload => free(system, source, letter, end),
        }
    }
}

/// Copies keys of an end that points have by the same names.
fn copy(system: &mut CaseText<'_>, source: &LineSource<'_>, letter: &str, keys: &[&str]) {
    for key in keys {
        let path = ["ends", letter, *key];
        if let Some(node) = source.node(&path) {
            system.given(key, &value_of(source, node), &node.span, "");
        }
    }
}

fn held(system: &mut CaseText<'_>, source: &LineSource<'_>, letter: &str, kind: &str) {
    system.line(
        &format!("kind = \"{kind}\""),
        source.span(&["ends", letter, "kind"]),
    );
    copy(system, source, letter, &["position_m"]);
}

fn moved(system: &mut CaseText<'_>, source: &LineSource<'_>, letter: &str, end: &End) {
    held(system, source, letter, "moved");
    match end.motion {
        MotionName::Table => table(system, source, letter),
        MotionName::Harmonic => {
            copy(
                system,
                source,
                letter,
                &["amplitude_m", "period_s", "phase_deg"],
            );
        }
        // A vessel is a body.
        MotionName::Irregular | MotionName::Vessel => {
            let keys = ["rms_m", "peak_period_s", "gamma", "components", "seed"];
            copy(system, source, letter, &keys);
        }
    }
    copy(system, source, letter, &["ramp_s"]);
}

/// A moving end of a case at rest: held where its motion begins.
fn at_rest(system: &mut CaseText<'_>, source: &LineSource<'_>, letter: &str, end: &End) {
    match moves_at_rest(source, end) {
        false => held(system, source, letter, "fixed"),
        true => {
            system.line("kind = \"fixed\"", source.span(&["ends", letter, "kind"]));
            let place = begins(source, end);
            system.assumed("position_m", &numbers(&place), "where its motion begins");
        }
    }
}

/// Whether the motion of an end begins off its position.
pub(super) fn moves_at_rest(source: &LineSource<'_>, end: &End) -> bool {
    end.position_m
        .is_some_and(|place| begins(source, end) != place)
}

/// Where the motion of an end begins \[m\].
fn begins(source: &LineSource<'_>, end: &End) -> [f64; 3] {
    let key = "ends";
    let motion = end_motion(&source.case, end, key).ok().flatten();
    let place = motion.map(|motion| motion.at(0.0).0.into());
    place.or(end.position_m).unwrap_or_default()
}

/// An end on a vessel in waves: a point on a moved body, whose origin it is.
fn on_vessel(system: &mut CaseText<'_>, source: &LineSource<'_>, letter: &str, end: &End) {
    let vessel = vessel_name(end);
    system.line("kind = \"body\"", source.span(&["ends", letter, "kind"]));
    system.line(&format!("body = {}", text(&vessel)), None);
    system.line("position_m = [0.0, 0.0, 0.0]", None);
    let header = format!("[bodies.{}]", bare(&vessel));
    system.table(&header, source.span(&["ends", letter, "motion"]));
    system.line("kind = \"moved\"", None);
    copy(system, source, letter, &["position_m"]);
    let at = |key| source.node(&["ends", letter, key]);
    if let Some(node) = at("heading_deg") {
        system.given("yaw_deg", &value_of(source, node), &node.span, "");
    }
    if let Some(node) = at("motion_file") {
        system.given("response_file", &value_of(source, node), &node.span, "");
    }
    if let Some(node) = at("hang_point_m") {
        let back = end.hang_point_m.map(|part| 0.0 - part);
        system.given("response_at_m", &numbers(&back), &node.span, "");
    }
    copy(system, source, letter, &["ramp_s"]);
}

/// Whether an end is on a vessel, which of a system in time is a body.
pub(super) fn is_on_vessel(source: &LineSource<'_>, end: &End) -> bool {
    source.is_in_time() && end.kind == EndKind::Moving && end.motion == MotionName::Vessel
}

/// The body that an end on a vessel is on.
pub(super) fn vessel_name(end: &End) -> String {
    format!("vessel-at-{}", end.name)
}

/// The file of a motion, and how its rows are interpolated.
fn table(system: &mut CaseText<'_>, source: &LineSource<'_>, letter: &str) {
    copy(system, source, letter, &["motion_file"]);
    let interpolation = ["ends", letter, "motion_interpolation"];
    if let Some(node) = source.node(&interpolation) {
        let value = value_of(source, node);
        system.given("table_interpolation", &value, &node.span, "");
    }
}

fn free(system: &mut CaseText<'_>, source: &LineSource<'_>, letter: &str, end: &End) {
    system.line("kind = \"free\"", source.span(&["ends", letter, "kind"]));
    let (place, why) = begins_at(source, letter);
    if !start::follows_from_length(source) {
        system.assumed("position_m", &numbers(&place), why);
    }
    if start::is_moving(source)
        && let Some(node) = source.node(&["start", "velocity_m_per_s"])
    {
        let value = value_of(source, node);
        system.given("start_velocity_m_per_s", &value, &node.span, "");
    }
    if let Some(clump) = on_free_end(source, letter) {
        end_clumps::write(system, source, clump);
    }
    let hung = source.case.payload.as_ref();
    if let Some(payload) = hung.filter(|_| end.kind == EndKind::Payload) {
        payload::write(system, source, payload);
    }
}

/// Where a free end begins or its search does \[m\], in numbers and words.
fn begins_at(source: &LineSource<'_>, letter: &str) -> ([f64; 3], &'static str) {
    match start::is_in_shape(source) {
        true => (start::place(source, letter), "where it begins"),
        false if start::is_searched_from(source) => {
            (start::place(source, letter), "its search begins here")
        }
        false => (search_from(source, letter), "its search begins here"),
    }
}

/// Whether an end begins above still water.
pub(super) fn rises_above_water(source: &LineSource<'_>) -> bool {
    let ends = [&source.case.ends.a, &source.case.ends.b];
    let mut ends = LETTERS.into_iter().zip(ends);
    ends.any(|(letter, end)| {
        let place = match end.kind.is_held() {
            true => end.position_m.unwrap_or_default(),
            false => begins_at(source, letter).0,
        };
        place[2] > 0.0
    })
}

/// The name of the point at an end: of a payload that turns that of the point it hangs from.
pub(super) fn point_name(source: &LineSource<'_>, letter: &str) -> String {
    let ends = &source.case.ends;
    match letter == LETTERS[0] {
        true => ends.a.name.clone(),
        false if turning_payload::turning(source).is_some() => turning_payload::hang_point(source),
        false => ends.b.name.clone(),
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
