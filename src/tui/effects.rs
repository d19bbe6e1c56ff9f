//! Files and threads: does what the effects ask for, and answers with messages.

mod open;
mod runs;
mod trial_worker;

use std::collections::HashMap;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use crossbeam_channel::{Receiver, Sender, bounded, unbounded};

use self::open::read_case;
use self::runs::{delete_run, keep_run, list_runs};
use self::trial_worker::compute_trials;
use super::case_library;
use super::files::{save_case, write_text};
use super::msg::{Effect, Msg};
use super::recovery;
use super::state::modes::COUNT;
use super::state::trials::TrialsOf;
use super::state::{JobNumber, RunCurves, Severity};
use crate::case;
use crate::modes;
use crate::run::job::{self, Job, JobEvent, JobId, Request};
use crate::run::store::{self, RunLocation, RunWriter};
use crate::run::{ResumedRun, resume_request};
use crate::ship::DynamicAnalysis;

/// What is outside of the state.
#[derive(Debug)]
pub struct EffectRunner {
    dir: PathBuf,
    sender: Sender<Msg>,
    receiver: Receiver<Msg>,
    jobs: HashMap<JobNumber, RunningJob>,
    /// The trials that compute, and the flag that stops them.
    trials: Option<(JobNumber, Arc<AtomicBool>)>,
    /// Threads that read or work something out aside.
    aside: Arc<AtomicUsize>,
}

/// A running job, and what it has recorded since the screen last asked. However long the screen takes, that stays within
/// bounds.
#[derive(Debug)]
struct RunningJob {
    job: Job,
    fresh: Arc<Mutex<RunCurves>>,
}

/// How many of its events a job may be ahead of the thread that stores them.
const AHEAD: usize = 256;

impl EffectRunner {
    /// A world that lists the cases of a directory.
    #[must_use]
    pub fn new(dir: PathBuf) -> Self {
        let (sender, receiver) = unbounded();
        Self {
            dir,
            sender,
            receiver,
            jobs: HashMap::new(),
            trials: None,
            aside: Arc::default(),
        }
    }

    /// Where other threads send what happened.
    #[must_use]
    pub fn sender(&self) -> Sender<Msg> {
        self.sender.clone()
    }

    /// What jobs said since the last call.
    pub fn poll(&mut self) -> Vec<Msg> {
        // Taken first: what a job said before it recorded anything is then in the channel.
        let fresh = self.jobs.iter().filter_map(|(ticket, going)| {
            let mut curves = going.fresh.lock().unwrap_or_else(PoisonError::into_inner);
            Some(Msg::Recorded(*ticket, Box::new(curves.take()?)))
        });
        let fresh: Vec<Msg> = fresh.collect();
        let mut heard: Vec<Msg> = self.receiver.try_iter().collect();
        for msg in &heard {
            let ended = match msg {
                Msg::Job(ticket, event) if matches!(**event, JobEvent::Finished(_)) => Some(ticket),
                Msg::JobFailed(ticket, _) => Some(ticket),
                _ => None,
            };
            if let Some(ticket) = ended {
                self.jobs.remove(ticket);
            }
        }
        heard.extend(fresh);
        heard
    }

    /// True while another thread may still say something.
    #[must_use]
    pub fn busy(&self) -> bool {
        !self.jobs.is_empty() || self.aside.load(Ordering::SeqCst) > 0 || !self.receiver.is_empty()
    }

    /// Does something on a thread of its own, so that the screen does not wait for it.
    fn aside(&self, work: impl FnOnce() -> Msg + Send + 'static) -> Vec<Msg> {
        let (out, count) = (self.sender.clone(), Arc::clone(&self.aside));
        count.fetch_add(1, Ordering::SeqCst);
        let started = std::thread::Builder::new().spawn(move || {
            drop(out.send(work()));
            count.fetch_sub(1, Ordering::SeqCst);
        });
        match started {
            Ok(_) => Vec::new(),
            Err(error) => {
                self.aside.fetch_sub(1, Ordering::SeqCst);
                let words = format!("The system gives no thread: {error}.");
                vec![Msg::Say(Severity::Error, words)]
            }
        }
    }

    /// Does what the effect asks for. Effects of the terminal itself are not for here.
    pub fn perform(&mut self, effect: Effect) -> Vec<Msg> {
        match effect {
            Effect::Start {
                ticket,
                request,
                from,
                store,
            } => self.start(ticket, *request, from.map(|from| *from), store),
            Effect::StartTrials { ticket, of } => self.start_trials(ticket, of),
            Effect::Cancel(ticket) => self.cancel(ticket),
            Effect::FindModes { case, text } => self.aside(move || {
                let found = modes::of_case(&case, COUNT);
                Msg::Modes(text, found.map(Arc::new).map_err(|why| why.to_string()))
            }),
            Effect::ComputeShip(rest, folder, stop) => self.aside(move || {
                // It always answers; the panic hook reports a fault of it.
                let work = AssertUnwindSafe(|| DynamicAnalysis::new(&rest, &folder, &stop));
                let sea = catch_unwind(work).ok().flatten().map(Arc::new);
                Msg::ShipComputed(stop, sea)
            }),
            Effect::ReadRun(dir) => self.aside(move || {
                let run = store::read(&dir).map(Arc::new).map_err(|e| e.to_string());
                Msg::RunRead(dir, run)
            }),
            effect => self.files(effect),
        }
    }

    /// Effects that read or write files and answer at once.
    fn files(&self, effect: Effect) -> Vec<Msg> {
        let answer = match effect {
            Effect::ReadCases => Msg::CasesRead(self.dir.clone(), case_library::list(&self.dir)),
            Effect::ReadCase(path) => read_case(&path),
            Effect::SaveCase {
                path,
                text,
                expected,
                new,
            } => save_case(path, text, expected.as_deref(), new),
            Effect::KeepRecovery { path, text } => {
                let kept = recovery::store(&path, text.as_deref());
                return warning(kept, "The unsaved changes cannot be kept for recovery");
            }
            Effect::DropRecovery(path) => {
                let dropped = recovery::discard(&path);
                return warning(dropped, "The kept changes cannot be dropped");
            }
            Effect::RememberGlyphs(glyphs) => {
                let kept = recovery::remember_glyphs(glyphs);
                return warning(kept, "The choice cannot be remembered");
            }
            Effect::PrepareResume(dir, until) => {
                let found = resume_request(&dir, Some(until)).map(Box::new);
                Msg::ResumeReady(dir, until, found)
            }
            Effect::ListRuns(files) => Msg::RunsListed(list_runs(&files)),
            Effect::DeleteRun(dir) => delete_run(dir),
            Effect::KeepRun(run) => keep_run(run),
            Effect::WriteText { path, text, what } => write_text(&path, &text, what),
            _ => return Vec::new(),
        };
        vec![answer]
    }

    fn cancel(&self, ticket: JobNumber) -> Vec<Msg> {
        if let Some((_, cancel)) = self.trials.as_ref().filter(|(t, _)| *t == ticket) {
            cancel.store(true, Ordering::Relaxed);
        }
        if let Some(running) = self.jobs.get(&ticket) {
            running.job.cancel();
        }
        Vec::new()
    }

    fn start_trials(&mut self, ticket: JobNumber, of: TrialsOf) -> Vec<Msg> {
        let cancel = Arc::new(AtomicBool::new(false));
        self.trials = Some((ticket, Arc::clone(&cancel)));
        let out = self.sender.clone();
        self.aside(move || compute_trials(ticket, of, &cancel, &out))
    }

    /// Starts a job, and a thread that passes on what it says; the same thread stores the run, so
    /// that a slow disk never holds the screen up.
    fn start(
        &mut self,
        ticket: JobNumber,
        request: Request,
        from: Option<ResumedRun>,
        store: bool,
    ) -> Vec<Msg> {
        let writer = match store.then(|| begin(&request)).transpose() {
            Ok(writer) => writer,
            Err(error) => return vec![Msg::JobFailed(ticket, error.to_string())],
        };
        let mut messages = Vec::new();
        if let Some(writer) = &writer {
            messages.push(Msg::Stored(ticket, writer.dir().to_owned()));
        }
        let (events, said) = bounded(AHEAD);
        let started = job::start(request, from, events).and_then(|job| {
            let fresh = Arc::new(Mutex::new(RunCurves::default()));
            let (out, record) = (self.sender.clone(), Arc::clone(&fresh));
            std::thread::Builder::new()
                .name(format!("relay-{ticket}"))
                .spawn(move || relay(ticket, &said, writer, &record, &out))?;
            Ok(RunningJob { job, fresh })
        });
        match started {
            Ok(going) => {
                self.jobs.insert(ticket, going);
            }
            Err(error) => messages.push(Msg::JobFailed(
                ticket,
                format!("The system gives no thread for the run: {error}."),
            )),
        }
        messages
    }
}

fn warning(result: io::Result<()>, what: &str) -> Vec<Msg> {
    result
        .err()
        .map(|error| Msg::Say(Severity::Warning, format!("{what}: {error}.")))
        .into_iter()
        .collect()
}

/// Passes on the events of a job; returns after the last, or when nothing receives them.
fn relay(
    ticket: JobNumber,
    said: &Receiver<(JobId, JobEvent)>,
    mut writer: Option<RunWriter>,
    record: &Mutex<RunCurves>,
    out: &Sender<Msg>,
) {
    let mut complaint = None;
    for (_, event) in said {
        let mut event = event;
        let last = matches!(event, JobEvent::Finished(_));
        if let JobEvent::Finished(run) = &mut event {
            if let Some(writer) = writer.take() {
                writer.id().clone_into(&mut run.info.id);
                complaint = complaint.or(writer.finish(run).err());
            }
        } else if let Some(open) = &mut writer
            && let Err(error) = open.event(&event)
        {
            // The run continues in memory; its directory stays marked as partial.
            complaint = Some(error);
            writer = None;
        }
        if let Some(error) = complaint.take() {
            let words = format!("The run cannot be stored: {error}");
            drop(out.send(Msg::Say(Severity::Error, words)));
        }
        let recorded = || record.lock().unwrap_or_else(PoisonError::into_inner);
        match event {
            JobEvent::Frame(frame) => recorded().push(*frame),
            JobEvent::Checkpoint(_) => {}
            event => {
                if let JobEvent::Started { channels } = &event {
                    recorded().begin(channels.clone());
                }
                if out.send(Msg::Job(ticket, Box::new(event))).is_err() || last {
                    return;
                }
            }
        }
    }
    let words = "The run ended without a result; this is a fault of seacable.".to_owned();
    drop(out.send(Msg::JobFailed(ticket, words)));
}

fn begin(request: &Request) -> Result<RunWriter, store::StoreError> {
    RunWriter::begin(
        &RunLocation::Below(PathBuf::from(store::DEFAULT_ROOT)),
        request.initial_info(),
        &case::stand_alone(&request.text, &request.case),
    )
}
