//! What acts in a case and a system cannot state.

use super::ends::moves_at_rest;
use super::payload;
use super::source::{DENSITY, LETTERS, LineSource};
use super::stretches::end_of;
use super::traveller;
use crate::case::{Clump, DragCoefficient, End, EndKind, MotionName};
use crate::import::fault::Fault;

/// All of it, but for what the mesh and the results show.
pub(super) fn faults(source: &LineSource<'_>) -> Vec<Fault> {
    let mut found = Vec::new();
    if let Some(body) = &source.case.traveller {
        found.extend(traveller::faults(source, body));
    }
    for (letter, end) in LETTERS
        .into_iter()
        .zip([&source.case.ends.a, &source.case.ends.b])
    {
        found.extend(motion(source, letter, end));
    }
    if source.case.ends.b.kind == EndKind::Payload {
        found.extend(payload::faults(source));
    }
    found.extend(clumps(source));
    found.extend(buoyed(source));
    found.extend(start(source));
    found
}

/// The motion of an end.
fn motion(source: &LineSource<'_>, letter: &str, end: &End) -> Vec<Fault> {
    let path = |key| ["ends", letter, key];
    let mut found = Vec::new();
    if end.kind != EndKind::Moving {
        return found;
    }
    if end.motion == MotionName::Vessel && source.is_in_time() {
        found.extend(source.fault_of_expression(&path("hang_point_m")));
        let waves = source.case.waves.as_ref();
        if waves.is_some_and(|waves| waves.ramp_s > end.ramp_s) {
            let problem = "is shorter than that of the waves, with which the motion of a body of a system grows";
            let remedy = "give the ramp_s of the waves, or a longer one";
            found.push(source.fault(&path("ramp_s"), problem, remedy));
        }
    }
    if !source.is_in_time() && moves_at_rest(source, end) {
        let keys = ["position_m", "amplitude_m", "phase_deg"];
        found.extend(
            keys.iter()
                .filter_map(|key| source.fault_of_expression(&path(key))),
        );
    }
    found
}

/// Expressions in what says where clumps between the ends hang.
fn clumps(source: &LineSource<'_>) -> Vec<Fault> {
    let clumps = source.case.clumps.iter();
    let between = clumps.filter(|clump| end_of(&source.case, clump).is_none());
    let at = |clump: &Clump| source.fault_of_expression(&["clumps", &clump.name, "at_m"]);
    between.filter_map(at).collect()
}

/// Modules on a line whose drag goes by a law, or on a pipe with a bore; expressions in what they are computed from.
fn buoyed(source: &LineSource<'_>) -> Vec<Fault> {
    let case = &source.case;
    let floats = case.floats.iter().map(|of| ("floats", of.section.as_str()));
    let modules = case
        .modules
        .iter()
        .map(|of| ("modules", of.section.as_str()));
    let mut found = Vec::new();
    for (table, section) in floats.chain(modules) {
        let entries = source
            .node(&[table, section])
            .map_or(&[][..], |node| node.entries());
        for entry in entries.iter().filter(|entry| entry.key != "section") {
            found.extend(source.fault_of_expression(&[table, section, &entry.key]));
        }
        let Some(own) = case.line.iter().find(|one| one.name == section) else {
            continue;
        };
        for key in ["length_m", "segments"] {
            found.extend(source.fault_of_expression(&["line", section, key]));
        }
        found.extend(under(source, table, &own.material));
        found.extend(along_law(source, (table, section), &own.material));
    }
    found
}

/// Drag of floats along a line whose own goes by a law.
fn along_law(source: &LineSource<'_>, (table, section): (&str, &str), name: &str) -> Option<Fault> {
    let material = source.case.materials.get(name)?;
    let is_law = matches!(material.drag_tangential, DragCoefficient::Named(_));
    let mut floats = source.case.floats.iter();
    let drags = floats.any(|one| one.section == section && one.drag_area_tangential_m2 > 0.0);
    let acts = table == "floats" && is_law && drags;
    let problem = "goes along a line whose drag is a law of the Reynolds number";
    acts.then(|| {
        let path = [table, section, "drag_area_tangential_m2"];
        source.fault(&path, problem, "give the line a coefficient")
    })
}

/// A material under floats or modules.
fn under(source: &LineSource<'_>, table: &str, name: &str) -> Vec<Fault> {
    let Some(material) = source.case.materials.get(name) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    let drags = [
        ("drag_normal", &material.drag_normal),
        ("drag_tangential", &material.drag_tangential),
    ];
    for (key, drag) in drags {
        if table == "modules" && matches!(drag, DragCoefficient::Named(_)) {
            let problem = "is a law of the Reynolds number, under modules of a constant coefficient that cover a part of the line";
            found.push(source.fault(&["materials", name, key], problem, "give a coefficient"));
        }
    }
    if table == "modules" && material.bore.is_some() {
        let problem = "is a pipe under modules, which a system has as a thicker line";
        found.push(source.fault(&["materials", name, "bore"], problem, "leave the bore out"));
    }
    let keys = [
        "diameter_m",
        "mass_kg_per_m",
        "wet_weight_kg_per_m",
        "axial_damping_ratio",
        "added_mass_normal",
        "added_mass_tangential",
    ];
    found.extend(
        keys.into_iter()
            .filter_map(|key| source.fault_of_expression(&["materials", name, key])),
    );
    found.extend(source.fault_of_expression(&DENSITY));
    found
}

/// A start that is no equilibrium.
fn start(source: &LineSource<'_>) -> Vec<Fault> {
    let start = &source.case.start;
    let mut found = Vec::new();
    if start.from_run.is_some() {
        let problem = "a system begins at no stored run of a line";
        found.push(source.fault(&["start", "from_run"], problem, "start in equilibrium"));
    }
    found
}
