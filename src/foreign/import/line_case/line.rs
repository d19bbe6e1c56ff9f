//! The line itself: its sections, clamps and releases.

use super::buoyed::name_of;
use super::copied::value_of;
use super::ends::point_name;
use super::source::{LETTERS, LineSource};
use super::start;
use super::stretches::{Stretch, is_one, lines};
use crate::case::{Clump, EndKind};
use crate::import::to_case::case_text::{CaseText, number, text};

/// Writes the line, or the two lines on either side of a body that travels.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>, line: &[Stretch<'_>]) {
    let [a, b] = LETTERS.map(|letter| (point_name(source, letter), Some(letter)));
    let body = source.case.traveller.as_ref();
    let body = body.map_or_else(String::new, |body| body.name.clone());
    let lines = lines(line);
    let ends = match lines.len() {
        1 => vec![[a, b]],
        _ => vec![[a, (body.clone(), None)], [(body, None), b]],
    };
    for ((name, first, own), ends) in lines.into_iter().zip(ends) {
        system.table("[[lines]]", source.span(&["line"]));
        system.line(&format!("name = {}", text(name)), None);
        for (key, (point, letter)) in ["from", "to"].into_iter().zip(&ends) {
            let span = letter.and_then(|letter| source.span(&["ends", letter, "name"]));
            system.line(&format!("{key} = {}", text(point)), span);
        }
        if is_one(own) {
            section(system, source, line, first);
        }
        for (_, letter) in &ends {
            held(system, source, *letter);
        }
        if !is_one(own) {
            for (number, stretch) in own.iter().enumerate() {
                let name = &source.case.line[stretch.section].name;
                system.table("[[lines.sections]]", source.span(&["line", name]));
                section(system, source, line, first + number);
            }
        }
        start::of_line(system, source);
    }
}

/// The clamp of an end of the case, and when it is let go.
fn held(system: &mut CaseText<'_>, source: &LineSource<'_>, letter: Option<&str>) {
    let Some(letter) = letter else {
        return;
    };
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
        system.given(key, &value_of(source, node), &node.span, &path.join("."));
    }
}

/// A section of the line, by the number of its stretch.
fn section(system: &mut CaseText<'_>, source: &LineSource<'_>, line: &[Stretch<'_>], of: usize) {
    let stretch = &line[of];
    let own = &source.case.line[stretch.section];
    let span = |key: &str| {
        source
            .span(&["line", &own.name, key])
            .cloned()
            .unwrap_or(0..0)
    };
    let material = text(&name_of(source, line, of));
    system.given("material", &material, &span("material"), "");
    match source
        .node(&["line", &own.name, "length_m"])
        .filter(|_| stretch.is_whole)
    {
        Some(node) => system.given("length_m", &value_of(source, node), &node.span, ""),
        None => system.given(
            "length_m",
            &number(stretch.length_m),
            &span("length_m"),
            "a part of it",
        ),
    }
    match source
        .node(&["line", &own.name, "segments"])
        .filter(|_| stretch.is_whole)
    {
        Some(node) => system.given("segments", &value_of(source, node), &node.span, ""),
        None => system.given(
            "segments",
            &stretch.segments.to_string(),
            &span("segments"),
            "a part of them",
        ),
    }
    if let Some(clump) = stretch.clump {
        hung(system, source, clump);
    }
}

/// The body at the end of a section.
fn hung(system: &mut CaseText<'_>, source: &LineSource<'_>, clump: &Clump) {
    let mut one = |key: &str, from: &str| {
        if let Some(node) = source.node(&["clumps", &clump.name, from]) {
            system.given(key, &value_of(source, node), &node.span, from);
        }
    };
    one("clump_kg", "wet_mass_kg");
    one("clump_mass_kg", "mass_kg");
    one("clump_drag_area_normal_m2", "drag_area_normal_m2");
    one("clump_drag_area_tangential_m2", "drag_area_tangential_m2");
    let both = [
        ("clump_drag_area_m2", "drag_area_m2", &clump.drag_area_m2),
        ("clump_added_mass_kg", "added_mass_kg", &clump.added_mass_kg),
    ];
    for (key, from, value) in both {
        let node = source.node(&["clumps", &clump.name, from]);
        if let Some(node) = node.filter(|_| !value.is_zero()) {
            system.given(key, &value_of(source, node), &node.span, from);
        }
    }
    let bearing = [
        "bed_area_m2",
        "bottom_m",
        "breakout_n",
        "breakout_distance_m",
    ];
    for from in bearing.into_iter().filter(|_| source.case.seabed.is_some()) {
        if let Some(node) = source.node(&["clumps", &clump.name, from]) {
            let key = format!("clump_{from}");
            system.given(&key, &value_of(source, node), &node.span, from);
        }
    }
}
