//! The payload as a free point, and what of it a system cannot state.

use super::bearing::{self, bears_by_volume};
use super::copied::{coefficient, value_of};
use super::end_clumps::of_weight;
use super::source::{DENSITY, LineSource};
use super::turning_payload;
use crate::case::{OneOrMany, Payload};
use crate::import::fault::Fault;
use crate::import::to_case::case_text::{CaseText, number, numbers};
use crate::numerics::V3;
use crate::scene::{payload_bed_area, per_axis, shape_form};

/// What of the payload acts and a free point cannot state.
pub(super) fn faults(source: &LineSource<'_>) -> Vec<Fault> {
    let Some(payload) = &source.case.payload else {
        return Vec::new();
    };
    let mut found = Vec::new();
    if let Some(rotation) = &payload.rotation {
        found.extend(turning_payload::faults(source, rotation));
    }
    found.extend(derived(source, payload));
    found.extend(volume(source, payload));
    found
}

/// Expressions of what the shape or the volume gives, as a number in the system.
fn derived(source: &LineSource<'_>, payload: &Payload) -> Vec<Fault> {
    let mut found = Vec::new();
    let shape = source.node(&["payload", "shape"]);
    let entries = shape.map_or(&[][..], |node| node.entries());
    for entry in entries.iter().filter(|entry| entry.key != "kind") {
        found.extend(source.fault_of_expression(&["payload", "shape", &entry.key]));
    }
    if bears_by_volume(source, payload) {
        found.extend(source.fault_of_expression(&["payload", "volume_m3"]));
    }
    found
}

/// A volume that does not follow, or from expressions: of a body, and of what bears on the bed by it.
fn volume(source: &LineSource<'_>, payload: &Payload) -> Vec<Fault> {
    let mut found = Vec::new();
    let Some(wet) = payload.wet_mass_kg else {
        return found;
    };
    let turns = payload.rotation.is_some();
    if turns || bears_by_volume(source, payload) {
        for key in ["wet_mass_kg", "dry_mass_kg"] {
            found.extend(source.fault_of_expression(&["payload", key]));
        }
        found.extend(source.fault_of_expression(&DENSITY));
    }
    let in_air = source.case.environment.water_density_kg_per_m3 == 0.0;
    if turns && in_air && wet != payload.dry_mass_kg {
        let problem = "differs from the dry mass where there is no water";
        let remedy = "give the density of the water, or the dry mass";
        found.push(source.fault(&["payload", "wet_mass_kg"], problem, remedy));
    }
    if !turns {
        found.extend(of_weight(source, &["payload"], (payload.dry_mass_kg, wet)));
    }
    found
}

/// Writes the displaced volume of the payload, where it is not that of its shape.
pub(super) fn write_volume(system: &mut CaseText<'_>, source: &LineSource<'_>, payload: &Payload) {
    if payload.wet_mass_kg.is_none()
        && let Some(node) = source.node(&["payload", "volume_m3"])
    {
        system.given("volume_m3", &value_of(source, node), &node.span, "");
    }
    let density = source.case.environment.water_density_kg_per_m3;
    if let Some(wet) = payload.wet_mass_kg
        && let Some(span) = source.span(&["payload", "wet_mass_kg"])
        && density > 0.0
    {
        let volume = (payload.dry_mass_kg - wet) / density;
        system.given(
            "volume_m3",
            &number(volume),
            span,
            "dry_mass_kg less wet_mass_kg, by the density of the water",
        );
    }
    let form = payload.shape.as_ref().map(shape_form);
    if let Some(form) =
        form.filter(|_| payload.wet_mass_kg.is_none() && payload.volume_m3.is_none())
    {
        system.assumed("volume_m3", &number(form.volume), "by its shape");
    }
}

/// Drag area \[m²\] and added mass \[kg\] of the payload along x, y, z.
pub(super) struct Hydrodynamics {
    pub(super) drag_area: V3,
    pub(super) added_mass: V3,
}

/// As they are given, or follow from the shape.
pub(super) fn hydrodynamics(source: &LineSource<'_>, payload: &Payload) -> Hydrodynamics {
    let form = payload.shape.as_ref().map(shape_form);
    let density = source.case.environment.water_density_kg_per_m3;
    let given = |value: &Option<OneOrMany>| value.as_ref().map(per_axis);
    let by_form = |value: Option<V3>| value.unwrap_or_default();
    Hydrodynamics {
        drag_area: given(&payload.drag_area_m2)
            .unwrap_or_else(|| by_form(form.map(|form| form.drag_area))),
        added_mass: given(&payload.added_mass_kg)
            .unwrap_or_else(|| by_form(form.map(|form| form.added_volume * density))),
    }
}

/// Writes mass, volume, drag area and added mass of the payload as a point.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>, payload: &Payload) {
    if let Some(node) = source.node(&["payload", "dry_mass_kg"]) {
        let mass = value_of(source, node);
        system.given("mass_kg", &mass, &node.span, "");
    }
    match source.node(&["payload", "wet_mass_kg"]) {
        Some(node) => system.given("wet_mass_kg", &value_of(source, node), &node.span, ""),
        None => write_volume(system, source, payload),
    }
    for (key, value) in [
        ("drag_area_m2", &payload.drag_area_m2),
        ("added_mass_kg", &payload.added_mass_kg),
    ] {
        if let Some(value) = value {
            coefficient(system, source, &["payload", key], value);
        }
    }
    of_shape(system, source, payload);
    let area = payload_bed_area(payload, &source.case.environment);
    bearing::write(system, source, &["payload"], area);
}

/// Drag area and added mass that only the shape gives.
fn of_shape(system: &mut CaseText<'_>, source: &LineSource<'_>, payload: &Payload) {
    if payload.shape.is_none() {
        return;
    }
    let of = hydrodynamics(source, payload);
    let mut all = |key: &str, value: V3| {
        let value = numbers(&[value.x, value.y, value.z]);
        system.assumed(key, &value, "by its shape");
    };
    if payload.drag_area_m2.is_none() {
        all("drag_area_m2", of.drag_area);
    }
    if payload.added_mass_kg.is_none() {
        all("added_mass_kg", of.added_mass);
    }
}
