//! The payload, where it is more than a point of mass and volume that hangs clear.

use super::ends::coefficient;
use super::source::{DENSITY, LineSource};
use crate::case::Payload;
use crate::import::fault::Fault;

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
    if source.case.seabed.is_some() {
        let problem =
            "bears on the bed over an area, and a point of a system does so by its weight alone";
        let remedy = "leave the bed out where the payload hangs clear of it";
        found.push(source.fault(&["payload", "bed_area_m2"], problem, remedy));
    }
    found.extend(by_axes(source, payload));
    found.extend(volume(source, payload));
    found
}

/// A drag area or added mass that differs along the axes.
fn by_axes(source: &LineSource<'_>, payload: &Payload) -> Vec<Fault> {
    let both = [
        ("drag_area_m2", source.flows()),
        ("added_mass_kg", source.is_in_time()),
    ];
    let acting = both.into_iter().filter(|(_, acts)| *acts);
    let is_given = |key: &str| source.node(&["payload", key]).is_some();
    let mut found = Vec::new();
    for (key, _) in acting.clone() {
        if is_given(key) && coefficient(payload, key).is_none() {
            let problem = "a point of a system has the same along all axes";
            found.push(source.fault(&["payload", key], problem, "give one number"));
        }
    }
    let by_shape = payload.shape.is_some() && acting.clone().any(|(key, _)| !is_given(key));
    if by_shape {
        let problem = "gives a drag area and an added mass for each axis, and a point of a system has the same along all";
        let remedy = "give `drag_area_m2` and `added_mass_kg` as one number each";
        found.push(source.fault(&["payload", "shape"], problem, remedy));
    }
    found
}

/// A volume that does not follow, or from expressions.
fn volume(source: &LineSource<'_>, payload: &Payload) -> Vec<Fault> {
    let mut found = Vec::new();
    let Some(wet) = payload.wet_mass_kg else {
        if payload.volume_m3.is_none() {
            let problem = "gives the volume, which a system wants as a number";
            found.push(source.fault(&["payload", "shape"], problem, "give `volume_m3`"));
        }
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
