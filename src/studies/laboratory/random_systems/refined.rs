//! Values of a system at rest against those of the same system on a finer mesh: whether the errors stated hold.

use rayon::prelude::*;

use super::divided::{DIVIDED_KINDS, divided};
use crate::case::kind;
use crate::numerics::random::Random;
use crate::system::equilibrium::search_near;
use crate::system::network::Held;
use crate::system::quantities::{error, unit, value, value_at};
use crate::system::rest::{not_divided, refused};
use crate::system::{SolvedSystem, SystemFile};

/// Values of a random system against a finer mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct RefinedSystem {
    /// Number of the system.
    pub index: usize,
    /// Number of its kind.
    pub kind: usize,
    /// Its values, or why there are none.
    pub values: Result<Vec<RefinedValue>, String>,
}

/// What came of some systems; shares from 0 to 1, nothing of none.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct RefinedTally {
    /// Systems without values.
    pub refused: usize,
    /// Systems with values.
    pub systems: usize,
    /// Share of them all of whose values are within their errors.
    pub systems_that_hold: Option<f64>,
    /// Values that are compared.
    pub values: usize,
    /// Share of them that are within their errors.
    pub values_that_hold: Option<f64>,
    /// Median of the stated error by the difference.
    pub median_ratio: Option<f64>,
    /// Share of the values whose stated error is more than ten times the difference.
    pub too_wide: Option<f64>,
}

/// A value against that of a finer mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct RefinedValue {
    /// Its name, as [`value`] reads it.
    pub name: String,
    /// On the mesh of the file.
    pub value: f64,
    /// The error that is stated, where one is.
    pub stated: Option<f64>,
    /// On the finer mesh.
    pub refined: f64,
    /// Difference that is rounding, not the mesh: of the greatest value of its unit.
    pub rounding: f64,
}

/// Share of the greatest value of the same unit that is rounding.
const ROUNDING: f64 = 1e-9;
/// A stated error so many times the difference is too wide.
const TOO_WIDE: f64 = 10.0;

impl RefinedValue {
    fn difference(&self) -> f64 {
        (self.value - self.refined).abs()
    }

    /// Whether an error is stated, and holds.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.difference() <= self.stated.unwrap_or(0.0).max(self.rounding)
    }

    /// The stated error by the difference; nothing where that is rounding.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        let notable = self.difference() > self.rounding;
        notable.then(|| self.stated.unwrap_or(0.0) / self.difference())
    }
}

/// So many random systems of a seed, against so many times their segments, on all cores.
#[must_use]
pub fn run(count: usize, seed: u64, by: usize) -> Vec<RefinedSystem> {
    let one = |index: usize| {
        let kind = index % DIVIDED_KINDS.len();
        let text = divided(kind, &mut Random::new(seed, index as u64));
        let solved = kind::parse::<SystemFile>(&text, "random.toml");
        let solved = solved.map_err(|wrong| {
            let problems = wrong.iter().map(|one| one.problem.as_str());
            problems.collect::<Vec<_>>().join("; ")
        });
        RefinedSystem {
            index,
            kind,
            values: solved.and_then(|solved| against_refined(&solved, by)),
        }
    };
    (0..count).into_par_iter().map(one).collect()
}

/// What came of some systems.
pub fn tally<'a>(systems: impl Iterator<Item = &'a RefinedSystem>) -> RefinedTally {
    let (solved, refused): (Vec<_>, Vec<_>) = systems.partition(|system| system.values.is_ok());
    let compared: Vec<&Vec<RefinedValue>> = solved
        .iter()
        .filter_map(|s| s.values.as_ref().ok())
        .collect();
    let values: Vec<&RefinedValue> = compared.iter().copied().flatten().collect();
    let mut ratios: Vec<f64> = values.iter().filter_map(|value| value.ratio()).collect();
    ratios.sort_by(f64::total_cmp);
    let holds = |values: &&Vec<RefinedValue>| values.iter().all(RefinedValue::holds);
    RefinedTally {
        refused: refused.len(),
        systems: compared.len(),
        systems_that_hold: share(compared.iter().copied(), holds),
        values: values.len(),
        values_that_hold: share(values.iter().copied(), |value| value.holds()),
        median_ratio: ratios.get(ratios.len() / 2).copied(),
        too_wide: share(ratios.iter().copied(), |ratio| *ratio > TOO_WIDE),
    }
}

fn share<T>(of: impl ExactSizeIterator<Item = T>, counts: impl Fn(&T) -> bool) -> Option<f64> {
    let all = of.len();
    let counted = of.filter(counts).count();
    (all > 0).then(|| counted as f64 / all as f64)
}

/// The tensions at both ends of all lines and the places of all points that move, against those of the same system with so many times
/// the segments in every divided line.
///
/// # Errors
/// Why the finer system has no equilibrium near.
pub fn against_refined(solved: &SolvedSystem, by: usize) -> Result<Vec<RefinedValue>, String> {
    let fine = solved.network.refined(by);
    let fine = fine.map_err(|error| not_divided(error).problem)?;
    let rest = search_near(&fine, &solved.rest.placement);
    let rest = rest.map_err(|error| refused(&fine, &error).problem)?;
    let size = solved
        .rest
        .placement
        .points
        .iter()
        .map(nalgebra::Matrix::amax);
    let size = size.fold(0.0, f64::max);
    let compared = names(solved).into_iter().filter_map(|name| {
        let greatest = if unit(&name) == "m" {
            size
        } else {
            solved.rest.balance.tension
        };
        Some(RefinedValue {
            value: value(solved, &name).ok()?,
            stated: error(solved, &name),
            refined: value_at(&fine, &rest, &name).ok()?,
            rounding: ROUNDING * greatest,
            name,
        })
    });
    Ok(compared.collect())
}

fn names(solved: &SolvedSystem) -> Vec<String> {
    let network = &solved.network;
    let lines = network.lines.iter();
    let tensions =
        lines.flat_map(|line| ["a", "b"].map(|end| format!("tension_n[{}|{end}]", line.name)));
    let moved = network.points.iter().filter(|point| match point.held {
        Held::At(_) => false,
        Held::On(body, _) => network.bodies[body].turns(),
        Held::Free(_) => true,
    });
    let places =
        moved.flat_map(|point| ["x_m", "y_m", "z_m"].map(|axis| format!("{axis}[{}]", point.name)));
    tensions.chain(places).collect()
}
