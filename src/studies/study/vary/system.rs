//! A system of lines at the points of a variation.

use std::sync::atomic::AtomicBool;

use super::super::points::{BaseCase, Setting, StudyPoint, reasons, side_by_side};
use super::Variation;
use crate::study::studied;
use crate::system::SolvedSystem;
use crate::system::quantities::{error, value};
use crate::system::stability::Stability;

/// A system at rest at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct SystemPoint {
    /// The results, in the order asked for: value and error, or why there is none.
    pub results: Vec<Result<SystemResult, String>>,
    /// How it rests.
    pub stability: Stability,
}

impl SystemPoint {
    /// The results of these names of a system at rest.
    #[must_use]
    pub fn of_system(solved: &SolvedSystem, results: &[String]) -> Self {
        let read = |name: &String| {
            value(solved, name).map(|value| SystemResult {
                value,
                error: error(solved, name),
            })
        };
        Self {
            results: results.iter().map(read).collect(),
            stability: solved.stability.clone(),
        }
    }
}

/// A result of a system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SystemResult {
    /// Its value.
    pub value: f64,
    /// Its error, where it is known.
    pub error: Option<f64>,
}

/// What became of a point: its results, or why the system refuses it or has no equilibrium there.
pub type SystemOutcome = Result<SystemPoint, String>;

/// Computes the results of these names at every point, side by side. A point that fails stops no other; once `cancel` is set no further one
/// begins. `told` hears how many are done, of how many.
pub fn compute(
    variation: &Variation,
    results: &[String],
    cancel: &AtomicBool,
    told: &(dyn Fn(usize, usize) + Sync),
) -> Vec<Option<SystemOutcome>> {
    let points: Vec<&StudyPoint> = variation.points.iter().collect();
    let one = |point: &StudyPoint| {
        let solved = solve(&variation.base, &point.settings)?;
        Ok(SystemPoint::of_system(&solved, results))
    };
    side_by_side(points, cancel, one, |done, of, _, _| told(done, of))
}

/// The system of a case with some keys set.
///
/// # Errors
/// What is wrong with it then, or why it does not come to rest, in words.
pub fn solve(base: &BaseCase, settings: &[Setting]) -> Result<SolvedSystem, String> {
    let read = studied::read(base, settings)?;
    read.compute().map_err(|faults| reasons(&faults))
}
