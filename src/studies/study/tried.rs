//! The kinds of file with trials: cases of lines, and systems at rest or in time.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::case::file_kind::FileKind;
use crate::case::{Case, Diagnostic, ReadFile, Trial};
use crate::reference::{self, ComparedRun, ValidationRow};
use crate::run::job::{self, Request};
use crate::run::{RunInfo, RunState, Settings, Work};
use crate::system::results_in_time::id_in_time;
use crate::system::validation::{self, ComputedSystem};
use crate::system::warnings::warnings;
use crate::system::{SolvedSystem, SystemFile, motion};

/// What a trial came to.
#[derive(Debug, Clone)]
pub struct ComputedTrial {
    /// The settings it ran with.
    pub(super) settings: Settings,
    /// The work it took.
    pub(super) work: Work,
    /// Whether it came to its end.
    pub(super) is_done: bool,
    /// Why it failed.
    pub(super) failure: Option<String>,
    /// What it warns of.
    pub(super) warnings: Vec<String>,
    /// Its numbers beside the published values.
    pub(super) rows: Vec<ValidationRow>,
}

impl ComputedTrial {
    fn of_run(info: RunInfo, rows: Vec<ValidationRow>) -> Self {
        Self {
            settings: info.settings,
            work: info.work,
            is_done: info.state == RunState::Done,
            failure: info.failure,
            warnings: info.warnings,
            rows,
        }
    }

    /// Of a system at rest.
    fn at_rest(solved: &SolvedSystem, rows: Vec<ValidationRow>) -> Self {
        Self {
            settings: Settings {
                method: AT_REST.to_owned(),
                ..Settings::default()
            },
            work: Work {
                iterations: solved.rest.steps as u64,
                evaluations: solved.rest.evaluations as u64,
                ..Work::default()
            },
            is_done: true,
            failure: None,
            warnings: warnings(solved),
            rows,
        }
    }
}

/// The word for the method of a system at rest.
const AT_REST: &str = "at rest";

/// A kind of file with trials.
pub trait Tried: FileKind {
    /// Its title.
    fn title(&self) -> &str;

    /// Its trials.
    fn trials(&self) -> &[Trial];

    /// Computes the file of a trial, without companion runs: the error of a trial is its distance from the expected value.
    ///
    /// # Errors
    /// What shows only in the computation: why a system does not come to rest.
    fn compute_trial(
        read: ReadFile<Self>,
        trial: &Trial,
        cancel: &AtomicBool,
    ) -> Result<ComputedTrial, Vec<Diagnostic>>;
}

impl Tried for Case {
    fn title(&self) -> &str {
        &self.case.title
    }

    fn trials(&self) -> &[Trial] {
        &self.trial
    }

    fn compute_trial(
        read: ReadFile<Self>,
        _: &Trial,
        cancel: &AtomicBool,
    ) -> Result<ComputedTrial, Vec<Diagnostic>> {
        let mut request = Request {
            case: read.content,
            text: read.text,
            file: String::new(),
            overrides: Vec::new(),
            id: String::new(),
        };
        request.case.solver.error_estimate = false;
        let run = job::execute(&request, cancel, &mut |_| {});
        let rows = reference::rows(&request.case, &|_| Some(&run));
        Ok(ComputedTrial::of_run(run.info, rows))
    }
}

impl Tried for SystemFile {
    fn title(&self) -> &str {
        &self.about.title
    }

    fn trials(&self) -> &[Trial] {
        &self.trial
    }

    fn compute_trial(
        mut read: ReadFile<Self>,
        trial: &Trial,
        cancel: &AtomicBool,
    ) -> Result<ComputedTrial, Vec<Diagnostic>> {
        if let Some(motion) = &mut read.content.solver {
            motion.error_estimate = false;
        }
        let text = read.text.clone();
        let solved = Arc::new(read.compute()?);
        let request = motion::job::request(Arc::clone(&solved), &text, String::new(), Vec::new());
        let Some(request) = request.filter(|_| !is_of_rest(&solved.file, trial)) else {
            let rows = validation::rows_of_trials(&ComputedSystem {
                solved: &solved,
                run: Err("The trial has no run in time.".to_owned()),
            });
            return Ok(ComputedTrial::at_rest(&solved, rows));
        };
        let run = job::execute(&request, cancel, &mut |_| {});
        let rows = validation::rows_of_trials(&ComputedSystem {
            solved: &solved,
            run: ComparedRun::of_run(&run),
        });
        Ok(ComputedTrial::of_run(run.info, rows))
    }
}

/// Whether a trial names published values at rest alone, so that its run in time would show nothing.
fn is_of_rest(file: &SystemFile, trial: &Trial) -> bool {
    let is_at_rest = |name: &String| {
        let printed = file.published.iter().find(|printed| printed.name == *name);
        printed.is_some_and(|printed| id_in_time(&printed.quantity).is_none())
    };
    let named = trial.rows.as_ref();
    named.is_some_and(|names| names.iter().all(is_at_rest))
}
