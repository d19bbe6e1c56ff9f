//! A system compared with its published values: rows of the validation table.

use super::motion::run::MotionRun;
use super::quantities::{error, unit, value};
use super::solved::SolvedSystem;
use crate::published::ValidationRow;
use crate::run::History;
use crate::run::error_estimate::HistoryPair;

/// Rows for every published value of a system at rest, then for every published curve of its run in time, in the order of its file.
/// Without a run the curves read NOT RUN.
#[must_use]
pub fn rows(solved: &SolvedSystem, run: Option<&MotionRun>) -> Vec<ValidationRow> {
    let history = match run {
        None if solved.file.solver.is_none() => {
            Err("The file has no run in time: add [solver].".to_owned())
        }
        None => Err("`seacable validate` computes the run in time.".to_owned()),
        Some(run) => match &run.failure {
            Some(why) => Err(format!("The run ended early: {why}.")),
            None => Ok(&run.history),
        },
    };
    rows_of(solved, &history, run.map_or(&[], |run| &run.companions))
}

/// The same for the history of a run, or why there is none, and those of its companions.
#[must_use]
pub fn rows_of(
    solved: &SolvedSystem,
    history: &Result<&History, String>,
    companions: &[HistoryPair],
) -> Vec<ValidationRow> {
    let file = &solved.file;
    let numbers = file.published.iter().map(|printed| {
        // Closed forms are exact to rounding.
        let error = match solved.is_discretised() {
            true => error(solved, &printed.quantity),
            false => Some(0.0),
        };
        let found = value(solved, &printed.quantity).map(|value| (value, error));
        printed.held(unit(&printed.quantity), found)
    });
    let curves = file.published_curve.iter();
    let curves = curves.flat_map(|curve| curve.rows(history.clone(), companions));
    let common = file.about.tolerance_reason.as_deref();
    let all = numbers.chain(curves);
    all.map(|row| row.with_common_reason(common)).collect()
}
