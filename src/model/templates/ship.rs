//! A ship at single-point mooring.

use super::template::{Answers, Template, TemplateInput, length, number, text, title};

/// A ship in a wind, at a mooring line from its bow.
pub(super) const SHIP: Template = Template {
    name: "ship",
    about: "A ship at single-point mooring in wind and current: headings, force on its line.",
    inputs: &[
        title("Ship at anchor"),
        length("length_m", "length", "80", "Of the ship at the waterline."),
        length("draft_m", "draught", "4", "Depth of the keel."),
        TemplateInput {
            unit: "m/s",
            ..text("wind_m_per_s", "wind", "15", "Mean speed at 10 m.")
        },
        TemplateInput {
            unit: "m²",
            ..text(
                "frontal_m2",
                "frontal area",
                "150",
                "Above water, seen from ahead.",
            )
        },
        TemplateInput {
            unit: "m²",
            ..text(
                "lateral_m2",
                "lateral area",
                "600",
                "Above water, seen from the side.",
            )
        },
        TemplateInput {
            unit: "m/s",
            ..text(
                "current_m_per_s",
                "current",
                "0.5",
                "At the surface, along the wind.",
            )
        },
    ],
    make,
};

fn make(answers: &Answers<'_>) -> Result<String, String> {
    let length = number(answers.number("length_m", 1.0, 1000.0)?);
    let draught = number(answers.number("draft_m", 0.1, 100.0)?);
    let wind = number(answers.number("wind_m_per_s", 0.0, 100.0)?);
    let frontal = number(answers.number("frontal_m2", 0.0, 1e6)?);
    let lateral = number(answers.number("lateral_m2", 0.0, 1e6)?);
    let current = number(answers.number("current_m_per_s", 0.0, 20.0)?);
    let title = answers.title();
    Ok(format!(
        "\
[ship]
title = {title}
length_m = {length}
draft_m = {draught}

[wind]
speed_m_per_s = {wind}
towards_deg = 0.0
frontal_area_m2 = {frontal}
lateral_area_m2 = {lateral}
surge_cosines = [0.0, 0.6]
sway_sines = [0.8]
yaw_sines = [0.0, -0.06]

[current]
speed_m_per_s = {current}
towards_deg = 0.0
surge_cosines = [0.0, 0.05]
sway_sines = [0.65]
yaw_sines = [0.0, -0.06]

[marks.\"wind.surge_cosines\"]
status = \"assumed\"
reason = \"Usual size for a ship of cargo; give the coefficients of yours, as those below.\"

[marks.\"current.surge_cosines\"]
status = \"assumed\"
reason = \"Usual size for a ship of cargo; give the coefficients of yours, as those below.\"
"
    ))
}
