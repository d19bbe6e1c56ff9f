//! Hard cases: files with trials, each a way to compute the file with an expected result.
//!
//! Trials are computed side by side, each on one thread from its own text alone, so that the table does not depend on
//! how many threads there are.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

pub use super::tried::{ComputedTrial, Tried};
use super::verdict::{TrialVerdict, verdict};
pub use super::verdict_table::{compact_table, description, table};
use crate::case::{Attachment, Case, Diagnostic, Trial, kind, shipped as files};
use crate::kinds::FileType;
use crate::system::SystemFile;

/// A file with trials.
#[derive(Debug, Clone)]
pub struct HardCase {
    /// Its name.
    pub file: String,
    /// Its title.
    pub title: String,
    /// Its trials.
    pub trials: Vec<Trial>,
    /// Its text, which carries the files that it names.
    text: String,
    /// These files, with the tables that were parsed of them.
    files: BTreeMap<String, Attachment>,
    /// Computes one of its trials.
    compute: fn(&Self, &Trial, &AtomicBool) -> TrialRun,
}

impl HardCase {
    /// A file of a kind, by its name, its text, which carries the files that it names, and what it says.
    pub fn new<K: Tried>(file: String, text: String, content: &K) -> Self {
        Self {
            file,
            title: content.title().to_owned(),
            trials: content.trials().to_vec(),
            text,
            files: content.files().cloned().unwrap_or_default(),
            compute: compute_variant::<K>,
        }
    }

    /// A file of a line or of a system, by the keys of its text. Files that the text names are looked for beside it.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn read(text: &str, file: &str) -> Result<Self, Vec<Diagnostic>> {
        match FileType::of_text(text) {
            FileType::System => Self::read_as::<SystemFile>(text, file),
            _ => Self::read_as::<Case>(text, file),
        }
    }

    /// A file of a kind, read from the disk.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn load<K: Tried>(path: &Path) -> Result<Self, Vec<Diagnostic>> {
        let read = kind::read_toml::<K>(path)?;
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        Ok(Self::new(
            file.into_owned(),
            read.whole_text(),
            &read.content,
        ))
    }

    fn read_as<K: Tried>(text: &str, file: &str) -> Result<Self, Vec<Diagnostic>> {
        let read = kind::read::<K>(text, file)?;
        Ok(Self::new(file.to_owned(), read.whole_text(), &read.content))
    }
}

/// One trial of one case, to be computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TrialTask {
    /// The case, by its place in the list.
    pub case: usize,
    /// The trial, by its place in the case.
    pub trial: usize,
}

/// A trial as computed, or the reason why its file was refused.
pub type TrialRun = Result<ComputedTrial, String>;

/// The hard cases that come with the program: of lines, then of systems.
///
/// # Errors
/// What is wrong with a case, which a test of the program excludes.
pub fn shipped() -> Result<Vec<HardCase>, Vec<Diagnostic>> {
    let files = files::SHIPPED.iter().chain(files::SYSTEMS);
    let all: Result<Vec<HardCase>, _> = files
        .map(|(path, text)| HardCase::read(text, path))
        .collect();
    let mut all = all?;
    all.retain(|hard| !hard.trials.is_empty());
    Ok(all)
}

/// Everything to be computed, in the order of the table.
#[must_use]
pub fn tasks(cases: &[HardCase]) -> Vec<TrialTask> {
    let numbered = cases.iter().enumerate();
    numbered
        .flat_map(|(case, hard)| (0..hard.trials.len()).map(move |trial| TrialTask { case, trial }))
        .collect()
}

/// Computes a trial.
///
/// # Errors
/// The reason for which the file of the trial is refused before it is computed in time.
pub fn compute(hard: &HardCase, trial: &Trial, cancel: &AtomicBool) -> TrialRun {
    (hard.compute)(hard, trial, cancel)
}

/// Computes the file with the keys of a trial set.
fn compute_variant<K: Tried>(hard: &HardCase, trial: &Trial, cancel: &AtomicBool) -> TrialRun {
    let set = trial.set.iter().flatten();
    let edits: Vec<(&str, &str)> = set
        .filter_map(|word| word.split_once('='))
        .map(|(key, value)| (key.trim(), value.trim()))
        .collect();
    let read = kind::read_variant::<K>(&hard.text, &edits, &hard.files);
    let computed = read.and_then(|read| K::compute_trial(read, trial, cancel));
    computed.map_err(|faults| {
        let problems = faults.iter().map(|d| format!("{}: {}", d.key, d.problem));
        problems.collect::<Vec<_>>().join("; ")
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
        let Some(trial) = hard.trials.get(task.trial) else {
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
        let trials = &hard.trials;
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
