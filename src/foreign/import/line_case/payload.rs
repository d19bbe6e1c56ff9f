//! The payload as a free point, and what of it a point cannot state.

use super::bearing::{self, bears_by_volume};
use super::copied::{coefficient, value_of};
use super::source::{DENSITY, LineSource};
use crate::case::Payload;
use crate::import::fault::Fault;
use crate::import::to_case::case_text::{CaseText, number, numbers};
use crate::numerics::V3;
use crate::scene::{payload_bed_area, shape_form};

/// What of the payload acts and a free point cannot state.
pub(super) fn faults(source: &LineSource<'_>) -> Vec<Fault> {
    let Some(payload) = &source.case.payload else {
        return Vec::new();
    };
    let mut found = Vec::new();
    if payload.rotation.is_some() {
        let problem = "a payload that turns about the end of the line is no point";
        let remedy = "write it as a free body of a system";
        found.push(source.fault(&["payload", "rotation"], problem, remedy));
    }
    found.extend(bearing::faults(source, &["payload"], payload.breakout_n));
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

/// A volume that does not follow, or from expressions.
fn volume(source: &LineSource<'_>, payload: &Payload) -> Vec<Fault> {
    let mut found = Vec::new();
    let Some(wet) = payload.wet_mass_kg else {
        return found;
    };
    for key in ["wet_mass_kg", "dry_mass_kg"] {
        found.extend(source.fault_of_expression(&["payload", key]));
    }
    found.extend(source.fault_of_expression(&DENSITY));
    let in_air = source.case.environment.water_density_kg_per_m3 == 0.0;
    if in_air && wet != payload.dry_mass_kg {
        let problem = "differs from the dry mass where there is no water";
        let remedy = "give the density of the water, or the dry mass";
        found.push(source.fault(&["payload", "wet_mass_kg"], problem, remedy));
    }
    found
}

/// Writes mass, volume, drag area and added mass of the payload.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>, payload: &Payload) {
    let mut one = |key: &str, from: &str| {
        if let Some(node) = source.node(&["payload", from]) {
            system.given(key, &value_of(source, node), &node.span, from);
        }
    };
    one("mass_kg", "dry_mass_kg");
    if payload.wet_mass_kg.is_none() {
        one("volume_m3", "volume_m3");
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
    for (key, value) in [
        ("drag_area_m2", &payload.drag_area_m2),
        ("added_mass_kg", &payload.added_mass_kg),
    ] {
        if let Some(value) = value {
            coefficient(system, source, &["payload", key], value);
        }
    }
    of_shape(system, payload, density);
    let area = payload_bed_area(payload, &source.case.environment);
    bearing::write(system, source, &["payload"], area);
}

/// What only the shape gives.
fn of_shape(system: &mut CaseText<'_>, payload: &Payload, density: f64) {
    let Some(form) = payload.shape.as_ref().map(shape_form) else {
        return;
    };
    let mut one = |key: &str, value: &str| system.assumed(key, value, "by its shape");
    let all = |value: V3| numbers(&[value.x, value.y, value.z]);
    if payload.wet_mass_kg.is_none() && payload.volume_m3.is_none() {
        one("volume_m3", &number(form.volume));
    }
    if payload.drag_area_m2.is_none() {
        one("drag_area_m2", &all(form.drag_area));
    }
    if payload.added_mass_kg.is_none() {
        one("added_mass_kg", &all(form.added_volume * density));
    }
}
