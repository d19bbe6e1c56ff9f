//! A system compared with its published values: rows of the validation table.

use super::model::SystemFile;
use super::motion::run::MotionRun;
use super::quantities::{error, unit, value};
use super::results_in_time::id_in_time;
use super::solved::SolvedSystem;
use crate::case::{EditedKey, QuantityId, StudyPoint, stands_at};
use crate::published::{ComputedNumber, PublishedNumber, ValidationRow};
use crate::reference::{ComparedRun, NOT_RUN, PublishedStatements, ResultsAt, ended};
use crate::run::{Run, edited_inputs};

/// What a computed run is compared by.
fn of_motion(run: &MotionRun) -> Result<ComparedRun<'_>, String> {
    ended(run.state, run.failure.as_deref())?;
    Ok(ComparedRun {
        history: &run.history,
        summary: &run.summary,
    })
}

/// A number of the summary of a run, with its error where that is estimated.
fn number(run: &ComparedRun<'_>, id: &QuantityId) -> Result<ComputedNumber, String> {
    let found = run.summary.iter().find(|number| number.id == *id);
    let number = found.ok_or_else(|| format!("The run has no result `{id}`."))?;
    Ok(number.computed())
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
            Some(run) => of_motion(run),
        };
        Self { solved, run }
    }

    /// A result by its name, of the run or at rest.
    fn number(&self, name: &str) -> Result<ComputedNumber, String> {
        let solved = self.solved;
        match (id_in_time(name), &self.run) {
            (Some(id), Ok(run)) => number(run, &id),
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

impl<'s> SystemsAt<'_, 's> {
    fn at(&self, at: Option<&StudyPoint>) -> Result<ComputedSystem<'s>, String> {
        self.0(at).ok_or_else(|| match at {
            Some(_) => "`seacable validate` computes the system at this point.".to_owned(),
            None => NOT_RUN.to_owned(),
        })
    }
}

impl ResultsAt for SystemsAt<'_, '_> {
    fn unit(&self, name: &str) -> String {
        id_in_time(name).map_or_else(|| unit(name).to_owned(), |id| id.unit())
    }

    fn number(&self, at: Option<&StudyPoint>, name: &str) -> Result<ComputedNumber, String> {
        self.at(at)?.number(name)
    }

    fn run(&self, at: Option<&StudyPoint>) -> Result<ComparedRun<'_>, String> {
        self.at(at)?.run
    }
}

/// What the file of a system states of published numbers, trends and curves.
#[must_use]
pub fn stated(file: &SystemFile) -> PublishedStatements<'_> {
    PublishedStatements {
        studies: &file.study,
        numbers: &file.published,
        trends: &file.trend,
        curves: &file.published_curve,
        reason: file.about.tolerance_reason.as_deref(),
    }
}

/// Rows for every published value, trend and curve of a system at rest and of its run in time, in the order of its file. What is of a point of a study at which the system does not stand reads NOT RUN.
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
    stated.set_edited_aside(rows, edited);
}

fn without_trials(mut rows: Vec<ValidationRow>) -> Vec<ValidationRow> {
    rows.retain(|row| !row.of_trials);
    rows
}

fn rows_at(file: &SystemFile, lookup: &SystemLookup<'_, '_>) -> Vec<ValidationRow> {
    stated(file).rows(&SystemsAt(lookup))
}
