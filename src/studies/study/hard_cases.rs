//! Hard cases: case files with trials, each a way to compute the case with an expected result.
//!
//! Trials are computed side by side, each on one thread from its own text alone, so that the table does not depend on
//! how many threads there are.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use super::verdict::{TrialVerdict, verdict};
pub use super::verdict_table::{compact_table, description, table};
use crate::case::{self, Case, Diagnostic, Trial, edit};
use crate::run::Run;
use crate::run::job::{self, Request};

/// A case with trials.
#[derive(Debug, Clone)]
pub struct HardCase {
    /// File name of the case.
    pub file: String,
    /// Its text.
    pub text: String,
    /// The case.
    pub case: Case,
}

/// One trial of one case, to be computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TrialTask {
    /// The case, by its place in the list.
    pub case: usize,
    /// The trial, by its place in the case.
    pub trial: usize,
}

/// A trial as computed: a run, or the reason why its case was refused.
pub type TrialRun = Result<Run, String>;

/// The hard cases that come with the program.
///
/// # Errors
/// What is wrong with a case, which a test of the program excludes.
pub fn shipped() -> Result<Vec<HardCase>, Vec<Diagnostic>> {
    let with_trials = case::shipped::SHIPPED.iter().map(|(path, text)| {
        let case = case::parse(text, path)?;
        Ok(HardCase {
            file: (*path).to_owned(),
            text: (*text).to_owned(),
            case,
        })
    });
    let all: Result<Vec<HardCase>, Vec<Diagnostic>> = with_trials.collect();
    Ok(all?
        .into_iter()
        .filter(|hard| !hard.case.trial.is_empty())
        .collect())
}

/// Everything to be computed, in the order of the table.
#[must_use]
pub fn tasks(cases: &[HardCase]) -> Vec<TrialTask> {
    let numbered = cases.iter().enumerate();
    numbered
        .flat_map(|(case, hard)| {
            (0..hard.case.trial.len()).map(move |trial| TrialTask { case, trial })
        })
        .collect()
}

/// Computes a trial.
///
/// # Errors
/// The reason for which the case of the trial is refused before anything is computed.
pub fn compute(hard: &HardCase, trial: &Trial, cancel: &AtomicBool) -> TrialRun {
    let request = request(hard, trial).map_err(|faults| {
        let problems = faults.iter().map(|d| format!("{}: {}", d.key, d.problem));
        problems.collect::<Vec<_>>().join("; ")
    })?;
    Ok(job::execute(&request, cancel, &mut |_| {}))
}

/// The case with the keys of a trial set, without companion runs: the error of a trial is its distance from the expected
/// value.
fn request(hard: &HardCase, trial: &Trial) -> Result<Request, Vec<Diagnostic>> {
    let mut overrides = vec!["solver.error_estimate=false".to_owned()];
    overrides.extend(trial.set.iter().flatten().cloned());
    let edits: Vec<(&str, &str)> = overrides
        .iter()
        .filter_map(|word| word.split_once('='))
        .map(|(key, value)| (key.trim(), value.trim()))
        .collect();
    let text = edit::set_all(&hard.text, &edits)?;
    let case = case::parse(&text, &hard.file)?;
    Ok(Request {
        case,
        text,
        file: hard.file.clone(),
        overrides,
        id: trial.name.clone(),
    })
}

/// Computes all trials side by side, on the threads of the caller's pool. After each one `progress` receives what has been
/// computed so far, in the order of [`tasks`], and how many that is. Once `cancel` is set no further one begins, and one
/// that was stopped is left out.
pub fn compute_all(
    cases: &[HardCase],
    cancel: &AtomicBool,
    progress: &(dyn Fn(&[Option<TrialRun>], usize) + Sync),
) -> Vec<Option<TrialRun>> {
    let tasks = tasks(cases);
    let all: Vec<Option<TrialRun>> = tasks.iter().map(|_| None).collect();
    let so_far = Mutex::new((all, 0));
    let stopped = || cancel.load(Ordering::Relaxed);
    tasks.par_iter().enumerate().for_each(|(place, task)| {
        let Some(hard) = cases.get(task.case).filter(|_| !stopped()) else {
            return;
        };
        let Some(trial) = hard.case.trial.get(task.trial) else {
            return;
        };
        let computed = compute(hard, trial, cancel);
        let mut so_far = so_far.lock().unwrap_or_else(PoisonError::into_inner);
        let (all, done) = &mut *so_far;
        if let Some(one) = all.get_mut(place).filter(|_| !stopped()) {
            *one = Some(computed);
            *done += 1;
            progress(all, *done);
        }
    });
    let (all, _) = so_far.into_inner().unwrap_or_else(PoisonError::into_inner);
    all
}

/// The verdicts on what has been computed so far, in the order of [`tasks`].
#[must_use]
pub fn verdicts(cases: &[HardCase], computed: &[Option<TrialRun>]) -> Vec<TrialVerdict> {
    let mut list = Vec::new();
    let mut from = 0;
    for hard in cases {
        let trials = &hard.case.trial;
        let of_case = computed.get(from..from + trials.len()).unwrap_or_default();
        from += trials.len();
        for (trial, result) in trials.iter().zip(of_case) {
            let Some(result) = result else { continue };
            let other = trial.same_as.as_ref().and_then(|name| {
                let at = trials.iter().position(|t| t.name == *name)?;
                of_case.get(at)?.as_ref()?.as_ref().ok()
            });
            list.push(verdict(hard, trial, result, other));
        }
    }
    list
}
