//! An umbilical with a buoyant stretch between a vessel and a base on the sea bed.

use super::template::{Answers, Template, TemplateInput, filled, length, number, text, title};

/// A wave of three sections, the middle one with floats.
pub(super) const UMBILICAL: Template = Template {
    name: "umbilical",
    about: "A steep-wave umbilical: a buoyant stretch above a base, its upper end on a heaving vessel.",
    inputs: &[
        title("Steep-wave umbilical"),
        length(
            "depth_m",
            "water depth",
            "130",
            "Depth of the base below the surface.",
        ),
        length(
            "offset_m",
            "offset of the base",
            "100",
            "Horizontal distance from the vessel to the base.",
        ),
        TemplateInput {
            unit: "mm",
            ..text("diameter_mm", "outer diameter", "94", "Of the umbilical.")
        },
        TemplateInput {
            unit: "kg/m",
            ..text("mass_kg_per_m", "mass", "19.6", "Mass in air of a metre.")
        },
        TemplateInput {
            unit: "MN",
            ..text("ea_mn", "axial stiffness", "300", "EA.")
        },
        TemplateInput {
            unit: "kN m²",
            ..text(
                "ei_kn_m2",
                "bending stiffness",
                "0",
                "EI; 0 leaves bending out.",
            )
        },
        length(
            "heave_m",
            "heave amplitude",
            "2.0",
            "Amplitude of the heave of the vessel.",
        ),
        TemplateInput {
            unit: "s",
            ..text(
                "period_s",
                "heave period",
                "10",
                "Period of the heave of the vessel.",
            )
        },
    ],
    make,
};

/// The text of the file.
const TEXT: &str = "\
[case]
title = {title}

[parameters]
depth_m = {depth}
offset_m = {offset}
span_m = \"sqrt(depth_m^2 + offset_m^2)\"
buoyant_m = {stretch}
lower_m = \"0.12 * span_m\"
upper_m = \"1.35 * span_m - buoyant_m - lower_m\"
period_s = {period}

[environment]
water_surface = \"crossed\"

[materials.umbilical]
diameter_m = {diameter}
mass_kg_per_m = {mass}
ea_n = {ea}
{bending}axial_damping_ratio = 0.05
drag_normal = 1.2
drag_tangential = 0.02
added_mass_normal = 1.0

# From the vessel down.
[[line]]
name = \"upper\"
material = \"umbilical\"
length_m = \"upper_m\"
segments = 60

[[line]]
name = \"buoyant\"
material = \"umbilical\"
length_m = \"buoyant_m\"
segments = 20

[[line]]
name = \"lower\"
material = \"umbilical\"
length_m = \"lower_m\"
segments = 10

[ends.a]
name = \"vessel\"
kind = \"moving\"
position_m = [0.0, 0.0, 0.0]
amplitude_m = [0.0, 0.0, {heave}]
period_s = \"period_s\"
ramp_s = \"2 * period_s\"

[ends.b]
name = \"base\"
kind = \"anchor\"
position_m = [\"offset_m\", 0.0, \"-depth_m\"]

# All floats of the stretch together.
[[floats]]
section = \"buoyant\"
lift_kg = {lift}
mass_kg = {float_mass}
drag_area_m2 = {float_area}
added_mass_kg = {float_added}

[start]
shape = \"equilibrium\"

[solver]
method = \"alpha\"
duration_s = \"12 * period_s\"

[output]
interval_s = 0.2
shape_interval_s = 2.0

[marks.\"floats.buoyant.lift_kg\"]
status = \"assumed\"
reason = \"Two and a half times the weight in water of the stretch; give that of the modules.\"
";

fn make(answers: &Answers<'_>) -> Result<String, String> {
    let depth = answers.number("depth_m", 10.0, 5000.0)?;
    let offset = answers.number("offset_m", 1.0, 10_000.0)?;
    let diameter = answers.number("diameter_mm", 5.0, 1000.0)? / 1e3;
    let mass = answers.number("mass_kg_per_m", 0.1, 2000.0)?;
    let ea = answers.number("ea_mn", 0.1, 1e5)? * 1e6;
    let ei = answers.number("ei_kn_m2", 0.0, 1e6)? * 1e3;
    let heave = answers.number("heave_m", 0.0, 20.0)?;
    let period = answers.number("period_s", 1.0, 60.0)?;
    // The floats carry twice the weight in water of their stretch, so that it rises.
    let wet = mass - 1025.0 * std::f64::consts::PI / 4.0 * diameter * diameter;
    if wet <= 0.0 {
        return Err("The umbilical must be heavier than the water that it displaces.".to_owned());
    }
    let span = depth.hypot(offset);
    let stretch = (0.25 * span).round();
    let lift = (2.5 * wet * stretch).round();
    let title = answers.title();
    let bending = match ei > 0.0 {
        true => format!("ei_n_m2 = {}\n", number(ei)),
        false => String::new(),
    };
    let (float_mass, float_area) = (number((0.6 * lift).round()), number((lift / 160.0).round()));
    let float_added = number((1.6 * lift).round());
    let (depth, offset, stretch, lift) =
        (number(depth), number(offset), number(stretch), number(lift));
    let (diameter, mass, ea) = (number(diameter), number(mass), number(ea));
    let (heave, period) = (number(heave), number(period));
    Ok(filled(
        TEXT,
        &[
            ("bending", bending),
            ("depth", depth),
            ("diameter", diameter),
            ("ea", ea),
            ("float_added", float_added),
            ("float_area", float_area),
            ("float_mass", float_mass),
            ("heave", heave),
            ("lift", lift),
            ("mass", mass),
            ("offset", offset),
            ("period", period),
            ("stretch", stretch),
            // Last, so that braces in what the user typed are kept.
            ("title", title),
        ],
    ))
}
