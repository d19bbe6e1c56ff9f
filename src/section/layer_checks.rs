//! Checks of the layers of a section before they are laid out: names, number of armour layers, lay angles.

use super::model::{Layer, Section};
use crate::case::InvalidValue;

/// Armour layers a section may have: as many as the program of Lin et al. 2016 (section 2.1) takes.
pub const MOST_ARMOUR: usize = 4;

/// Lay angles for which a unit is a helix that carries tension \[deg\].
pub const LAY_ANGLES: (f64, f64) = (0.5, 60.0);

/// Violations of all layers.
pub(super) fn layer_checks(section: &Section) -> Vec<InvalidValue> {
    let mut violations = names(section);
    violations.extend(armour_layers(section));
    violations.extend(lay_angles(section));
    violations
}

/// The layers in key paths: by name, by number where an earlier layer has the same name.
pub(super) fn layer_keys(section: &Section) -> Vec<String> {
    let mut keys: Vec<String> = Vec::new();
    for (index, layer) in section.layers.iter().enumerate() {
        let taken = keys.iter().any(|key| key == layer.name());
        keys.push(if taken {
            (index + 1).to_string()
        } else {
            layer.name().to_owned()
        });
    }
    keys
}

fn names(section: &Section) -> Vec<InvalidValue> {
    let twice = layer_keys(section)
        .into_iter()
        .zip(&section.layers)
        .filter(|(key, layer)| key != layer.name());
    twice
        .map(|(key, layer)| {
            let problem = format!("the name \"{}\" is used twice", layer.name());
            let remedy = "give every layer a name of its own";
            InvalidValue::new(&["layer", &key, "name"], problem, remedy)
        })
        .collect()
}

fn armour_layers(section: &Section) -> Option<InvalidValue> {
    let armour = |(layer, _): &(&Layer, String)| matches!(layer, Layer::Armour(_));
    let layers = section.layers.iter().zip(layer_keys(section));
    let (_, key) = layers.filter(armour).nth(MOST_ARMOUR)?;
    Some(InvalidValue::new(
        &["layer", &key, "kind"],
        format!("is one armour layer too many: a section has at most {MOST_ARMOUR}"),
        "leave it out, or take thicker wires in fewer layers",
    ))
}

/// Lay angles outside of [`LAY_ANGLES`].
fn lay_angles(section: &Section) -> Vec<InvalidValue> {
    let (least, greatest) = LAY_ANGLES;
    let mut violations = Vec::new();
    for (layer, key) in section.layers.iter().zip(layer_keys(section)) {
        let given = match layer {
            Layer::Units(layer) => layer.lay_angle_deg,
            Layer::Armour(layer) => layer.lay_angle_deg,
            Layer::Sheath(_) => continue,
        };
        if (least..=greatest).contains(&given) {
            continue;
        }
        let (problem, last) = if given < least {
            (
                "is too small: straight units cannot bend without being stretched",
                "; a straight unit belongs in the centre, as [centre]",
            )
        } else {
            (
                "is too large: a hoop carries no tension, and the theory of helical armour does not hold for it",
                "",
            )
        };
        violations.push(InvalidValue::new(
            &["layer", &key, "lay_angle_deg"],
            format!("{given} deg {problem}"),
            format!("give {least} to {greatest} deg, usually 5 to 30{last}"),
        ));
    }
    violations
}
