//! Computes a case of a line, or a system of lines in time: on the caller's thread by [`execute`], on its own by [`start`], with a flag to
//! cancel it. Events are sent; a bounded channel makes the solver wait for its receiver, a receiver that is gone does not.

use std::borrow::Cow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use crossbeam_channel::Sender;

use super::accuracy::searchable::Searchable;
use super::accuracy::{self, Reached, as_override};
use super::checkpoint::Resumed;
use super::computation::Computation;
use super::compute::Computed;
use super::error_estimate::ErrorEstimates;
pub use super::event::JobEvent;
use super::observer::RunRecord;
use super::store::{now, rfc3339};
use super::{
    Cost, Quantity, Run, RunInfo, RunState, Settings, VERSION, Work, energy_balance,
    error_estimate, refuse_not_finite,
};
use crate::background::lower_priority;
use crate::case::attachments::with_files;
use crate::case::{Case, edit};

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct Request<C = Case> {
    /// The case or the system, checked.
    pub case: C,
    /// Its text, with every override applied; kept with the run.
    pub text: String,
    /// Its file name.
    pub file: String,
    /// Keys set on top of the file, as `key=value`.
    pub overrides: Vec<String>,
    /// Name of the run.
    pub id: String,
}

impl<C: Computation> Request<C> {
    /// The content of `run.toml` while the run is computed.
    #[must_use]
    pub fn initial_info(&self) -> RunInfo {
        RunInfo {
            id: self.id.clone(),
            title: self.case.title().to_owned(),
            case_file: self.file.clone(),
            state: RunState::Partial,
            version: VERSION.to_owned(),
            started: rfc3339(now()),
            overrides: self.overrides.clone(),
            failure: None,
            warnings: Vec::new(),
            happened: Vec::new(),
            settings: Settings {
                method: self.case.method().to_owned(),
                duration_s: self.case.duration_s(),
                ..Settings::default()
            },
            work: Work::default(),
            cost: Cost::default(),
        }
    }

    /// Its text with the files that it names, as it is stored.
    #[must_use]
    pub fn stored_text(&self) -> Cow<'_, str> {
        with_files(&self.text, self.case.files())
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
pub fn execute<C: Searchable>(
    request: &Request<C>,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> Run {
    execute_from(request, None, cancel, events)
}

/// As [`execute`], or resumes an earlier run.
pub fn execute_from<C: Searchable>(
    request: &Request<C>,
    from: Option<&Resumed<C::State>>,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> Run {
    let started = rfc3339(now());
    let (chosen, reason) = match request.case.with_chosen_method(from, cancel) {
        Some((chosen, reason)) => (Some(chosen), reason),
        None => (None, None),
    };
    // The method of a trial that was stopped may be another one than that of the whole trial.
    let is_stopped = chosen.is_some() && from.is_none() && cancel.load(Ordering::Relaxed);
    let own = chosen.as_ref().unwrap_or(&request.case);
    // A run that was stopped after its search keeps what was found, and asks for no accuracy any more.
    let asked = own.asked().filter(|_| from.is_none() && !is_stopped);
    let mut reached = asked.map(|asked| accuracy::search(own, asked, cancel, events));
    let kept = reached.as_mut().and_then(|reached| reached.run.take());
    let request = of_reached(request, own, reached.as_ref());
    if reached.is_some() {
        events(JobEvent::Case(request.stored_text().into_owned()));
    }
    let case = &request.case;
    let (computed, known) = match kept {
        _ if is_stopped => (Computed::stopped(), None),
        Some(kept) => computed_of(kept, case, cancel, events),
        None => (case.compute(from, cancel, Some(&mut *events)), None),
    };
    let (mut computed, estimates) = with_estimates(case, computed, known, cancel, events);
    computed.settings.method_reason = reason;
    if let Some(reached) = reached {
        computed.settings.accuracy = Some(reached.words);
        computed.warnings.extend(reached.failure);
    }
    assemble(&request, computed, started, estimates.summary)
}

/// A computation with the errors of its results: those that are known, or told by companions where the case asks for them.
pub fn with_estimates<C: Computation>(
    case: &C,
    mut computed: Computed,
    known: Option<ErrorEstimates>,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> (Computed, ErrorEstimates) {
    let clock = Instant::now();
    let done = computed.outcome.state == RunState::Done;
    let estimates = match known {
        Some(known) if done => Some(known),
        _ if done && case.has_companions() => {
            events(JobEvent::Estimating);
            case.ask_refinable(|case| error_estimate::estimate(case, &computed, cancel))
        }
        _ => None,
    };
    let mut estimates = estimates.unwrap_or_else(|| error_estimate::without_errors(&computed));
    // Stopped among its companions: resumed, it has its errors left to estimate.
    if done && case.has_companions() && cancel.load(Ordering::Relaxed) {
        computed.outcome.state = RunState::Cancelled;
    }
    computed.warnings.extend(case.remarks(&computed));
    computed.warnings.append(&mut estimates.warnings);
    computed.warnings.extend(energy_balance::warning(
        &estimates.summary,
        computed.record.balance.as_ref(),
    ));
    let errors = std::mem::take(&mut estimates.rms);
    for (profile, errors) in computed.record.profiles.iter_mut().zip(errors) {
        profile.rms_error = errors;
    }
    computed.cost.companions_wall_s = clock.elapsed().as_secs_f64();
    computed.settings.error_method = std::mem::take(&mut estimates.method);
    (computed, estimates)
}

/// The run that a search ended with, its events sent again; computed anew where they were not kept. With its errors.
fn computed_of<C: Computation>(
    kept: accuracy::EstimatedRun,
    case: &C,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> (Computed, Option<ErrorEstimates>) {
    let computed = match kept.events {
        Some(all) => {
            all.into_iter().for_each(events);
            kept.computed
        }
        None => case.compute(None, cancel, Some(events)),
    };
    (computed, Some(kept.estimates))
}

/// What a search is asked, and a case that was found asks no more: computed again it is the same.
const ASKED: [&str; 2] = ["solver.accuracy", "solver.budget_s"];

/// The request of what a search came to, in the place of what was asked; as it is without one.
fn of_reached<C: Searchable>(
    request: &Request<C>,
    own: &C,
    reached: Option<&Reached<C>>,
) -> Request<C> {
    let mut request = Request {
        case: own.clone(),
        ..request.clone()
    };
    let Some(reached) = reached.filter(|reached| !reached.keys.is_empty()) else {
        return request;
    };
    if let Some(text) = text_of::<C>(&request.text, &reached.keys) {
        request.text = text;
    }
    let is_asked = |key: &String| ASKED.iter().any(|asked| key.starts_with(asked));
    request.overrides.retain(|key| !is_asked(key));
    request
        .overrides
        .extend(reached.keys.iter().map(as_override));
    request.case = reached.found.clone();
    request
}

/// The text with the keys that were found in the place of what was asked.
fn text_of<C: Computation>(own: &str, keys: &[(String, String)]) -> Option<String> {
    let edits: Vec<(&str, &str)> = keys
        .iter()
        .map(|(key, value)| (key.as_str(), value.as_str()))
        .collect();
    let (mut text, _) = edit::put_all(C::schema(), own, &edits).ok()?;
    for key in ASKED {
        text = edit::cut(&text, key).unwrap_or(text);
    }
    Some(text)
}

pub(super) fn assemble<C: Computation>(
    request: &Request<C>,
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
            happened: computed.happened,
            settings: computed.settings,
            work: computed.outcome.work,
            cost: computed.cost,
            ..request.initial_info()
        },
        case_text: request.stored_text().into_owned(),
        history,
        shapes,
        profiles,
        summary,
        fatigue,
    };
    refuse_not_finite(&mut run);
    run
}
