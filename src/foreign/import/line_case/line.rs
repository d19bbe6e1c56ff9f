//! The line itself: its sections, clamps and releases.

use super::copied::{copy_table, value_of};
use super::ends::point_name;
use super::lines::{ConvertedLine, ConvertedSection, lines};
use super::places::end_of;
use super::source::{LETTERS, LineSource};
use super::start;
use crate::case::{EndKind, TomlNode};
use crate::import::to_case::case_text::{CaseText, number, text};

/// Keys of how a clump bears on a bed.
const BEARING: [&str; 4] = [
    "bed_area_m2",
    "bottom_m",
    "breakout_n",
    "breakout_distance_m",
];

/// Writes the line, or the two lines on either side of a body that travels.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let [a, b] = LETTERS.map(|letter| (point_name(source, letter), Some(letter)));
    let body = source.case.traveller.as_ref();
    let body = body.map_or_else(String::new, |body| body.name.clone());
    let lines = lines(&source.case);
    let ends = match lines.len() {
        1 => vec![[a, b]],
        _ => vec![[a, (body.clone(), None)], [(body, None), b]],
    };
    for (line, ends) in lines.iter().zip(ends) {
        system.table("[[lines]]", source.span(&["line"]));
        system.line(&format!("name = {}", text(line.name)), None);
        for (key, (point, letter)) in ["from", "to"].into_iter().zip(&ends) {
            let span = letter.and_then(|letter| source.span(&["ends", letter, "name"]));
            system.line(&format!("{key} = {}", text(point)), span);
        }
        let is_one = line.is_one();
        for own in line.sections.iter().filter(|_| is_one) {
            section(system, source, *own, false);
        }
        for letter in ends.iter().filter_map(|(_, letter)| *letter) {
            held(system, source, letter);
        }
        for own in line.sections.iter().filter(|_| !is_one) {
            system.table("[[lines.sections]]", source.span(&["line", &own.of.name]));
            section(system, source, *own, true);
        }
        attached(system, source, line);
        start::of_line(system, source);
    }
}

/// What is attached to a line between its ends.
fn attached(system: &mut CaseText<'_>, source: &LineSource<'_>, line: &ConvertedLine<'_>) {
    let one = ["section"];
    let without: &[&str] = if line.is_one() { &one } else { &[] };
    for table in ["floats", "modules", "clumps"] {
        let nodes = source.node(&[table]).map_or(&[][..], |list| list.items());
        let header = format!("[[lines.{table}]]");
        for (number, node) in nodes.iter().enumerate() {
            let clump = source.case.clumps.get(number).filter(|_| table == "clumps");
            let at_end = clump.is_some_and(|clump| end_of(&source.case, clump).is_some());
            if at_end || !is_on(line, node) {
                continue;
            }
            let is_deaf = table == "clumps" && source.case.seabed.is_none();
            let bearing = if is_deaf { &BEARING[..] } else { &[] };
            let without = [without, bearing].concat();
            copy_table(system, source, &header, node, &without);
        }
    }
}

/// Whether what a table attaches is on a line: on a section of it that is whole, as all are where no body travels.
fn is_on(line: &ConvertedLine<'_>, attached: &TomlNode) -> bool {
    let name = attached.get("section").and_then(|section| section.text());
    let mut whole = line.sections.iter().filter(|own| own.part.is_none());
    whole.any(|own| name.is_none_or(|name| own.of.name == name))
}

/// The clamp of an end of the case, and when it is let go.
fn held(system: &mut CaseText<'_>, source: &LineSource<'_>, letter: &str) {
    for key in ["clamp_elevation_deg", "clamp_azimuth_deg"] {
        let own = key.replacen("clamp", &format!("clamp_{letter}"), 1);
        given(system, source, &["ends", letter, key], &own);
    }
    if source.is_in_time() {
        let own = format!("release_{letter}_s");
        given(system, source, &["ends", letter, "release_s"], &own);
        let ends = &source.case.ends;
        if letter == LETTERS[1] && ends.b.kind == EndKind::Payload {
            given(system, source, &["payload", "release_s"], &own);
        }
    }
}

/// A key that has another name in the case.
fn given(system: &mut CaseText<'_>, source: &LineSource<'_>, path: &[&str], key: &str) {
    if let Some(node) = source.node(path) {
        system.given(key, &value_of(source, node), &node.span, "");
    }
}

/// The keys of a section, by its name or without.
fn section(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    own: ConvertedSection<'_>,
    is_named: bool,
) {
    let keys = ["name", "material", "length_m", "segments"];
    for key in keys.into_iter().filter(|key| is_named || *key != "name") {
        let node = source.node(&["line", &own.of.name, key]);
        let Some(node) = node else { continue };
        match (key, own.part) {
            ("length_m", Some((length, _))) => {
                system.given(key, &number(length), &node.span, "a part of it");
            }
            ("segments", Some((_, segments))) => {
                system.given(key, &segments.to_string(), &node.span, "a part of them");
            }
            _ => system.given(key, &value_of(source, node), &node.span, ""),
        }
    }
}
