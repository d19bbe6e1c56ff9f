//! A body lowered on a rope from a vessel in waves.

use super::template::{
    Answers, Template, TemplateInput, diameter, filled, length, line_type, number, text, title,
};

const PERIOD: TemplateInput = TemplateInput {
    unit: "s",
    ..text(
        "period_s",
        "heave period",
        "9",
        "Period of the heave of the crane tip.",
    )
};

const MASS: TemplateInput = TemplateInput {
    unit: "t",
    ..text("mass_t", "mass", "60", "Mass of the body in air.")
};

const WEIGHT: TemplateInput = TemplateInput {
    unit: "t",
    ..text(
        "wet_mass_t",
        "weight in water",
        "48",
        "Mass less displaced water.",
    )
};

/// A body on a rope, the upper end heaving.
pub(super) const LOWERING: Template = Template {
    name: "lowering",
    about: "A body hung from a heaving crane tip near the sea bed: tensions, motion and resonance in time.",
    inputs: &[
        title("Lowering of a manifold"),
        length(
            "depth_m",
            "water depth",
            "500",
            "Depth of the level sea bed.",
        ),
        length(
            "rope_m",
            "rope paid out",
            "450",
            "Unstretched length from the crane tip to the body.",
        ),
        line_type("wire-six-strand"),
        diameter("77"),
        MASS,
        WEIGHT,
        TemplateInput {
            unit: "m²",
            ..text(
                "drag_area_m2",
                "drag area",
                "60",
                "Drag coefficient times area, along the vertical.",
            )
        },
        length(
            "heave_m",
            "heave amplitude",
            "1.0",
            "Amplitude of the heave of the crane tip.",
        ),
        PERIOD,
    ],
    make,
};

/// The text of the file.
const TEXT: &str = "\
[case]
title = {title}

[parameters]
depth_m = {depth}
rope_m = {rope}
period_s = {period}

[seabed]
depth_m = \"depth_m\"

{material}
[[line]]
name = \"wire\"
material = \"wire\"
length_m = \"rope_m\"
segments = 40

[ends.a]
name = \"crane\"
kind = \"moving\"
position_m = [0.0, 0.0, 0.0]
amplitude_m = [0.0, 0.0, {heave}]
period_s = \"period_s\"
ramp_s = \"2 * period_s\"

[ends.b]
name = \"body\"
kind = \"payload\"

[payload]
dry_mass_kg = {dry}
wet_mass_kg = {wet}
drag_area_m2 = {drag}
added_mass_kg = {added}

[start]
shape = \"equilibrium\"

[solver]
method = \"alpha\"
duration_s = \"15 * period_s\"

[marks.\"payload.added_mass_kg\"]
status = \"assumed\"
reason = \"The mass of the displaced water; give that of the body.\"
";

fn make(answers: &Answers<'_>) -> Result<String, String> {
    let depth = answers.number("depth_m", 5.0, 10_000.0)?;
    let rope = answers.number("rope_m", 1.0, 10_000.0)?;
    if rope >= depth {
        return Err(
            "The rope must be shorter than the water is deep, or the body lies on the bed."
                .to_owned(),
        );
    }
    let dry = answers.number("mass_t", 0.001, 1e5)?;
    let wet = answers.number("wet_mass_t", 0.001, 1e5)?;
    if wet > dry {
        return Err("The weight in water cannot exceed the mass in air.".to_owned());
    }
    let drag = answers.number("drag_area_m2", 0.0, 1e5)?;
    let heave = answers.number("heave_m", 0.0, 20.0)?;
    let period = answers.number("period_s", 1.0, 60.0)?;
    let material = answers.material("wire")?;
    let volume = (dry - wet) / 1.025;
    let (depth, rope, title) = (number(depth), number(rope), answers.title());
    let (dry, wet, drag) = (number(dry * 1e3), number(wet * 1e3), number(drag));
    let (heave, period) = (number(heave), number(period));
    let added = number((volume * 1025.0).round());
    Ok(filled(
        TEXT,
        &[
            ("added", added),
            ("depth", depth),
            ("drag", drag),
            ("dry", dry),
            ("heave", heave),
            ("material", material),
            ("period", period),
            ("rope", rope),
            ("wet", wet),
            // Last, so that braces in what the user typed are kept.
            ("title", title),
        ],
    ))
}
