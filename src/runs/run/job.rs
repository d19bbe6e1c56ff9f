//! Computes a case: on the caller's thread by [`execute`], on its own by [`start`], with a flag to cancel it. Events are
//! sent; a bounded channel makes the solver wait for its receiver, a receiver that is gone does not.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use crossbeam_channel::Sender;

use super::compute::{Computed, Resolution, compute};
use super::error_estimate::ErrorEstimates;
pub use super::event::JobEvent;
use super::observer::RunRecord;
use super::outlook::TRIAL;
use super::store::{now, rfc3339};
use super::{
    Cost, Quantity, ResumedRun, Run, RunInfo, RunState, Settings, VERSION, Work, accuracy,
    energy_balance, error_estimate, limits, refuse_not_finite, settings,
};
use crate::background::lower_priority;
use crate::case::{Case, Method, stand_alone};
use crate::scene;

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// The case, checked.
    pub case: Case,
    /// Its text, with every override applied; kept with the run.
    pub text: String,
    /// File name of the case.
    pub file: String,
    /// Keys set on top of the file, as `key=value`.
    pub overrides: Vec<String>,
    /// Name of the run.
    pub id: String,
}

impl Request {
    /// The content of `run.toml` while the run is computed.
    #[must_use]
    pub fn initial_info(&self) -> RunInfo {
        RunInfo {
            id: self.id.clone(),
            title: self.case.case.title.clone(),
            case_file: self.file.clone(),
            state: RunState::Partial,
            version: VERSION.to_owned(),
            started: rfc3339(now()),
            overrides: self.overrides.clone(),
            failure: None,
            warnings: Vec::new(),
            happened: Vec::new(),
            settings: Settings {
                method: settings::method_name(self.case.solver.method).to_owned(),
                duration_s: self.case.solver.duration_s,
                ..Settings::default()
            },
            work: Work::default(),
            cost: Cost::default(),
        }
    }
}

/// Starts a thread of lower priority that computes a run of this name, and sends its events. The last one is always
/// [`JobEvent::Finished`].
///
/// # Errors
/// When the system gives no thread.
pub fn start(
    id: &str,
    events: Sender<JobEvent>,
    compute: impl FnOnce(&mut dyn FnMut(JobEvent)) -> Run + Send + 'static,
) -> std::io::Result<()> {
    std::thread::Builder::new()
        .name(format!("job {id}"))
        .spawn(move || {
            lower_priority();
            // A channel that nobody listens to any more is no reason to stop early.
            let mut send = |event| drop(events.send(event));
            let run = compute(&mut send);
            send(JobEvent::Finished(Box::new(run)));
        })?;
    Ok(())
}

/// Computes a request, with its companions if the case asks for error estimates. A failure is reported in the run,
/// which keeps the results before it. Does not send [`JobEvent::Finished`]: the run is returned.
pub fn execute(request: &Request, cancel: &AtomicBool, events: &mut dyn FnMut(JobEvent)) -> Run {
    execute_from(request, None, cancel, events)
}

/// As [`execute`], or resumes an earlier run.
pub fn execute_from(
    request: &Request,
    from: Option<&ResumedRun>,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> Run {
    let started = rfc3339(now());
    let (chosen, reason) = chosen(request, from, cancel);
    // The method of a trial that was stopped may be another one than that of the whole trial.
    let stopped = chosen.is_some() && cancel.load(Ordering::Relaxed);
    let request = chosen.as_ref().unwrap_or(request);
    // A run that was stopped after its search keeps what was found, and asks for no accuracy any more.
    let accuracy = request
        .case
        .solver
        .accuracy
        .filter(|_| from.is_none() && !stopped);
    let mut reached = accuracy.map(|accuracy| accuracy::search(request, accuracy, cancel, events));
    let found = reached.as_mut().and_then(|reached| reached.run.take());
    let request = reached.as_ref().map_or(request, |reached| &reached.request);
    let case = &request.case;
    if accuracy.is_some() {
        events(JobEvent::Case(
            stand_alone(&request.text, case).into_owned(),
        ));
    }
    let (mut computed, known) = match found {
        _ if stopped => (Computed::stopped(), None),
        Some(found) => computed_of(found, case, cancel, events),
        None => (
            compute(case, Resolution::AS_SET, from, cancel, Some(&mut *events)),
            None,
        ),
    };
    let companions = Instant::now();
    let done = computed.outcome.state == RunState::Done;
    let estimates = match known {
        Some(known) if done => known,
        _ if done && case.solver.error_estimate => {
            events(JobEvent::Estimating);
            error_estimate::estimate(case, &computed, cancel)
        }
        _ => error_estimate::without_errors(&computed),
    };
    // Stopped among its companions: resumed, it has its errors left to estimate.
    if done && case.solver.error_estimate && cancel.load(Ordering::Relaxed) {
        computed.outcome.state = RunState::Cancelled;
    }
    let checks = limits::check(case, computed.record.profile());
    let exceeded = checks.iter().flat_map(limits::LimitCheck::warnings);
    computed.warnings.extend(exceeded);
    computed.warnings.extend(estimates.warnings);
    computed.warnings.extend(energy_balance::warning(
        &estimates.summary,
        computed.record.balance.as_ref(),
    ));
    if let Some(profile) = computed.record.profiles.first_mut() {
        profile.rms_error = estimates.rms;
    }
    computed.cost.companions_wall_s = companions.elapsed().as_secs_f64();
    computed.settings.method_reason = reason;
    if let Some(reached) = &reached {
        computed.settings.accuracy = Some(reached.words.clone());
        computed.warnings.extend(reached.failure.clone());
    }
    computed.settings.error_method = estimates.method;
    assemble(request, computed, started, estimates.summary)
}

/// The run that a search ended with, its events sent again; computed anew where they were not kept. With its errors.
fn computed_of(
    found: accuracy::EstimatedRun,
    case: &Case,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> (Computed, Option<ErrorEstimates>) {
    let computed = match found.events {
        Some(kept) => {
            kept.into_iter().for_each(events);
            found.computed
        }
        None => compute(case, Resolution::AS_SET, None, cancel, Some(events)),
    };
    (computed, Some(found.estimates))
}

/// The request with the method that the program chooses where its case leaves the choice open, and the reason. A run that is resumed
/// keeps its method.
fn chosen(
    request: &Request,
    from: Option<&ResumedRun>,
    cancel: &AtomicBool,
) -> (Option<Request>, Option<String>) {
    if request.case.solver.method != Method::Auto {
        return (None, None);
    }
    let mut request = request.clone();
    if let Some(from) = from {
        let begun_with = from.checkpoint.chosen_method(&request.case);
        request.case.solver.method = begun_with.into();
        return (Some(request), Some(begun_with.as_begun()));
    }
    request.case.solver.method = Method::Alpha;
    // A case of which no scene can be built fails with its reason later.
    let Ok(scene) = scene::build(&request.case, 1) else {
        return (Some(request), None);
    };
    let outlook = settings::outlook(&request.case, &scene);
    let (method, why) = match outlook.clear {
        Some(why) => (Method::Alpha, why),
        None => {
            let (cheaper, why) = outlook.choose(&tried(&request.case, cancel));
            (cheaper.into(), why)
        }
    };
    request.case.solver.method = method;
    (Some(request), Some(why))
}

/// Work of generalized-alpha in a trial of the case.
fn tried(case: &Case, cancel: &AtomicBool) -> Work {
    let mut case = case.clone();
    case.solver.duration_s *= TRIAL;
    case.output.interval_s = case.solver.duration_s;
    let trial = compute(&case, Resolution::AS_SET, None, cancel, None);
    trial.outcome.work
}

pub(super) fn assemble(
    request: &Request,
    computed: Computed,
    started: String,
    summary: Vec<Quantity>,
) -> Run {
    let RunRecord {
        history,
        shapes,
        profiles,
        fatigue,
        ..
    } = computed.record;
    let mut run = Run {
        info: RunInfo {
            state: computed.outcome.state,
            started,
            failure: computed.outcome.failure,
            warnings: computed.warnings,
            settings: computed.settings,
            work: computed.outcome.work,
            cost: computed.cost,
            ..request.initial_info()
        },
        case_text: stand_alone(&request.text, &request.case).into_owned(),
        history,
        shapes,
        profiles,
        summary,
        fatigue,
    };
    refuse_not_finite(&mut run);
    run
}
