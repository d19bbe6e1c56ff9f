//! The quantities of a ropeway by name, for published values and trends.

use super::elastic::RopeEquilibrium;
use super::inextensible::{InextensibleModel, MinimumTension};
use super::line::DiscretisedEquilibrium;
use super::parabola;
use super::solve::{ModelResults, SolvedRopeway};
use super::weight_check::WeightCheck;
use super::winch::WinchSample;
use super::winch_run::WinchRun;
use QuantityReader::{Check, Elastic, Line, Mean, Minimum, Model, Motion, Parabola, Path};

/// A quantity that published values and trends may name.
pub struct RopewayQuantity {
    /// Name, ending in its unit: `model.max_tension_n`.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Meaning.
    pub description: &'static str,
    read: QuantityReader,
}

/// The model that a quantity is of, and how it is read from its results.
enum QuantityReader {
    Model(fn(&InextensibleModel) -> f64),
    Minimum(fn(&MinimumTension) -> f64),
    Check(fn(&WeightCheck) -> f64),
    Parabola(fn((f64, f64, f64)) -> f64),
    /// Of the path by eq. (11), with the horizontal tension of the inextensible model.
    Path(fn(&SolvedRopeway, f64, f64) -> f64),
    Mean(fn((f64, f64)) -> f64),
    Motion(fn(&WinchRun) -> Result<f64, String>),
    Elastic(fn(&SolvedRopeway, &RopeEquilibrium) -> f64),
    Line(fn(&DiscretisedEquilibrium) -> f64),
}

const fn quantity(
    name: &'static str,
    unit: &'static str,
    read: QuantityReader,
    description: &'static str,
) -> RopewayQuantity {
    RopewayQuantity {
        name,
        unit,
        description,
        read,
    }
}

/// All quantities.
#[rustfmt::skip] // one quantity a line
pub static QUANTITIES: [RopewayQuantity; 31] = [
    quantity("model.horizontal_n", "N", Model(|m| m.rope.horizontal_n), "horizontal tension of the unloaded rope"),
    quantity("model.max_tension_n", "N", Model(|m| m.max_tension_n), "greatest end tension of the inextensible model: unloaded rope, whole cargo at one end"),
    quantity("model.length_m", "m", Model(|m| m.rope.length_m()), "length of the unloaded inextensible rope"),
    quantity("model.weight_n", "N", Model(|m| m.rope.weight_n()), "weight of that rope"),
    quantity("model.sag_m", "m", Model(|m| m.rope.sag_m()), "sag of that rope at mid-span"),
    quantity("model.least_tension_n", "N", Minimum(|m| m.tension_n), "least of the greatest end tensions over all lengths"),
    quantity("model.sag_at_least_m", "m", Minimum(|m| m.sag_m), "sag of the unloaded rope at that length"),
    quantity("finite_element.horizontal_n", "N", Check(|c| c.model.rope.horizontal_n), "horizontal tension of the model with the rope weight of the finite-element check"),
    quantity("finite_element.vertical_n", "N", Check(|c| c.model.rope.vertical_n().0.max(c.model.rope.vertical_n().1)), "vertical end force of the model with that weight, without cargo"),
    quantity("finite_element.weight_n", "N", Check(|c| c.model.rope.weight_n()), "weight of the rope with that weight per length"),
    quantity("finite_element.max_tension_n", "N", Check(|c| c.model.max_tension_n), "greatest end tension of the model with that weight"),
    quantity("finite_element.by_weight_n", "N", Check(WeightCheck::by_weight_n), "increase of the greatest end tension by that weight"),
    quantity("finite_element.more_weight_n", "N", Check(|c| c.model.rope.weight_n() - c.lighter.rope.weight_n()), "increase of the weight of the rope"),
    quantity("finite_element.left_n", "N", Check(WeightCheck::remainder_n), "end tension of the check less that of the model with the same rope weight"),
    quantity("parabola.sag_m", "m", Parabola(|p| p.2), "sag at the cargo by eq. (11) with the horizontal tension of the model"),
    quantity("parabola.ship_n", "N", Parabola(|p| p.1), "tension at the ship by parabola theory with that horizontal tension"),
    quantity("parabola.depth_m", "m", Path(depth_m), "depth of the cargo below the platform's hang point by eq. (11); at mid-span eq. (13)"),
    quantity("parabola.haul_n", "N", Path(haul_n), "pull that hauls the cargo up the path of eq. (11): its weight times the slope; none downhill"),
    quantity("exact.horizontal_n", "N", Elastic(|_, rope| rope.solution.h_b_n), "horizontal tension, elastic rope with the cargo on it"),
    quantity("exact.platform_n", "N", Elastic(|_, rope| rope.platform_n()), "tension at the platform"),
    quantity("exact.ship_n", "N", Elastic(|_, rope| rope.ship_n()), "tension at the ship"),
    quantity("exact.sag_m", "m", Elastic(|_, rope| rope.sag_m), "sag at the cargo"),
    quantity("exact.clearance_m", "m", Elastic(SolvedRopeway::clearance_m), "height of the cargo above the wave crests"),
    quantity("exact.mean_platform_n", "N", Mean(|m| m.0), "mean tension between platform and cargo, eq. (9)"),
    quantity("exact.mean_ship_n", "N", Mean(|m| m.1), "mean tension between cargo and ship, eq. (10)"),
    quantity("exact.length_m", "m", Elastic(|_, rope| rope.length_m), "unstretched length between the ends"),
    quantity("motion.made_fast_max_n", "N", Motion(|run| greatest(&run.made_fast, |s| s.ship_n)), "greatest tension at the ship while it moves, rope made fast"),
    quantity("motion.on_winch_max_n", "N", Motion(|run| greatest(on_winch(run)?, |s| s.ship_n)), "greatest tension at the ship while it moves, rope on the winch"),
    quantity("motion.winch_speed_m_per_s", "m/s", Motion(|run| greatest(on_winch(run)?, |s| s.speed_m_per_s.abs())), "greatest speed of the winch while the ship moves"),
    quantity("line.ship_n", "N", Line(|line| line.ship_n), "tension at the ship of the discretised line"),
    quantity("line.sag_m", "m", Line(|line| line.sag_m), "sag at the cargo of the discretised line"),
];

fn depth_m(ropeway: &SolvedRopeway, horizontal_n: f64, position: f64) -> f64 {
    let geometry = ropeway.rope.geometry;
    let sag = parabola::sag_m(
        geometry,
        ropeway.parabola_load(),
        horizontal_n,
        position * geometry.span_m,
    );
    sag - geometry.rise_m * position
}

fn haul_n(ropeway: &SolvedRopeway, horizontal_n: f64, position: f64) -> f64 {
    let geometry = ropeway.rope.geometry;
    let load = ropeway.parabola_load();
    let slope = parabola::slope(geometry, load, horizontal_n, position * geometry.span_m);
    load.cargo_n * slope.max(0.0)
}

fn on_winch(run: &WinchRun) -> Result<&Result<Vec<WinchSample>, super::RopewayError>, String> {
    let winch = run.constant_tension.as_ref();
    winch.ok_or_else(|| "The ropeway has no winch.".to_owned())
}

fn greatest(
    samples: &Result<Vec<WinchSample>, super::RopewayError>,
    of: fn(&WinchSample) -> f64,
) -> Result<f64, String> {
    let samples = samples
        .as_ref()
        .map_err(|error| format!("The moving rope has no solution: {error}."))?;
    Ok(samples.iter().map(of).fold(0.0, f64::max))
}

/// The quantity of this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static RopewayQuantity> {
    QUANTITIES.iter().find(|quantity| quantity.name == name)
}

/// Unit of the quantity of this name; empty where there is none.
#[must_use]
pub fn unit(name: &str) -> &'static str {
    find(name).map_or("", |quantity| quantity.unit)
}

/// The value of the quantity of this name at the position of the results.
///
/// # Errors
/// Why there is no value, as a sentence.
pub fn value(ropeway: &SolvedRopeway, results: &ModelResults, name: &str) -> Result<f64, String> {
    let quantity = find(name).ok_or_else(|| format!("There is no quantity `{name}`."))?;
    let unsolved =
        |model: &'static str| move |error| format!("The {model} has no solution: {error}.");
    match quantity.read {
        Model(read) => ropeway
            .inextensible
            .as_ref()
            .map(read)
            .map_err(unsolved("inextensible model")),
        Minimum(read) => ropeway
            .minimum_tension
            .as_ref()
            .map(read)
            .map_err(unsolved("inextensible model")),
        Check(read) => WeightCheck::of_ropeway(ropeway).map(|check| read(&check)),
        Parabola(read) => results
            .parabola
            .map(read)
            .ok_or_else(|| "Parabola theory has no horizontal tension.".to_owned()),
        Path(read) => {
            let model = ropeway.inextensible.as_ref();
            let model = model.map_err(unsolved("inextensible model"))?;
            Ok(read(ropeway, model.rope.horizontal_n, results.position))
        }
        Mean(read) => results
            .mean_tensions_n
            .map(read)
            .ok_or_else(|| "The cargo hangs at an end of the rope.".to_owned()),
        Motion(read) => {
            let series = ropeway.ship_motion();
            let series = series.ok_or_else(|| "The file has no [motion].".to_owned())?;
            let run = ropeway.run_winch(&series);
            read(&run.map_err(|error| format!("The rope at rest has no solution: {error}."))?)
        }
        Elastic(read) => Ok(read(ropeway, &results.exact)),
        Line(read) => results
            .line
            .as_ref()
            .map(read)
            .map_err(unsolved("discretised line")),
    }
}
