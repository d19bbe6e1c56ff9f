//! Mooring lines: one from an anchor to a fairlead, and a spread of them around a platform.

use super::template::{
    Answers, Template, TemplateInput, diameter, length, line_type, number, text, title,
};

const DEPTH: TemplateInput = length(
    "depth_m",
    "water depth",
    "200",
    "Depth of the level sea bed.",
);
const RADIUS: TemplateInput = length(
    "radius_m",
    "anchor radius",
    "800",
    "Horizontal distance from the anchor to the middle of the platform.",
);
const FAIRLEAD_DEPTH: TemplateInput = length(
    "fairlead_depth_m",
    "fairlead depth",
    "14",
    "Depth of the fairlead below the surface.",
);
const SLACK: TemplateInput = text(
    "slack",
    "length over span",
    "1.03",
    "Unstretched length over the straight distance from anchor to fairlead.",
);

/// One line from an anchor to a fairlead.
pub(super) const LINE: Template = Template {
    name: "mooring line",
    about: "A mooring line from an anchor on the sea bed to a fairlead, at rest.",
    inputs: &[
        title("Mooring line"),
        DEPTH,
        RADIUS,
        FAIRLEAD_DEPTH,
        line_type("chain-r4-studless"),
        diameter("120"),
        SLACK,
    ],
    make: line,
};

/// A spread of equal lines around a platform.
pub(super) const SPREAD: Template = Template {
    name: "spread mooring",
    about: "Equal mooring lines around a platform: pretensions, stiffness, offset curve, watch circle.",
    inputs: &[
        title("Spread mooring"),
        text(
            "lines",
            "number of lines",
            "3",
            "Lines at equal angles around the platform.",
        ),
        DEPTH,
        RADIUS,
        FAIRLEAD_DEPTH,
        length(
            "fairlead_radius_m",
            "fairlead radius",
            "58",
            "From the middle of the platform to the fairleads.",
        ),
        line_type("chain-r4-studless"),
        diameter("120"),
        SLACK,
        length(
            "offset_m",
            "greatest offset",
            "20",
            "To which the platform is pushed for the offset curve.",
        ),
    ],
    make: spread,
};

/// The parameters of depth, radius and slack, after a check that the fairlead lies above the bed.
fn parameters(answers: &Answers<'_>, fairlead_radius: Option<f64>) -> Result<String, String> {
    let depth = answers.number("depth_m", 5.0, 10_000.0)?;
    let radius = answers.number("radius_m", 1.0, 100_000.0)?;
    let fairlead = answers.number("fairlead_depth_m", -100.0, 10_000.0)?;
    let slack = answers.number("slack", 1.0001, 3.0)?;
    if fairlead >= depth {
        return Err("The fairlead must lie above the sea bed.".to_owned());
    }
    if fairlead_radius.is_some_and(|inner| inner >= radius) {
        return Err("The anchor radius must be greater than the fairlead radius.".to_owned());
    }
    let inner = fairlead_radius.map_or_else(String::new, |inner| {
        format!("fairlead_radius_m = {}\n", number(inner))
    });
    Ok(format!(
        "[parameters]\ndepth_m = {}\nradius_m = {}\n{inner}fairlead_depth_m = {}\nslack = {}\n",
        number(depth),
        number(radius),
        number(fairlead),
        number(slack)
    ))
}

fn line(answers: &Answers<'_>) -> Result<String, String> {
    let parameters = parameters(answers, None)?;
    let material = answers.material("chain")?;
    let title = answers.title();
    Ok(format!(
        "\
[system]
title = {title}

{parameters}
[seabed]
depth_m = \"depth_m\"

{material}
[points.anchor]
kind = \"fixed\"
position_m = [\"-radius_m\", 0.0, \"-depth_m\"]

[points.fairlead]
kind = \"fixed\"
position_m = [0.0, 0.0, \"-fairlead_depth_m\"]

[[lines]]
name = \"line\"
from = \"anchor\"
to = \"fairlead\"
material = \"chain\"
length_m = \"slack * sqrt(radius_m^2 + (depth_m - fairlead_depth_m)^2)\"
"
    ))
}

fn spread(answers: &Answers<'_>) -> Result<String, String> {
    let lines = answers.count("lines", 1, 36)?;
    let inner = answers.number("fairlead_radius_m", 0.0, 1000.0)?;
    let parameters = parameters(answers, Some(inner))?;
    let offset = answers.number("offset_m", 0.01, 10_000.0)?;
    let material = answers.material("chain")?;
    let title = answers.title();
    let angles = (0..lines).map(|line| number(f64::from(line) * 360.0 / f64::from(lines)));
    let angles = angles.collect::<Vec<_>>().join(", ");
    let offset = number(offset);
    Ok(format!(
        "\
[system]
title = {title}

{parameters}
[seabed]
depth_m = \"depth_m\"

{material}
# The platform is held where it is; its lines give it its stiffness.
[bodies.platform]
kind = \"held\"
position_m = [0.0, 0.0, 0.0]

[points.anchor]
kind = \"fixed\"
position_m = [\"-radius_m\", 0.0, \"-depth_m\"]

[points.fairlead]
kind = \"body\"
body = \"platform\"
position_m = [\"-fairlead_radius_m\", 0.0, \"-fairlead_depth_m\"]

[[lines]]
name = \"line\"
from = \"anchor\"
to = \"fairlead\"
material = \"chain\"
length_m = \"slack * sqrt((radius_m - fairlead_radius_m)^2 + (depth_m - fairlead_depth_m)^2)\"
repeat_at_deg = [{angles}]

[[offset_curves]]
body = \"platform\"
to_m = {offset}
"
    ))
}
