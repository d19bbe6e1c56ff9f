//! A case computed: on the caller's thread by [`execute`], on its own by [`start`]. Events out, a
//! cancel flag in. Whoever listens decides whether a solver may get ahead of it: a bounded channel makes it wait, a receiver
//! that is gone never does.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::SystemTime;

use crossbeam_channel::Sender;

use super::compute::{self, Computed};
use super::store::rfc3339;
use super::{
    Checkpoint, Cost, Frame, Resume, Run, RunInfo, RunState, Settings, VERSION, Work,
    error_estimate, limits, settings,
};
use crate::case::{Case, ChannelId, Method, stand_alone};
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
    /// What `run.toml` says while the run goes on.
    #[must_use]
    pub fn beginning(&self) -> RunInfo {
        RunInfo {
            id: self.id.clone(),
            title: self.case.case.title.clone(),
            case_file: self.file.clone(),
            state: RunState::Partial,
            version: VERSION.to_owned(),
            started: rfc3339(SystemTime::now()),
            overrides: self.overrides.clone(),
            failure: None,
            warnings: Vec::new(),
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

/// What a job says while it goes on.
#[derive(Debug, Clone, PartialEq)]
pub enum Event {
    /// The scene stands; these channels will be filled.
    Started {
        /// In the order of [`Frame::values`].
        channels: Vec<ChannelId>,
    },
    /// An output instant.
    Frame(Box<Frame>),
    /// The run as it stands, to go on from later.
    Checkpoint(Box<Checkpoint>),
    /// The run is complete; companions now estimate its errors.
    Estimating,
    /// The end, whatever it was: see [`RunInfo::state`].
    Finished(Box<Run>),
}

/// Names a job among all of this process.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct JobId(pub u64);

/// A job going on. Dropping it does not stop it.
#[derive(Debug, Clone)]
pub struct Job {
    /// Its name.
    pub id: JobId,
    cancel: Arc<AtomicBool>,
}

impl Job {
    /// Asks the job to stop after the step it is at.
    pub fn cancel(&self) {
        self.cancel.store(true, Ordering::Relaxed);
    }
}

/// Starts a thread that computes the request, going on from where an earlier run stands if there is one, and sends its
/// events, named with the job. The last one is always
/// [`Event::Finished`].
///
/// # Errors
/// When the system gives no thread.
pub fn start(
    request: Request,
    from: Option<Resume>,
    events: Sender<(JobId, Event)>,
) -> std::io::Result<Job> {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    let id = JobId(NEXT.fetch_add(1, Ordering::Relaxed));
    let cancel = Arc::new(AtomicBool::new(false));
    let job = Job {
        id,
        cancel: Arc::clone(&cancel),
    };
    std::thread::Builder::new()
        .name(format!("job-{}", id.0))
        .spawn(move || {
            // A channel that nobody listens to any more is no reason to stop early.
            let mut tell = |event| drop(events.send((id, event)));
            let run = execute_from(&request, from.as_ref(), &cancel, &mut tell);
            tell(Event::Finished(Box::new(run)));
        })?;
    Ok(job)
}

/// Computes a request, with its companions if the case asks for error estimates. Failures are told in the run,
/// which keeps what there was. Does not send [`Event::Finished`]: the run is returned.
pub fn execute(request: &Request, cancel: &AtomicBool, events: &mut dyn FnMut(Event)) -> Run {
    execute_from(request, None, cancel, events)
}

/// As [`execute`], going on from where an earlier run stands, if there is one.
pub fn execute_from(
    request: &Request,
    from: Option<&Resume>,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(Event),
) -> Run {
    let started = rfc3339(SystemTime::now());
    let (chosen, reason) = chosen(request);
    let request = chosen.as_ref().unwrap_or(request);
    let mut computed = compute::compute_from(&request.case, from, cancel, events);
    computed.settings.method_reason = reason;
    let done = computed.state == RunState::Done;
    let companions = std::time::Instant::now();
    let mut estimated = error_estimate::Estimates::default();
    if done && request.case.solver.error_estimate {
        events(Event::Estimating);
        estimated = error_estimate::estimate(&request.case, &computed, cancel);
    }
    computed.settings.error_method = estimated.method.clone();
    computed.profile.rms_error = std::mem::take(&mut estimated.rms);
    let checks = limits::check(&request.case, &computed.profile);
    let exceeded = checks.iter().flat_map(limits::LimitCheck::warnings);
    computed.warnings.extend(exceeded);
    let cost = Cost {
        companions_wall_s: companions.elapsed().as_secs_f64(),
        ..computed.cost
    };
    let summary = error_estimate::summary(&computed, &estimated);
    assemble(
        request,
        computed,
        started,
        cost,
        estimated.warnings,
        summary,
    )
}

/// The request with a method in place of the choice that its case leaves open, and why that one.
fn chosen(request: &Request) -> (Option<Request>, Option<String>) {
    if request.case.solver.method != Method::Auto {
        return (None, None);
    }
    let mut request = request.clone();
    request.case.solver.method = Method::Alpha;
    // A case that makes no scene fails with its reason a little later.
    let Ok(scene) = scene::build(&request.case, 1) else {
        return (Some(request), None);
    };
    let (method, why) = settings::choose(&request.case, &scene);
    request.case.solver.method = method;
    (Some(request), Some(why))
}

fn assemble(
    request: &Request,
    computed: Computed,
    started: String,
    cost: Cost,
    warnings: Vec<String>,
    summary: Vec<super::Quantity>,
) -> Run {
    let info = RunInfo {
        id: request.id.clone(),
        title: request.case.case.title.clone(),
        case_file: request.file.clone(),
        state: computed.state,
        version: VERSION.to_owned(),
        started,
        overrides: request.overrides.clone(),
        failure: computed.failure,
        warnings: computed.warnings.into_iter().chain(warnings).collect(),
        settings: computed.settings,
        work: computed.work,
        cost,
    };
    Run {
        info,
        case_text: stand_alone(&request.text, &request.case).into_owned(),
        history: computed.history,
        shapes: computed.shapes,
        profile: computed.profile,
        summary,
    }
}
