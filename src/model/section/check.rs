//! Checks of the keys of a section against each other: sizes of tubes and jackets, names, number of armour layers, lay angles.

use super::format::{at_least, at_most, mm};
use super::lay_out::{LayoutError, LayoutKey, TOUCH};
use super::model::{CentreKeys, LayerKeys, SectionKeys, TubeKeys, UnitKeys};
use super::quantities::QUANTITIES;
use crate::case::schema::{Key, TableNode};
use crate::case::{Finding, TomlNode, unknown, unknown_name, used_twice};
use crate::published::number as published_number;

/// Armour layers a section may have: as many as the program of Lin et al. 2016 (section 2.1) takes.
pub const MOST_ARMOUR: usize = 4;

/// Lay angles for which a unit is a helix that carries tension \[deg\].
pub const LAY_ANGLES: (f64, f64) = (0.5, 60.0);

/// Checks of a section.
pub(super) fn check(section: &SectionKeys<'_>) -> Vec<Finding> {
    let layers = || section.layers.iter().map(|(_, layer)| layer);
    let mut found: Vec<Finding> = section.units.iter().filter_map(bore).collect();
    if let Some(centre) = &section.centre {
        found.extend(jacket(section, centre));
    }
    found.extend(unknown_units(section));
    found.extend(used_twice(
        layers().filter_map(name),
        "give every layer a name of its own",
    ));
    let armour = layers().filter(|layer| matches!(layer, LayerKeys::Armour(_)));
    found.extend(armour.skip(MOST_ARMOUR).take(1).map(|layer| {
        place(layer).finding_at(
            "kind",
            format!("is one armour layer too many: a section has at most {MOST_ARMOUR}"),
            "leave it out, or take thicker wires in fewer layers",
        )
    }));
    found.extend(layers().filter_map(lay_angle));
    found.extend(published_number::check(
        &section.published,
        unknown_quantity,
        &[],
        &[],
    ));
    let file = section.place.node;
    if let (Some(about), None, None) = (&section.about, file.get("centre"), file.get("layer")) {
        let remedy = "add [centre], or a [[layer]] of units";
        found.push(about.place.finding("holds nothing", remedy));
    }
    found
}

fn unknown_quantity(key: &Key<'_, String>) -> Option<Finding> {
    let known: Vec<&str> = QUANTITIES.iter().map(|quantity| quantity.name).collect();
    unknown(key, &known, "quantity", "section")
}

/// An error of the layout at its key.
pub(super) fn located(error: &LayoutError, section: &SectionKeys<'_>) -> Finding {
    let LayoutError {
        key,
        problem,
        remedy,
    } = error;
    let layer = |index: usize| section.layers.get(index).map(|(_, layer)| layer);
    let whole = section.about.as_ref().map_or(&section.place, |a| &a.place);
    match *key {
        LayoutKey::Section => whole.finding(problem, remedy),
        LayoutKey::Layer(index) => layer(index).map_or(whole, place).finding(problem, remedy),
        LayoutKey::Units(index) => match layer(index) {
            Some(LayerKeys::Units(layer)) => layer.units.finding(problem, remedy),
            _ => whole.finding(problem, remedy),
        },
        LayoutKey::PitchRadius(index) => match layer(index) {
            Some(LayerKeys::Units(layer)) => layer.pitch_radius_m.finding(problem, remedy),
            _ => whole.finding(problem, remedy),
        },
        LayoutKey::Count(index) => match layer(index) {
            Some(LayerKeys::Armour(layer)) => layer.count.finding(problem, remedy),
            _ => whole.finding(problem, remedy),
        },
    }
}

fn place<'k, 'a>(layer: &'k LayerKeys<'a>) -> &'k TableNode<'a> {
    match layer {
        LayerKeys::Unknown(place) => place,
        LayerKeys::Units(layer) => &layer.place,
        LayerKeys::Armour(layer) => &layer.place,
        LayerKeys::Sheath(layer) => &layer.place,
    }
}

fn name<'k, 'a>(layer: &'k LayerKeys<'a>) -> Option<&'k Key<'a, String>> {
    match layer {
        LayerKeys::Unknown(_) => None,
        LayerKeys::Units(layer) => Some(&layer.name),
        LayerKeys::Armour(layer) => Some(&layer.name),
        LayerKeys::Sheath(layer) => Some(&layer.name),
    }
}

/// A tube without a bore, or larger than its jacket.
fn bore((_, unit): &(String, UnitKeys<'_>)) -> Option<Finding> {
    let UnitKeys::Tube(tube) = unit else {
        return None;
    };
    let TubeKeys {
        tube_diameter_m,
        wall_m,
        ..
    } = tube.as_ref();
    let (whole, wall) = (tube.diameter_m.value()?, wall_m.value()?);
    let outer = match tube_diameter_m.is_given() {
        true => tube_diameter_m.value()?,
        false => whole,
    };
    if outer > whole {
        let problem = format!(
            "the tube's {} is thicker than the whole unit, {}",
            mm(outer),
            mm(whole)
        );
        let remedy = format!("give {} or less", at_most(whole));
        return Some(tube_diameter_m.finding(problem, remedy));
    }
    (2.0 * wall >= outer).then(|| {
        let problem = format!(
            "a wall of {} leaves no bore in a tube of {}",
            mm(wall),
            mm(outer)
        );
        let remedy = format!(
            "give less than {}, or make it a unit of kind \"rod\"",
            at_most(0.5 * outer)
        );
        wall_m.finding(problem, remedy)
    })
}

/// A jacket of the centre that is thinner than the unit inside it.
fn jacket(section: &SectionKeys<'_>, centre: &CentreKeys<'_>) -> Option<Finding> {
    let (name, jacket) = (centre.unit.get()?, centre.jacket_diameter_m.value()?);
    let (_, unit) = section.units.iter().find(|(unit, _)| unit == name)?;
    let inside = match unit {
        UnitKeys::Unknown(_) => return None,
        UnitKeys::Electric(whole) | UnitKeys::Fibre(whole) => &whole.diameter_m,
        UnitKeys::Tube(tube) => &tube.diameter_m,
        UnitKeys::Rod(rod) => &rod.diameter_m,
        UnitKeys::Filler(filler) => &filler.diameter_m,
    };
    let inside = inside.value()?;
    (jacket < inside - 2.0 * TOUCH).then(|| {
        let problem = format!(
            "the jacket's {} is thinner than the unit inside it, {}",
            mm(jacket),
            mm(inside)
        );
        let remedy = format!("give {} or more, or leave it out", at_least(inside));
        centre.jacket_diameter_m.finding(problem, remedy)
    })
}

/// Names of units that the section does not have, each once a key.
fn unknown_units(section: &SectionKeys<'_>) -> Vec<Finding> {
    let units = section.place.node.get("units");
    let known = units.map_or_else(Vec::new, TomlNode::names);
    let centre = section.centre.as_ref();
    let in_centre = centre.and_then(|centre| unknown(&centre.unit, &known, "unit", "section"));
    let mut found = Vec::from_iter(in_centre);
    for (_, layer) in &section.layers {
        let LayerKeys::Units(layer) = layer else {
            continue;
        };
        let names = layer.units.get().map_or(&[] as &[_], Vec::as_slice);
        for (index, name) in names.iter().enumerate() {
            let first = !names.iter().take(index).any(|earlier| earlier == name);
            let error = unknown_name(name, &known, "unit", "section").filter(|_| first);
            found.extend(
                error.map(|(problem, remedy)| layer.units.finding_at_item(index, problem, remedy)),
            );
        }
    }
    found
}

/// A lay angle outside of [`LAY_ANGLES`].
fn lay_angle(layer: &LayerKeys<'_>) -> Option<Finding> {
    let key = match layer {
        LayerKeys::Units(layer) => &layer.lay_angle_deg,
        LayerKeys::Armour(layer) => &layer.lay_angle_deg,
        LayerKeys::Sheath(_) | LayerKeys::Unknown(_) => return None,
    };
    let (least, greatest) = LAY_ANGLES;
    let given = key.value()?;
    let (problem, last) = if given < least {
        (
            "is too small: straight units cannot bend without being stretched",
            "; a straight unit belongs in the centre, as [centre]",
        )
    } else if given > greatest {
        (
            "is too large: a hoop carries no tension, and the theory of helical armour does not hold for it",
            "",
        )
    } else {
        return None;
    };
    Some(key.finding(
        format!("{given} deg {problem}"),
        format!("give {least} to {greatest} deg, usually 5 to 30{last}"),
    ))
}
