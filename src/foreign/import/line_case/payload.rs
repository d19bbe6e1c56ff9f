//! The payload as a free point, and what of it a system cannot state.

use super::bearing;
use super::bears::{bears_by_shape, bears_by_volume};
use super::copied::{coefficient, value_of};
use super::end_clumps::of_weight;
use super::source::{DENSITY, LineSource};
use super::turning_payload;
use crate::case::Payload;
use crate::import::fault::Fault;
use crate::import::to_case::case_text::{CaseText, number};
use crate::scene::{Hydrodynamics, payload_bed_area, shape_form};

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
    // A point has the shape itself; what bears on the bed by it is a number.
    let by_number = payload.rotation.is_some() || bears_by_shape(source, payload);
    let entries = entries.iter().filter(|entry| entry.key != "kind");
    for entry in entries.filter(|_| by_number) {
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

/// Writes the displaced volume of a payload that turns.
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

/// Drag area and added mass of the payload, as they are given, or follow from the shape.
pub(super) fn hydrodynamics(source: &LineSource<'_>, payload: &Payload) -> Hydrodynamics {
    let density = source.case.environment.water_density_kg_per_m3;
    let given = [&payload.drag_area_m2, &payload.added_mass_kg];
    Hydrodynamics::new(payload.shape.as_ref(), given, density)
}

/// Writes mass, volume, drag area and added mass of the payload as a point.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>, payload: &Payload) {
    if let Some(node) = source.node(&["payload", "dry_mass_kg"]) {
        let mass = value_of(source, node);
        system.given("mass_kg", &mass, &node.span, "");
    }
    for key in ["wet_mass_kg", "volume_m3"] {
        if let Some(node) = source.node(&["payload", key]) {
            system.given(key, &value_of(source, node), &node.span, "");
        }
    }
    for (key, value) in [
        ("drag_area_m2", &payload.drag_area_m2),
        ("added_mass_kg", &payload.added_mass_kg),
    ] {
        match value {
            // Beside a shape nothing is something else than what the shape gives.
            Some(value) if value.is_zero() && payload.shape.is_some() => {
                if let Some(node) = source.node(&["payload", key]) {
                    system.given(key, "0.0", &node.span, "");
                }
            }
            Some(value) => coefficient(system, source, &["payload", key], value),
            None => {}
        }
    }
    shape(system, source);
    let area = payload_bed_area(payload, &source.case.environment);
    bearing::write(system, source, &["payload"], area);
}

/// Writes the shape of the payload, by keys of its point.
fn shape(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let shape = source.node(&["payload", "shape"]);
    for entry in shape.map_or(&[][..], |shape| shape.entries()) {
        let key = format!("shape.{}", entry.key);
        let value = value_of(source, &entry.node);
        system.given(&key, &value, &entry.node.span, "");
    }
}
