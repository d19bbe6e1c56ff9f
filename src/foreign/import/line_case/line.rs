//! The line itself: its sections, clamps and releases.

use super::copied::{copy_table, value_of};
use super::ends::point_name;
use super::places::{end_of, is_one};
use super::source::{LETTERS, LINE, LineSource};
use super::start;
use crate::case::{EndKind, Section};
use crate::import::to_case::case_text::{CaseText, text};

/// Keys of how a clump bears on a bed.
const BEARING: [&str; 4] = [
    "bed_area_m2",
    "bottom_m",
    "breakout_n",
    "breakout_distance_m",
];

/// Writes the line.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let [a, b] = LETTERS.map(|letter| point_name(source, letter));
    system.table("[[lines]]", source.span(&["line"]));
    system.line(&format!("name = {}", text(LINE)), None);
    system.line(
        &format!("from = {}", text(&a)),
        source.span(&["ends", "a", "name"]),
    );
    system.line(
        &format!("to = {}", text(&b)),
        source.span(&["ends", "b", "name"]),
    );
    let sections = source.case.line.iter();
    let is_one = is_one(&source.case);
    for own in sections.clone().filter(|_| is_one) {
        section(system, source, own);
    }
    held(system, source);
    for own in sections.filter(|_| !is_one) {
        system.table("[[lines.sections]]", source.span(&["line", &own.name]));
        section(system, source, own);
    }
    attached(system, source);
    start::of_line(system, source);
}

/// What is attached to the line between its ends.
fn attached(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let one = ["section"];
    let without: &[&str] = if is_one(&source.case) { &one } else { &[] };
    for table in ["floats", "modules", "clumps"] {
        let nodes = source.node(&[table]).map_or(&[][..], |list| list.items());
        let header = format!("[[lines.{table}]]");
        for (number, node) in nodes.iter().enumerate() {
            let clump = source.case.clumps.get(number).filter(|_| table == "clumps");
            if clump.is_some_and(|clump| end_of(&source.case, clump).is_some()) {
                continue;
            }
            let is_deaf = table == "clumps" && source.case.seabed.is_none();
            let bearing = if is_deaf { &BEARING[..] } else { &[] };
            let without = [without, bearing].concat();
            copy_table(system, source, &header, node, &without);
        }
    }
}

/// Clamps of the ends, and when they are let go.
fn held(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let ends = &source.case.ends;
    for (letter, end) in LETTERS.into_iter().zip([&ends.a, &ends.b]) {
        for key in ["clamp_elevation_deg", "clamp_azimuth_deg"] {
            let own = key.replacen("clamp", &format!("clamp_{letter}"), 1);
            given(system, source, &["ends", letter, key], &own);
        }
        if source.is_in_time() {
            let own = format!("release_{letter}_s");
            given(system, source, &["ends", letter, "release_s"], &own);
            if end.kind == EndKind::Payload {
                given(system, source, &["payload", "release_s"], &own);
            }
        }
    }
}

/// A key that has another name in the case.
fn given(system: &mut CaseText<'_>, source: &LineSource<'_>, path: &[&str], key: &str) {
    if let Some(node) = source.node(path) {
        system.given(key, &value_of(source, node), &node.span, &path.join("."));
    }
}

/// The keys of a section.
fn section(system: &mut CaseText<'_>, source: &LineSource<'_>, own: &Section) {
    let keys = ["name", "material", "length_m", "segments"];
    let is_named = !is_one(&source.case);
    for key in keys.into_iter().filter(|key| is_named || *key != "name") {
        if let Some(node) = source.node(&["line", &own.name, key]) {
            system.given(key, &value_of(source, node), &node.span, "");
        }
    }
}
