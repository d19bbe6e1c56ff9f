//! The ends of the line as points.

use super::copied::{bare, value_of};
use super::end_clumps;
use super::payload;
use super::places::{
    begins, begins_at, hang_point, moves_at_rest, on_free_end, turning, vessel_name,
};
use super::source::{LETTERS, LineSource};
use super::start;
use super::surface;
use super::turning_payload;
use crate::case::{End, EndKind, MotionName};
use crate::import::to_case::case_text::{CaseText, numbers, text};

/// Writes the points at both ends.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let ends = &source.case.ends;
    for (letter, end) in LETTERS.into_iter().zip([&ends.a, &ends.b]) {
        if let Some(payload) = turning(source).filter(|_| letter == LETTERS[1]) {
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
    surface::of_point(system, source);
}

/// The name of the point at an end: of a payload that turns that of the point it hangs from.
pub(super) fn point_name(source: &LineSource<'_>, letter: &str) -> String {
    let ends = &source.case.ends;
    match letter == LETTERS[0] {
        true => ends.a.name.clone(),
        false if turning(source).is_some() => hang_point(source),
        false => ends.b.name.clone(),
    }
}
