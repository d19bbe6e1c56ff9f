//! The numbers of a ropeway by name, for published values and reports.

use super::bare::Bare;
use super::paper;
use super::work::{Readings, Worked};

/// A number by its name.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Name, ending in its unit: `model.max_tension_n`.
    pub name: &'static str,
    /// Value.
    pub value: f64,
    /// Unit.
    pub unit: &'static str,
}

/// Names with what they mean; the names that a published value may have.
pub const NAMES: [(&str, &str, &str); 24] = [
    (
        "model.horizontal_n",
        "N",
        "horizontal pull of the bare rope",
    ),
    (
        "model.max_tension_n",
        "N",
        "greatest end tension of the paper's model: bare rope, whole cargo at one end",
    ),
    (
        "model.length_m",
        "m",
        "length of the bare rope that cannot stretch",
    ),
    ("model.weight_n", "N", "weight of that rope"),
    ("model.sag_m", "m", "sag of that rope at mid-span"),
    (
        "model.least_tension_n",
        "N",
        "least that the greatest end tension can be",
    ),
    ("model.sag_at_least_m", "m", "sag of the bare rope then"),
    (
        "finite_element.horizontal_n",
        "N",
        "the model's pull with the rope weight of the finite-element check",
    ),
    (
        "finite_element.vertical_n",
        "N",
        "the model's vertical end force with that weight, without cargo",
    ),
    (
        "finite_element.weight_n",
        "N",
        "weight of the rope with that weight per length",
    ),
    (
        "finite_element.max_tension_n",
        "N",
        "the model's greatest end tension with that weight",
    ),
    (
        "finite_element.by_weight_n",
        "N",
        "what that weight alone adds to the greatest end tension",
    ),
    (
        "finite_element.more_weight_n",
        "N",
        "what it adds to the weight of the rope",
    ),
    (
        "finite_element.left_n",
        "N",
        "end tension of the check less the model's with the same rope weight",
    ),
    (
        "parabola.sag_m",
        "m",
        "sag at the cargo by eq. (11) with the model's pull",
    ),
    (
        "parabola.ship_n",
        "N",
        "tension at the ship by parabola theory with that pull",
    ),
    (
        "exact.horizontal_n",
        "N",
        "horizontal pull, elastic rope with the cargo on it",
    ),
    ("exact.platform_n", "N", "tension at the platform"),
    ("exact.ship_n", "N", "tension at the ship"),
    ("exact.sag_m", "m", "sag at the cargo"),
    (
        "exact.clearance_m",
        "m",
        "height of the cargo above the wave crests",
    ),
    ("exact.length_m", "m", "unstretched length between the ends"),
    (
        "line.ship_n",
        "N",
        "tension at the ship of the discretised line",
    ),
    (
        "line.sag_m",
        "m",
        "sag at the cargo of the discretised line",
    ),
];

/// The value of a quantity with the cargo where the file has it.
///
/// # Errors
/// Why there is none, as a sentence.
pub fn quantity(worked: &Worked, readings: &Readings, name: &str) -> Result<f64, String> {
    let group = name.split('.').next().unwrap_or(name);
    match group {
        "model" => of_model(worked, name),
        "finite_element" => of_check(worked, name),
        _ => of_readings(worked, readings, name),
    }
}

/// Unit of a quantity.
#[must_use]
pub fn unit(name: &str) -> &'static str {
    let known = NAMES.iter().find(|known| known.0 == name);
    known.map_or("", |known| known.1)
}

fn unknown(name: &str) -> String {
    format!("There is no quantity `{name}`.")
}

fn of_model(worked: &Worked, name: &str) -> Result<f64, String> {
    let told = |trouble: &super::Trouble| format!("The paper's model has no answer: {trouble}.");
    if let "model.least_tension_n" | "model.sag_at_least_m" = name {
        let least = worked.least.as_ref().map_err(told)?;
        return Ok(if name == "model.sag_at_least_m" {
            least.sag_m
        } else {
            least.tension_n
        });
    }
    let tabled = worked.tabled.as_ref().map_err(told)?;
    Ok(match name {
        "model.horizontal_n" => tabled.rope.horizontal_n,
        "model.max_tension_n" => tabled.max_tension_n,
        "model.length_m" => tabled.rope.length_m(),
        "model.weight_n" => tabled.rope.weight_n(),
        "model.sag_m" => tabled.rope.sag_m(),
        _ => return Err(unknown(name)),
    })
}

/// The finite-element check taken apart: what its heavier rope makes, and what is left.
fn of_check(worked: &Worked, name: &str) -> Result<f64, String> {
    let none = || "The ropeway has no finite-element check.".to_owned();
    let check = worked.ropeway.finite_element.as_ref().ok_or_else(none)?;
    let told = |trouble: &super::Trouble| format!("The paper's model has no answer: {trouble}.");
    let tabled = worked.tabled.as_ref().map_err(told)?;
    let area = std::f64::consts::PI * check.radius_m * check.radius_m;
    let weight = area * check.density_kg_per_m3 * worked.ropeway.about.gravity_m_per_s2;
    // The same shape: pull and weight go together.
    let pull = tabled.rope.horizontal_n * weight / tabled.rope.weight_n_per_m;
    let rope = Bare::with_pull(worked.span.gap, weight, pull).map_err(|t| told(&t))?;
    let heavier = paper::tabled(rope, worked.span.cargo_n);
    Ok(match name {
        "finite_element.horizontal_n" => rope.horizontal_n,
        "finite_element.vertical_n" => rope.vertical_n().0.max(rope.vertical_n().1),
        "finite_element.weight_n" => rope.weight_n(),
        "finite_element.max_tension_n" => heavier.max_tension_n,
        "finite_element.by_weight_n" => heavier.max_tension_n - tabled.max_tension_n,
        "finite_element.more_weight_n" => rope.weight_n() - tabled.rope.weight_n(),
        "finite_element.left_n" => check.tension_n - heavier.max_tension_n,
        _ => return Err(unknown(name)),
    })
}

fn of_readings(worked: &Worked, readings: &Readings, name: &str) -> Result<f64, String> {
    let exact = &readings.exact;
    let parabola = || {
        readings
            .parabola
            .ok_or_else(|| "Parabola theory has no pull to go by.".to_owned())
    };
    let line = || {
        let line = readings.line.as_ref();
        line.map_err(|trouble| format!("The discretised line has no answer: {trouble}."))
    };
    Ok(match name {
        "parabola.sag_m" => parabola()?.2,
        "parabola.ship_n" => parabola()?.1,
        "exact.horizontal_n" => exact.solution.h_b_n,
        "exact.platform_n" => exact.platform_n(),
        "exact.ship_n" => exact.ship_n(),
        "exact.sag_m" => exact.sag_m,
        "exact.clearance_m" => worked.clearance_m(exact),
        "exact.length_m" => exact.length_m,
        "line.ship_n" => line()?.ship_n,
        "line.sag_m" => line()?.sag_m,
        _ => return Err(unknown(name)),
    })
}
