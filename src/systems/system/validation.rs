//! A system compared with its published values: rows of the validation table.

use super::model::SystemFile;
use super::motion::run::MotionRun;
use super::quantities::{error, unit, value};
use super::results_in_time::id_in_time;
use super::solved::SolvedSystem;
use crate::case::{EditedKey, QuantityId, StudyPoint, stands_at};
use crate::published::{ComputedNumber, PublishedNumber, ValidationRow};
use crate::reference::{NOT_RUN, PublishedStatements, ResultsAt};
use crate::run::error_estimate::HistoryPair;
use crate::run::{History, Quantity, Run, edited_inputs};

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
    fn number(&self, id: &QuantityId) -> Result<ComputedNumber, String> {
        let found = self.summary.iter().find(|number| number.id == *id);
        let number = found.ok_or_else(|| format!("The run has no result `{id}`."))?;
        Ok(number.computed())
    }
}

fn ended(failure: Option<&String>) -> Result<(), String> {
    failure.map_or(Ok(()), |why| Err(format!("The run ended early: {why}.")))
}

/// A system as it was computed: at rest, and its run or why there is none.
#[derive(Debug, Clone)]
pub struct ComputedSystem<'s> {
    /// At rest.
    pub solved: &'s SolvedSystem,
    /// Its run.
    pub run: Result<ComparedRun<'s>, String>,
}

impl<'s> ComputedSystem<'s> {
    /// At rest and in time; without a run what is of one reads NOT RUN.
    #[must_use]
    pub fn new(solved: &'s SolvedSystem, run: Option<&'s MotionRun>) -> Self {
        let run = match run {
            None if solved.file.as_run().is_none() => {
                Err("The file has no run: add [solver].".to_owned())
            }
            None => Err("`seacable validate` computes the run.".to_owned()),
            Some(run) => ComparedRun::of_motion(run),
        };
        Self { solved, run }
    }

    /// A result by its name, of the run or at rest.
    fn number(&self, name: &str) -> Result<ComputedNumber, String> {
        let solved = self.solved;
        match (id_in_time(name), &self.run) {
            (Some(id), Ok(run)) => run.number(&id),
            (Some(_), Err(why)) => Err(why.clone()),
            (None, _) => {
                // Closed forms are exact to rounding.
                let error = match solved.is_discretised() {
                    true => error(solved, name),
                    false => Some(0.0),
                };
                Ok(ComputedNumber::new(
                    value(solved, name)?,
                    error,
                    [None, error],
                ))
            }
        }
    }
}

/// What gives the system as it was computed at a point of a study, `None` being the file without one.
pub type SystemLookup<'l, 's> = dyn Fn(Option<&StudyPoint>) -> Option<ComputedSystem<'s>> + 'l;

/// The results of a system at the points of its studies.
struct SystemsAt<'l, 's>(&'l SystemLookup<'l, 's>);

impl ResultsAt for SystemsAt<'_, '_> {
    fn unit(&self, name: &str) -> String {
        id_in_time(name).map_or_else(|| unit(name).to_owned(), |id| id.unit())
    }

    fn number(&self, at: Option<&StudyPoint>, name: &str) -> Result<ComputedNumber, String> {
        let computed = self.0(at).ok_or_else(|| match at {
            Some(_) => "`seacable validate` computes the system at this point.".to_owned(),
            None => NOT_RUN.to_owned(),
        })?;
        computed.number(name)
    }
}

/// What the file of a system states of published numbers and trends.
#[must_use]
pub fn stated(file: &SystemFile) -> PublishedStatements<'_> {
    PublishedStatements {
        studies: &file.study,
        numbers: &file.published,
        trends: &file.trend,
        reason: file.about.tolerance_reason.as_deref(),
    }
}

/// Rows for every published value and trend of a system at rest and of its run in time, then for every published curve of that run, in the
/// order of its file. What is of a point of a study at which the system does not stand reads NOT RUN.
#[must_use]
pub fn rows(solved: &SolvedSystem, run: Option<&MotionRun>) -> Vec<ValidationRow> {
    rows_of(&ComputedSystem::new(solved, run))
}

/// The same of a system as it was computed.
#[must_use]
pub fn rows_of(computed: &ComputedSystem<'_>) -> Vec<ValidationRow> {
    let file = &computed.solved.file;
    rows_along_studies(file, &|at| {
        let here = at.is_none_or(|at| stands_at(file, &file.study, at));
        here.then(|| computed.clone())
    })
}

/// The rows of a trial, with those that only trials hold: what it names is of it, at whatever point of a study it stands.
#[must_use]
pub fn rows_of_trials(computed: &ComputedSystem<'_>) -> Vec<ValidationRow> {
    rows_at(&computed.solved.file, &|_| Some(computed.clone()))
}

/// The same of a run, of which rows whose published values are not for its inputs read EDITED.
#[must_use]
pub fn rows_of_run(solved: &SolvedSystem, run: &Run) -> Vec<ValidationRow> {
    let mut rows = rows_of(&ComputedSystem {
        solved,
        run: ComparedRun::of_run(run),
    });
    set_edited_aside(&mut rows, &solved.file, &edited_inputs::<SystemFile>(run));
    rows
}

/// The rows of a file whose systems at the points of its studies, which [`PublishedStatements::plan`] names, `lookup` gives; without those of trials.
#[must_use]
pub fn rows_along_studies(file: &SystemFile, lookup: &SystemLookup<'_, '_>) -> Vec<ValidationRow> {
    without_trials(rows_at(file, lookup))
}

/// Rows whose published values are not for the inputs of a file read EDITED.
pub fn set_edited_aside(rows: &mut [ValidationRow], file: &SystemFile, edited: &[EditedKey]) {
    // Rows of trials are none of these.
    let numbers = file.published.iter().filter(|row| !row.of_trials);
    let numbers: Vec<PublishedNumber> = numbers.cloned().collect();
    let stated = PublishedStatements {
        numbers: &numbers,
        ..stated(file)
    };
    stated.set_edited_aside(rows, [], edited);
}

fn without_trials(mut rows: Vec<ValidationRow>) -> Vec<ValidationRow> {
    rows.retain(|row| !row.of_trials);
    rows
}

fn rows_at(file: &SystemFile, lookup: &SystemLookup<'_, '_>) -> Vec<ValidationRow> {
    let mut rows = stated(file).rows(&SystemsAt(lookup));
    let here = lookup(None);
    let run = here.as_ref().map_or_else(
        || Err(NOT_RUN.to_owned()),
        |computed| computed.run.as_ref().map_err(String::clone),
    );
    let history = run.as_ref().map(|run| run.history).map_err(String::clone);
    let companions = run.as_ref().map_or(&[][..], |run| run.companions);
    let curves = file.published_curve.iter();
    let curves = curves.flat_map(|curve| curve.rows(history.clone(), companions));
    let common = file.about.tolerance_reason.as_deref();
    rows.extend(curves.map(|row| row.with_common_reason(common)));
    rows
}
