//! Checks of the units of a section: possible sizes, known names.

use super::format::{at_most, mm};
use super::model::{Layer, Section, Tube, Unit};
use crate::case::InvalidValue;
use crate::case::fields::either;
use crate::case::nearest;

/// The unit of this name.
pub(super) fn unit_named<'a>(section: &'a Section, name: &str) -> Option<&'a Unit> {
    section.units.get(name)
}

/// Violations: impossible units, unknown names.
pub(super) fn known_units(section: &Section) -> Vec<InvalidValue> {
    let mut wrong: Vec<InvalidValue> = Vec::new();
    for (name, unit) in &section.units {
        if let Unit::Tube(tube) = unit {
            wrong.extend(possible(name, tube));
        }
    }
    if let Some(centre) = &section.centre {
        wrong.extend(unknown(section, &centre.unit, &["centre", "unit"]));
    }
    for layer in &section.layers {
        let Layer::Units(layer) = layer else { continue };
        let mut reported: Vec<&str> = Vec::new();
        for name in &layer.units {
            if !reported.contains(&name.as_str()) {
                reported.push(name);
                wrong.extend(unknown(section, name, &["layer", &layer.name, "units"]));
            }
        }
    }
    wrong
}

fn unknown(section: &Section, name: &str, path: &[&str]) -> Option<InvalidValue> {
    if section.units.contains_key(name) {
        return None;
    }
    let known: Vec<&str> = section.units.keys().map(String::as_str).collect();
    let problem = format!("there is no unit named \"{}\"", name.escape_default());
    let remedy = match nearest(name, known.iter().copied()) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None if known.is_empty() => "describe it as [units.<name>]".to_owned(),
        None => format!(
            "the section has {}",
            either(&known).replace(" or ", " and ")
        ),
    };
    Some(InvalidValue::new(path, problem, remedy))
}

/// A tube without a bore, or larger than its jacket.
fn possible(name: &str, tube: &Tube) -> Option<InvalidValue> {
    let outer = tube.tube_diameter_m.unwrap_or(tube.diameter_m);
    if outer > tube.diameter_m {
        let problem = format!(
            "the tube's {} is thicker than the whole unit, {}",
            mm(outer),
            mm(tube.diameter_m)
        );
        let remedy = format!("give {} or less", at_most(tube.diameter_m));
        return Some(InvalidValue::new(
            &["units", name, "tube_diameter_m"],
            problem,
            remedy,
        ));
    }
    if 2.0 * tube.wall_m >= outer {
        let problem = format!(
            "a wall of {} leaves no bore in a tube of {}",
            mm(tube.wall_m),
            mm(outer)
        );
        let remedy = format!(
            "give less than {}, or make it a unit of kind \"rod\"",
            at_most(0.5 * outer)
        );
        return Some(InvalidValue::new(
            &["units", name, "wall_m"],
            problem,
            remedy,
        ));
    }
    None
}

/// Units that are described but lie nowhere.
pub(super) fn unused(section: &Section) -> Vec<InvalidValue> {
    let used = |name: &str| {
        let in_centre = section.centre.as_ref().is_some_and(|c| c.unit == name);
        let in_layer = section.layers.iter().any(|layer| match layer {
            Layer::Units(layer) => layer.units.iter().any(|unit| unit == name),
            _ => false,
        });
        in_centre || in_layer
    };
    let idle = section.units.keys().filter(|name| !used(name));
    idle.map(|name| {
        let remedy = "name it in [centre] or in the `units` of a layer, or remove it";
        InvalidValue::new(&["units", name], "the unit is not used", remedy)
    })
    .collect()
}
