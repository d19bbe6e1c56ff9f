//! A cross-section of a cable: the least that one holds, to be built up layer by layer.

use super::template::{Answers, Template, TemplateInput, number, text, title};

/// A core with a sheath and two layers of armour.
pub(super) const SECTION: Template = Template {
    name: "cross-section",
    about: "A cable in section: a core, a sheath, two layers of armour; stiffness, mass, limits.",
    inputs: &[
        title("Cable with two layers of armour"),
        TemplateInput {
            unit: "mm",
            ..text(
                "core_mm",
                "core diameter",
                "60",
                "Outer diameter of the core.",
            )
        },
        TemplateInput {
            unit: "kg/m",
            ..text(
                "core_kg_per_m",
                "core mass",
                "6.8",
                "Mass of a metre of the core.",
            )
        },
        TemplateInput {
            unit: "MN",
            ..text("core_ea_mn", "core stiffness", "29", "EA of the core.")
        },
        TemplateInput {
            unit: "mm",
            ..text(
                "wire_mm",
                "armour wire",
                "5",
                "Diameter of a wire of the armour.",
            )
        },
        TemplateInput {
            unit: "deg",
            ..text(
                "lay_deg",
                "lay angle",
                "15",
                "Of both layers, one to the right and one to the left.",
            )
        },
    ],
    make,
};

fn make(answers: &Answers<'_>) -> Result<String, String> {
    let core = number(answers.number("core_mm", 1.0, 1000.0)? / 1e3);
    let mass = number(answers.number("core_kg_per_m", 0.01, 5000.0)?);
    let ea = number(answers.number("core_ea_mn", 0.001, 1e5)? * 1e6);
    let wire = number(answers.number("wire_mm", 0.1, 50.0)? / 1e3);
    let lay = number(answers.number("lay_deg", 0.1, 45.0)?);
    let title = answers.title();
    Ok(format!(
        "\
[section]
name = \"cable\"
title = {title}

[units.core]
kind = \"electric\"
diameter_m = {core}
mass_kg_per_m = {mass}
ea_n = {ea}

[centre]
unit = \"core\"

[[layer]]
name = \"bedding\"
kind = \"sheath\"
thickness_m = 0.004
youngs_modulus_pa = 0.3e9

[[layer]]
name = \"armour-1\"
kind = \"armour\"
wire_diameter_m = {wire}
lay_angle_deg = {lay}
sense = \"right\"
strength_pa = 8.0e8

[[layer]]
name = \"armour-2\"
kind = \"armour\"
wire_diameter_m = {wire}
lay_angle_deg = {lay}
sense = \"left\"
strength_pa = 8.0e8

[[layer]]
name = \"serving\"
kind = \"sheath\"
thickness_m = 0.005
density_kg_per_m3 = 1000.0
"
    ))
}
