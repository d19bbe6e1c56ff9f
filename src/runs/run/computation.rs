//! What a run computes: a case of a line, or a system of lines in time.

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use super::checkpoint::Resumed;
use super::compute::{Computed, Resolution, compute};
use super::event::Listener;
use super::outlook::TRIAL;
use super::refinable::Refinable;
use super::{Checkpoint, ResumedRun, Work, limits, settings};
use crate::case::fields::Schema;
use crate::case::model::CASE;
use crate::case::{Attachment, Case, Method};
use crate::scene;

/// What a run computes.
pub trait Computation: Clone + Sync {
    /// The state from which a stored run of it is resumed.
    type Checkpoint;

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
        from: Option<&Resumed<Self::Checkpoint>>,
        cancel: &AtomicBool,
    ) -> Option<(Self, Option<String>)>;

    /// Computes it, or resumes a stored run of it.
    fn compute(
        &self,
        from: Option<&Resumed<Self::Checkpoint>>,
        cancel: &AtomicBool,
        events: Listener<'_>,
    ) -> Computed;

    /// What its results say beside their numbers.
    fn remarks(&self, run: &Computed) -> Vec<String>;

    /// Asks what is computed again to tell its errors; nothing where it could not be computed once.
    fn ask_refinable<T>(&self, ask: impl FnOnce(&dyn Refinable) -> T) -> Option<T>;
}

impl Computation for Case {
    type Checkpoint = Checkpoint;

    fn schema() -> &'static Schema {
        &CASE
    }

    fn title(&self) -> &str {
        &self.case.title
    }

    fn method(&self) -> &'static str {
        settings::method_name(self.solver.method)
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
        let outlook = settings::outlook(&case, &scene);
        let (method, why) = match outlook.clear {
            Some(why) => (Method::Alpha, why),
            None => {
                let (cheaper, why) = outlook.choose(&tried(&case, cancel));
                (cheaper.into(), why)
            }
        };
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

/// Work of generalized-alpha in a trial of the case.
fn tried(case: &Case, cancel: &AtomicBool) -> Work {
    let mut case = case.clone();
    case.solver.duration_s *= TRIAL;
    case.output.interval_s = case.solver.duration_s;
    let trial = compute(&case, Resolution::AS_SET, None, cancel, None);
    trial.outcome.work
}
