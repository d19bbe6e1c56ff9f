//! A ropeway from a platform to a ship.

use super::template::{Answers, Template, TemplateInput, length, number, text, title};

/// One rope, a cargo at mid-span, the ship in motion.
pub(super) const ROPEWAY: Template = Template {
    name: "ropeway",
    about: "A rope from a platform to a ship with a cargo on it: sag, tensions, the winch that keeps them.",
    inputs: &[
        title("Ropeway to a ship"),
        length(
            "span_m",
            "span",
            "60",
            "Horizontal distance from platform to ship.",
        ),
        length(
            "height_m",
            "height of the ends",
            "8",
            "Of both ends above still water.",
        ),
        length(
            "sag_m",
            "sag of the bare rope",
            "4",
            "At mid-span, before the cargo is on it.",
        ),
        TemplateInput {
            unit: "mm",
            ..text("rope_mm", "rope diameter", "20", "Of a steel wire rope.")
        },
        TemplateInput {
            unit: "kg",
            ..text("cargo_kg", "cargo", "50", "Mass of the cargo.")
        },
        length(
            "surge_m",
            "surge of the ship",
            "0.5",
            "Amplitude of the motion of the rope's end on the ship.",
        ),
        TemplateInput {
            unit: "s",
            ..text(
                "period_s",
                "period of the surge",
                "20",
                "Period of that motion.",
            )
        },
    ],
    make,
};

fn make(answers: &Answers<'_>) -> Result<String, String> {
    let span = answers.number("span_m", 1.0, 5000.0)?;
    let height = answers.number("height_m", 0.0, 1000.0)?;
    let sag = answers.number("sag_m", 0.001, 1000.0)?;
    let diameter = answers.number("rope_mm", 1.0, 200.0)? / 1e3;
    let cargo = answers.number("cargo_kg", 0.0, 1e6)?;
    let surge = answers.number("surge_m", 0.0, 50.0)?;
    let period = answers.number("period_s", 1.0, 600.0)?;
    // 3600 kg/m^3 and 4.04e10 N/m^2 on the square of the diameter are usual for six-strand rope.
    let mass = number((3600.0 * diameter * diameter * 1e3).round() / 1e3);
    let ea = number((4.04e10 * diameter * diameter).round());
    let rope = number((2.0 * span).ceil());
    let title = answers.title();
    let (span, height, sag, diameter) =
        (number(span), number(height), number(sag), number(diameter));
    let (cargo, surge, period) = (number(cargo), number(surge), number(period));
    Ok(format!(
        "\
[ropeway]
title = {title}
span_m = {span}

[[rope]]
name = \"carrier\"
diameter_m = {diameter}
mass_kg_per_m = {mass}
ea_n = {ea}
length_m = {rope}

[platform]
height_m = {height}

[ship]
height_m = {height}

[cargo]
mass_kg = {cargo}
position = 0.5

[setting]
by = \"bare-sag\"
sag_m = {sag}

[winch]

[motion]
surge_m = {surge}
surge_period_s = {period}

[marks.\"rope.carrier.mass_kg_per_m\"]
status = \"assumed\"
reason = \"3600 kg/m3 times the diameter squared, usual for six-strand rope; give the maker's.\"

[marks.\"rope.carrier.ea_n\"]
status = \"assumed\"
reason = \"4.04e10 N/m2 times the diameter squared, usual for steel wire rope; give the maker's.\"
"
    ))
}
