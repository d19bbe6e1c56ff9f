//! What a run computes: a case of a line, or a system of lines in time.

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use serde::de::DeserializeOwned;

use super::checkpoint::Resumed;
use super::compute::{Computed, Resolution, compute};
use super::event::Listener;
use super::line_bounds;
use super::outlook::{TRIAL, method_by};
use super::output_times::OutputTimes;
use super::refinable::Refinable;
use super::{Checkpoint, ResumedRun, Work, limits};
use crate::case::fields::Schema;
use crate::case::model::CASE;
use crate::case::{self, Attachment, Case, Diagnostic, Method};
use crate::scene;
use crate::solve::State;

/// What a run computes.
pub trait Computation: Clone + Sync {
    /// Its states.
    type State: DeserializeOwned;

    /// The computation of a stored text, by the name of its file.
    ///
    /// # Errors
    /// What is wrong with it, in words.
    fn of_stored(text: &str, file: &str) -> Result<Self, String>;

    /// A text with a key set.
    ///
    /// # Errors
    /// Why the key cannot have that value, in words.
    fn with_key(text: &str, key: &str, value: &str) -> Result<String, String>;

    /// Checks that it was not changed since a checkpoint of it was written, as far as its tables tell.
    ///
    /// # Errors
    /// What was changed, in words.
    fn check_unchanged(&self, _checkpoint: &Checkpoint<Self::State>) -> Result<(), String> {
        Ok(())
    }

    /// Checks that it can be computed on from a checkpoint.
    ///
    /// # Errors
    /// Why it cannot, in words.
    fn check_rows(&self, _checkpoint: &Checkpoint<Self::State>) -> Result<(), String> {
        Ok(())
    }

    /// The keys of its file.
    fn schema() -> &'static Schema;

    /// Its title.
    fn title(&self) -> &str;

    /// The word for its method.
    fn method(&self) -> &'static str;

    /// Simulated time \[s\].
    fn duration_s(&self) -> f64;

    /// The files that its file names.
    fn files(&self) -> &BTreeMap<String, Attachment>;

    /// Whether companions tell the errors of its results.
    fn has_companions(&self) -> bool;

    /// The same with the method that the program chooses, and why where a scene could be built; nothing where its file names one. A
    /// run that is resumed keeps its method.
    fn with_chosen_method(
        &self,
        from: Option<&Resumed<Self::State>>,
        cancel: &AtomicBool,
    ) -> Option<(Self, Option<String>)>;

    /// Computes it, or resumes a stored run of it.
    fn compute(
        &self,
        from: Option<&Resumed<Self::State>>,
        cancel: &AtomicBool,
        events: Listener<'_>,
    ) -> Computed;

    /// What its results say beside their numbers.
    fn remarks(&self, run: &Computed) -> Vec<String>;

    /// Asks what is computed again to tell its errors; nothing where it could not be computed once.
    fn ask_refinable<T>(&self, ask: impl FnOnce(&dyn Refinable) -> T) -> Option<T>;
}

impl Computation for Case {
    type State = State;

    fn of_stored(text: &str, file: &str) -> Result<Self, String> {
        case::parse_stored(text, file).map_err(|faults| first(&faults))
    }

    fn with_key(text: &str, key: &str, value: &str) -> Result<String, String> {
        case::edit::set(text, key, value)
            .map_err(|fault| format!("{key} {}: {}", fault.problem, fault.remedy))
    }

    /// By the method that `auto` chose.
    fn check_unchanged(&self, checkpoint: &Checkpoint) -> Result<(), String> {
        let mut chosen = self.clone();
        if self.solver.method == Method::Auto {
            chosen.solver.method = checkpoint.chosen_method(self).into();
        }
        checkpoint.check_case(&chosen)
    }

    fn check_rows(&self, checkpoint: &Checkpoint) -> Result<(), String> {
        let times = OutputTimes::new(self.solver.duration_s, self.output.interval_s);
        // Older runs have intervals that are rounded otherwise.
        const ROUNDED: f64 = 1e-12;
        if (times.interval / checkpoint.recorded.output_interval_s - 1.0).abs() > ROUNDED {
            return Err(format!(
                "The run cannot be resumed to {} s, which is not a whole number of its output intervals of {} s.",
                self.solver.duration_s, self.output.interval_s
            ));
        }
        Ok(())
    }

    fn schema() -> &'static Schema {
        &CASE
    }

    fn title(&self) -> &str {
        &self.case.title
    }

    fn method(&self) -> &'static str {
        self.solver.method.name()
    }

    fn duration_s(&self) -> f64 {
        self.solver.duration_s
    }

    fn files(&self) -> &BTreeMap<String, Attachment> {
        &self.files
    }

    fn has_companions(&self) -> bool {
        self.solver.error_estimate
    }

    fn with_chosen_method(
        &self,
        from: Option<&ResumedRun>,
        cancel: &AtomicBool,
    ) -> Option<(Self, Option<String>)> {
        if self.solver.method != Method::Auto {
            return None;
        }
        let mut case = self.clone();
        if let Some(from) = from {
            let begun_with = from.checkpoint.chosen_method(&case);
            case.solver.method = begun_with.into();
            return Some((case, Some(begun_with.as_begun())));
        }
        case.solver.method = Method::Alpha;
        // A case of which no scene can be built fails with its reason later.
        let Ok(scene) = scene::build(&case, 1) else {
            return Some((case, None));
        };
        let outlook = line_bounds::bounds(&case, &scene).outlook(&case.solver);
        let (method, why) = method_by(outlook, || tried(&case, cancel));
        case.solver.method = method;
        Some((case, Some(why)))
    }

    fn compute(
        &self,
        from: Option<&ResumedRun>,
        cancel: &AtomicBool,
        events: Listener<'_>,
    ) -> Computed {
        compute(self, Resolution::AS_SET, from, cancel, events)
    }

    fn remarks(&self, run: &Computed) -> Vec<String> {
        let checks = limits::check(self, run.record.profile());
        let exceeded = checks.iter().flat_map(limits::LimitCheck::warnings);
        exceeded.collect()
    }

    fn ask_refinable<T>(&self, ask: impl FnOnce(&dyn Refinable) -> T) -> Option<T> {
        Some(ask(self))
    }
}

/// The first of what is wrong, in words.
#[must_use]
pub fn first(faults: &[Diagnostic]) -> String {
    faults.first().map(ToString::to_string).unwrap_or_default()
}

/// Work of generalized-alpha in a trial of the case.
fn tried(case: &Case, cancel: &AtomicBool) -> Work {
    let mut case = case.clone();
    case.solver.duration_s *= TRIAL;
    case.output.interval_s = case.solver.duration_s;
    let trial = compute(&case, Resolution::AS_SET, None, cancel, None);
    trial.outcome.work
}
