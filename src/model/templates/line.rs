//! A line between two points: the least that a line case holds.

use super::template::{Answers, Template, diameter, length, line_type, number, title};

/// A line between two fixed points.
pub(super) const LINE: Template = Template {
    name: "line",
    about: "A line between two points in still water, at rest: the least that a line case holds.",
    inputs: &[
        title("Line between two points"),
        length(
            "span_m",
            "span",
            "100",
            "Horizontal distance between the ends.",
        ),
        length(
            "rise_m",
            "rise",
            "20",
            "Height of the second end above the first.",
        ),
        length(
            "depth_m",
            "depth of the first end",
            "50",
            "Below the surface.",
        ),
        length(
            "length_m",
            "length",
            "120",
            "Unstretched length of the line.",
        ),
        line_type("chain-r4-studless"),
        diameter("76"),
    ],
    make,
};

fn make(answers: &Answers<'_>) -> Result<String, String> {
    let span = answers.number("span_m", 0.0, 1e5)?;
    let rise = answers.number("rise_m", -1e4, 1e4)?;
    let depth = answers.number("depth_m", -1e4, 1e4)?;
    let length = answers.number("length_m", 0.01, 1e5)?;
    let material = answers.material("line")?;
    let (title, span, length) = (answers.title(), number(span), number(length));
    let (low, high) = (number(-depth), number(rise - depth));
    Ok(format!(
        "\
[case]
title = {title}

{material}
[[line]]
name = \"line\"
material = \"line\"
length_m = {length}
segments = 40

[ends.a]
name = \"first\"
kind = \"fixed\"
position_m = [0.0, 0.0, {low}]

[ends.b]
name = \"second\"
kind = \"fixed\"
position_m = [{span}, 0.0, {high}]

[solver]
method = \"static\"
"
    ))
}
