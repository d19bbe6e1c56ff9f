//! Clumps at the ends of the line: the body of the point at a free end; at a held end a weight that pulls on nothing but what holds it.

use super::bearing;
use super::copied::{coefficient, value_of};
use super::places::at_end;
use super::published::reads_forces;
use super::source::{DENSITY, LETTERS, LineSource};
use crate::case::{Clump, End, EndKind};
use crate::import::fault::Fault;
use crate::import::to_case::case_text::CaseText;
use crate::scene::clump_bed_area;

/// The names of clumps on held ends, which a system leaves out.
pub(super) fn left_out<'c>(source: &'c LineSource<'_>) -> impl Iterator<Item = &'c str> {
    let ends = &source.case.ends;
    let ends = LETTERS.into_iter().zip([&ends.a, &ends.b]);
    let held = ends.filter(|(_, end)| end.kind.is_held());
    held.flat_map(|(letter, _)| at_end(source, letter).map(|clump| clump.name.as_str()))
}

/// Clumps at ends that a system cannot state.
pub(super) fn faults(source: &LineSource<'_>) -> Vec<Fault> {
    let ends = &source.case.ends;
    let mut found = Vec::new();
    for (letter, end) in LETTERS.into_iter().zip([&ends.a, &ends.b]) {
        for (number, clump) in at_end(source, letter).enumerate() {
            let of_place = match number > 0 || end.kind == EndKind::Payload {
                true => Some((
                    "hangs where another body does, and a system has one there",
                    "make one body of both",
                )),
                false => on_held(source, end),
            };
            let path = ["clumps", &clump.name, "at_m"];
            found.extend(of_place.map(|(problem, remedy)| source.fault(&path, problem, remedy)));
            if end.kind == EndKind::Free {
                found.extend(of_body(source, clump));
            }
        }
    }
    found
}

/// What a clump on a held end acts on.
fn on_held(source: &LineSource<'_>, end: &End) -> Option<(&'static str, &'static str)> {
    if !end.kind.is_held() {
        return None;
    }
    if end.release_s.is_some() {
        return Some((
            "hangs on an end that is let go with it, and that of a system goes alone",
            "hang it on the node before the end",
        ));
    }
    reads_forces(source).then_some((
        "hangs on a held end, whose force in a system is that of the line alone",
        "leave it out, and add its weight to the published force",
    ))
}

/// Weight and contact of a clump that a free point cannot state.
fn of_body(source: &LineSource<'_>, clump: &Clump) -> Vec<Fault> {
    let table = ["clumps", clump.name.as_str()];
    let mut found = Vec::new();
    found.extend(source.fault_of_expression(&[table[0], table[1], "at_m"]));
    found.extend(of_weight(
        source,
        &table,
        (clump.mass_kg, clump.wet_mass_kg),
    ));
    if bears_by_mass(source, clump) {
        let keys = ["mass_kg", "wet_mass_kg"].into_iter();
        found.extend(keys.filter_map(|key| source.fault_of_expression(&[table[0], table[1], key])));
        found.extend(source.fault_of_expression(&DENSITY));
    }
    for key in ["drag_area_normal_m2", "drag_area_tangential_m2"] {
        let path = [table[0], table[1], key];
        found.extend(source.node(&path).filter(|_| clump.is_aligned()).map(|_| {
            let problem =
                "goes with the direction of the line, and that of a point of a system does not";
            source.fault(&path, problem, "hang it on the node before the end")
        }));
    }
    found
}

/// Whether the area of a clump on the bed follows from what it displaces.
pub(super) fn bears_by_mass(source: &LineSource<'_>, clump: &Clump) -> bool {
    source.case.seabed.is_some() && clump.bed_area_m2.is_none()
}

/// Mass and weight in water of a body, as masses \[kg\], that a free point cannot state.
pub(super) fn of_weight(
    source: &LineSource<'_>,
    table: &[&str],
    (mass, wet): (f64, f64),
) -> Option<Fault> {
    let in_air = source.case.environment.water_density_kg_per_m3 == 0.0;
    (wet > mass && !in_air).then(|| {
        let problem =
            "is more than the mass in air, and a point of a system displaces no less than nothing";
        let key = [table, &["wet_mass_kg"]].concat();
        source.fault(&key, problem, "give the mass or less")
    })
}

/// Writes the clump of a free end.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>, clump: &Clump) {
    let table = ["clumps", clump.name.as_str()];
    write_weight(system, source, &table);
    for (key, value) in [
        ("drag_area_m2", &clump.drag_area_m2),
        ("added_mass_kg", &clump.added_mass_kg),
    ] {
        coefficient(system, source, &[table[0], table[1], key], value);
    }
    let area = clump_bed_area(clump, &source.case.environment);
    bearing::write(system, source, &table, area);
}

/// Writes the mass of a point and that which weighs as much as it does in water.
pub(super) fn write_weight(system: &mut CaseText<'_>, source: &LineSource<'_>, table: &[&str]) {
    for key in ["mass_kg", "wet_mass_kg"] {
        if let Some(own) = source.node(&[table, &[key]].concat()) {
            system.given(key, &value_of(source, own), &own.span, "");
        }
    }
}
