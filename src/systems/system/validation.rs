//! A system compared with its published values: rows of the validation table.

use super::motion::run::MotionRun;
use super::quantities::{error, unit, value};
use super::results_in_time::id_in_time;
use super::solved::SolvedSystem;
use crate::case::QuantityId;
use crate::published::{PublishedNumber, ValidationRow};
use crate::run::error_estimate::HistoryPair;
use crate::run::{History, Quantity, Run};

/// What a run in time is compared by.
#[derive(Debug, Clone, Copy)]
pub struct ComparedRun<'r> {
    /// The channels at the output times.
    pub history: &'r History,
    /// All single numbers with their errors.
    pub summary: &'r [Quantity],
    /// The pairs of companions by which errors of curves are told; none of a stored run.
    pub companions: &'r [HistoryPair],
}

impl<'r> ComparedRun<'r> {
    /// Of a run that is computed or stored.
    ///
    /// # Errors
    /// Why the run ended early, as a sentence.
    pub fn of_run(run: &'r Run) -> Result<Self, String> {
        ended(run.info.failure.as_ref())?;
        Ok(Self {
            history: &run.history,
            summary: &run.summary,
            companions: &[],
        })
    }

    fn of_motion(run: &'r MotionRun) -> Result<Self, String> {
        ended(run.failure.as_ref())?;
        Ok(Self {
            history: &run.history,
            summary: &run.summary,
            companions: &run.companions,
        })
    }

    /// A number of the summary, with its error where that is estimated.
    fn number(&self, id: &QuantityId) -> Result<(f64, Option<f64>), String> {
        let found = self.summary.iter().find(|number| number.id == *id);
        let number = found.ok_or_else(|| format!("The run has no result `{id}`."))?;
        Ok((number.value, number.error_estimate()))
    }
}

fn ended(failure: Option<&String>) -> Result<(), String> {
    failure.map_or(Ok(()), |why| Err(format!("The run ended early: {why}.")))
}

/// Rows for every published value of a system at rest and of its run in time, then for every published curve of that run, in the order of
/// its file. Without a run what is of one reads NOT RUN.
#[must_use]
pub fn rows(solved: &SolvedSystem, run: Option<&MotionRun>) -> Vec<ValidationRow> {
    let run = match run {
        None if solved.file.in_time().is_none() => {
            Err("The file has no run in time: add [solver].".to_owned())
        }
        None => Err("`seacable validate` computes the run in time.".to_owned()),
        Some(run) => ComparedRun::of_motion(run),
    };
    rows_of(solved, &run)
}

/// The same for a run, or why there is none.
#[must_use]
pub fn rows_of(solved: &SolvedSystem, run: &Result<ComparedRun<'_>, String>) -> Vec<ValidationRow> {
    let mut rows = rows_of_trials(solved, run);
    rows.retain(|row| !row.of_trials);
    rows
}

/// The same with the rows that only trials hold.
#[must_use]
pub fn rows_of_trials(
    solved: &SolvedSystem,
    run: &Result<ComparedRun<'_>, String>,
) -> Vec<ValidationRow> {
    let file = &solved.file;
    let numbers = file.published.iter();
    let numbers = numbers.map(|printed| match id_in_time(&printed.quantity) {
        Some(id) => {
            let found = run.as_ref().map_err(String::clone);
            printed.held(&id.unit(), found.and_then(|run| run.number(&id)))
        }
        None => at_rest(solved, printed),
    });
    let history = run.as_ref().map(|run| run.history).map_err(String::clone);
    let companions = run.as_ref().map_or(&[][..], |run| run.companions);
    let curves = file.published_curve.iter();
    let curves = curves.flat_map(|curve| curve.rows(history.clone(), companions));
    let common = file.about.tolerance_reason.as_deref();
    let all = numbers.chain(curves);
    all.map(|row| row.with_common_reason(common)).collect()
}

fn at_rest(solved: &SolvedSystem, printed: &PublishedNumber) -> ValidationRow {
    // Closed forms are exact to rounding.
    let error = match solved.is_discretised() {
        true => error(solved, &printed.quantity),
        false => Some(0.0),
    };
    let found = value(solved, &printed.quantity).map(|value| (value, error));
    printed.held(unit(&printed.quantity), found)
}
