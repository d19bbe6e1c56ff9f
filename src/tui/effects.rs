//! Files and threads: does what the effects ask for, and answers with messages.

mod file_watch;
mod index_worker;
mod job_processes;
mod open;
mod ordered_worker;
pub mod outbox;
mod pages;
mod runs;
mod sweep_worker;
mod trial_worker;

use std::collections::HashMap;
use std::io;
use std::os::fd::BorrowedFd;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use crossbeam_channel::{Receiver, bounded};

use self::file_watch::FileWatch;
use self::index_worker::{IndexQuestion, IndexWorker};
use self::job_processes::JobProcesses;
use self::open::read_case;
use self::ordered_worker::OrderedWorker;
use self::outbox::{Inbox, Outbox};
use self::runs::{delete_runs, keep_run, read_run_case, write_notes};
use self::sweep_worker::SweepWorker;
use self::trial_worker::compute_trials;
use super::files::{save_case, write_text};
use super::msg::{Effect, Msg};
use super::recovery::{self, RecoveredEdits};
use super::screen_memory::file;
use super::settings::UserSettings;
use super::state::edit_check::{EditAnswer, EditCheck};
use super::state::part_request::PartRequest;
use super::state::parts::{PartView, ScreenPart};
use super::state::report::ReportRequest;
use super::state::study_request::StudyRequest;
use super::state::sweep_request::SweepMsg;
use super::state::trials::TrialsOf;
use super::state::value_check::ValueCheck;
use super::state::{JobNumber, JobRequest, RunCurves, Severity, VariantPlan, VariedRuns};
use super::{case_library, external_editor};
use crate::background::lower_priority;
use crate::run::coarse;
use crate::run::job::{self, JobEvent, Request};
use crate::run::store::{self, RunLocation, RunWriter, StoreError};
use crate::table::Table;

/// What is outside of the state.
#[derive(Debug)]
pub struct EffectRunner {
    dir: PathBuf,
    out: Outbox,
    inbox: Inbox,
    files: OrderedWorker,
    /// What the next session is to find; no key waits for it.
    memory: OrderedWorker,
    checks: OrderedWorker,
    /// Views of models, which do not wait for their tables.
    drawings: OrderedWorker,
    tables: OrderedWorker,
    runs: IndexWorker,
    sweeps: SweepWorker,
    watch: FileWatch,
    jobs: HashMap<JobNumber, RunningJob>,
    /// Jobs that are processes of their own; nothing where all are computed here.
    processes: Option<JobProcesses>,
    /// The trials that compute, and the flag that stops them.
    trials: Option<(JobNumber, Arc<AtomicBool>)>,
}

/// A running job, and what it has recorded since the screen last asked. However long the screen takes, that stays within
/// bounds.
#[derive(Debug)]
struct RunningJob {
    cancel: Arc<AtomicBool>,
    fresh: Arc<Mutex<RunCurves>>,
}

/// How many of its events a job may be ahead of the thread that stores them.
const AHEAD: usize = 256;

impl EffectRunner {
    /// A world that lists the cases of a directory.
    ///
    /// # Errors
    /// The system gives no socket.
    pub fn new(dir: PathBuf) -> io::Result<Self> {
        let (out, inbox) = Inbox::new()?;
        Ok(Self {
            dir,
            files: OrderedWorker::start("files", out.clone()),
            memory: OrderedWorker::start("memory", out.clone()),
            checks: OrderedWorker::start("checks", out.clone()),
            drawings: OrderedWorker::start("drawings", out.clone()),
            tables: OrderedWorker::start("tables", out.clone()),
            runs: IndexWorker::default(),
            sweeps: SweepWorker::new(out.clone()),
            watch: FileWatch::start(out.clone()),
            out,
            inbox,
            jobs: HashMap::new(),
            processes: None,
            trials: None,
        })
    }

    /// From now on stored runs and load cases may be computed by processes of their own, and those of earlier screens are found.
    ///
    /// # Errors
    /// Why they cannot, in words.
    pub fn use_processes(&mut self) -> Result<(), String> {
        self.processes = Some(JobProcesses::start(&self.out)?);
        Ok(())
    }

    /// Where other threads send what happened.
    #[must_use]
    pub fn outbox(&self) -> Outbox {
        self.out.clone()
    }

    /// Readable when another thread has said something.
    #[must_use]
    pub fn fd(&self) -> BorrowedFd<'_> {
        self.inbox.fd()
    }

    /// For how long files have been read or written without a pause; nothing when all is done.
    #[must_use]
    pub fn files_busy_for(&self) -> Option<Duration> {
        self.files.busy_for()
    }

    /// Waits until all files are read and written that were asked for, or the time is up.
    pub fn finish(&self, limit: Duration) {
        self.files.finish(limit);
        self.memory.finish(limit);
        if let Some(processes) = &self.processes {
            processes.finish(limit);
        }
    }

    /// What jobs said since the last call.
    pub fn poll(&mut self) -> Vec<Msg> {
        // Taken first: what a job said before it recorded anything is then in the channel.
        let fresh = self.jobs.iter().filter_map(|(ticket, going)| {
            let mut curves = going.fresh.lock().unwrap_or_else(PoisonError::into_inner);
            Some(Msg::Recorded(*ticket, Box::new(curves.take()?)))
        });
        let mut fresh: Vec<Msg> = fresh.collect();
        let processes = self.processes.as_ref();
        fresh.extend(processes.map(JobProcesses::recorded).unwrap_or_default());
        let mut heard = self.inbox.take();
        for msg in &heard {
            let ended = match msg {
                Msg::Job(ticket, event) if matches!(**event, JobEvent::Finished(_)) => Some(ticket),
                Msg::JobFailed(ticket, _) => Some(ticket),
                Msg::Sweep(SweepMsg::Ended(ticket, _)) => {
                    self.sweeps.forget(*ticket);
                    None
                }
                _ => None,
            };
            if let Some(ticket) = ended {
                self.jobs.remove(ticket);
            }
        }
        heard.extend(fresh);
        heard
    }

    /// True while a job records curves, which are asked for.
    #[must_use]
    pub fn recording(&self) -> bool {
        !self.jobs.is_empty()
    }

    /// Does something on a thread of its own, so that the screen does not wait for it.
    fn aside(&self, work: impl FnOnce() -> Msg + Send + 'static) -> Vec<Msg> {
        let out = self.out.clone();
        let started = std::thread::Builder::new().spawn(move || {
            lower_priority();
            out.send(work());
        });
        started.err().map_or_else(Vec::new, |error| {
            let words = format!("The system gives no thread: {error}.");
            vec![Msg::Say(Severity::Error, words)]
        })
    }

    /// Does what the effect asks for. Effects of the terminal itself are not for here.
    pub fn perform(&mut self, effect: Effect) -> Vec<Msg> {
        match effect {
            Effect::Start {
                ticket,
                request,
                store,
            } => self.start(ticket, request, store),
            Effect::StartTrials { ticket, of } => self.start_trials(ticket, of),
            Effect::Cancel(ticket) => self.cancel(ticket),
            Effect::Process(effect) => {
                let processes = self.processes.as_ref();
                processes.map_or_else(Vec::new, |processes| processes.perform(effect))
            }
            Effect::MakePart(request) => match request.key.part {
                ScreenPart::Drawing => self.drawings.perform(move || vec![make_part(*request)]),
                _ => self.tables.perform(move || vec![make_part(*request)]),
            },
            Effect::CheckValues(check) => self.tables.perform(move || vec![check_values(*check)]),
            Effect::Watch(path) => {
                self.watch.watch(path);
                Vec::new()
            }
            Effect::Sweep(effect) => self.sweeps.perform(effect),
            Effect::ListRuns { files, results } => self
                .runs
                .ask(IndexQuestion::List { files, results }, &self.out),
            Effect::RefreshRuns => self.runs.ask(IndexQuestion::Refresh, &self.out),
            Effect::CheckEdits(check) => self.checks.perform(move || vec![check_edits(*check)]),
            Effect::KeepScreen(directory, memory) => self.memory.perform(move || {
                let kept = file::keep_screen(&directory, &memory);
                warning(kept, "The state of the screen cannot be kept")
            }),
            Effect::KeepSession(session) => self.memory.perform(move || {
                let kept = file::keep_session(&session);
                warning(kept, "The lines of commands cannot be kept")
            }),
            effect => self.compute(effect),
        }
    }

    /// Effects that compute something behind the screen, each on a thread of its own.
    fn compute(&self, effect: Effect) -> Vec<Msg> {
        match effect {
            Effect::FindModes { of, text } => self.aside(move || Msg::Modes(text, of.find())),
            Effect::ComputeShip(ship) => self.aside(move || {
                // It always answers; the panic hook reports a fault of it.
                let computed = catch_unwind(AssertUnwindSafe(|| ship.computed()));
                Msg::ShipComputed(ship.stop, computed.ok().flatten())
            }),
            Effect::ReadRun(dir) => self.aside(move || {
                let run = store::read(&dir).map(Arc::new).map_err(|e| e.to_string());
                Msg::RunRead(dir, run)
            }),
            Effect::Plan { case, text, file } => {
                self.aside(move || Msg::Planned(Box::new(VariantPlan::new(&text, &case, &file))))
            }
            Effect::Vary(path, variation) => {
                self.aside(move || Msg::Varied(Box::new(VariedRuns::new(path, &variation))))
            }
            Effect::Compare {
                runs,
                width,
                glyphs,
                name,
            } => self.aside(move || Msg::Page(name, pages::compare(runs, width, glyphs), false)),
            Effect::Study(request, cancel) => self.study(*request, cancel),
            Effect::MakeReport(request) => self.aside(move || make_report(*request)),
            effect => self.files(effect),
        }
    }

    /// Effects that read or write files.
    fn files(&self, effect: Effect) -> Vec<Msg> {
        let dir = self.dir.clone();
        self.files.perform(move || file_effect(effect, &dir))
    }

    /// Computes a study behind the screen; one that is stopped answers nothing.
    fn study(&self, request: StudyRequest, cancel: Arc<AtomicBool>) -> Vec<Msg> {
        let out = self.out.clone();
        let started = std::thread::Builder::new().spawn(move || {
            lower_priority();
            if let Some(page) = pages::study(&request, &cancel, &out) {
                out.send(Msg::Page(request.of.title(&request.result), page, true));
            }
        });
        let failed = started
            .err()
            .map(|error| Msg::Say(Severity::Error, no_thread(&error)));
        failed.into_iter().collect()
    }

    fn cancel(&self, ticket: JobNumber) -> Vec<Msg> {
        if let Some((_, cancel)) = self.trials.as_ref().filter(|(t, _)| *t == ticket) {
            cancel.store(true, Ordering::Relaxed);
        }
        self.sweeps.cancel(ticket);
        if let Some(running) = self.jobs.get(&ticket) {
            running.cancel.store(true, Ordering::Relaxed);
        }
        let processes = self.processes.as_ref();
        processes.map_or_else(Vec::new, |processes| processes.cancel(ticket))
    }

    fn start_trials(&mut self, ticket: JobNumber, of: TrialsOf) -> Vec<Msg> {
        let cancel = Arc::new(AtomicBool::new(false));
        self.trials = Some((ticket, Arc::clone(&cancel)));
        let out = self.out.clone();
        self.aside(move || compute_trials(ticket, of, &cancel, &out))
    }

    /// Starts a job, and a thread that stores its run and passes on what it says, so that a slow disk never holds the screen
    /// up.
    fn start(&mut self, ticket: JobNumber, request: JobRequest, store: bool) -> Vec<Msg> {
        let (cancel, fresh): (Arc<AtomicBool>, Arc<Mutex<RunCurves>>) = Default::default();
        let going = RunningJob {
            cancel: Arc::clone(&cancel),
            fresh: Arc::clone(&fresh),
        };
        let out = self.out.clone();
        let started = std::thread::Builder::new()
            .name(format!("relay-{ticket}"))
            .spawn(move || {
                if let Err(why) = compute(ticket, request, store, cancel, &fresh, &out) {
                    out.send(Msg::JobFailed(ticket, why));
                }
            });
        match started {
            Ok(_) => {
                self.jobs.insert(ticket, going);
                Vec::new()
            }
            Err(error) => vec![Msg::JobFailed(ticket, no_thread(&error))],
        }
    }
}

fn no_thread(error: &io::Error) -> String {
    format!("The system gives no thread for the run: {error}.")
}

/// Makes the directory of a run that is stored, starts its job, and passes on its events.
fn compute(
    ticket: JobNumber,
    request: JobRequest,
    store: bool,
    cancel: Arc<AtomicBool>,
    fresh: &Mutex<RunCurves>,
    out: &Outbox,
) -> Result<(), String> {
    let writer = store.then(|| begin(&request)).transpose();
    let writer = writer.map_err(|error| error.to_string())?;
    if let Some(writer) = &writer {
        out.send(Msg::Stored(ticket, writer.dir().to_owned()));
    }
    if let (JobRequest::Line(request, _), false) = (&request, store) {
        answer_coarsely(ticket, request, &cancel, out);
    }
    let (events, said) = bounded(AHEAD);
    let id = request.initial_info().id;
    job::start(&id, events, move |events| request.execute(&cancel, events))
        .map_err(|error| no_thread(&error))?;
    relay(ticket, &said, writer, fresh, out)
}

/// Time of the coarse answer from which it is shown: the full one takes some thirty times as long.
const WORTH_SHOWING: Duration = Duration::from_millis(3);

/// Computes a live solve coarsely first, and shows that where the full answer takes more than a blink.
fn answer_coarsely(ticket: JobNumber, request: &Request, cancel: &AtomicBool, out: &Outbox) {
    lower_priority();
    let began = Instant::now();
    let run = catch_unwind(AssertUnwindSafe(|| coarse(request, cancel)));
    if let Ok(Some(run)) = run
        && began.elapsed() > WORTH_SHOWING
    {
        out.send(Msg::Coarse(ticket, Arc::new(run)));
    }
}

/// Applies edits. It always answers; the panic hook reports a fault of it.
fn check_edits(check: EditCheck) -> Msg {
    let number = check.number;
    let answer = catch_unwind(AssertUnwindSafe(|| check.answer()));
    let answer = answer.unwrap_or_else(|_| EditAnswer::of_fault(number));
    Msg::EditsChecked(Box::new(answer))
}

/// Works a part of the screen out. It always answers; the panic hook reports a fault of it.
fn make_part(request: PartRequest) -> Msg {
    let view = catch_unwind(AssertUnwindSafe(|| request.view()));
    let fault = |_| PartView {
        table: Table::titled("This could not be worked out by a fault of seacable."),
        ..PartView::default()
    };
    let view = Arc::new(view.unwrap_or_else(fault));
    Msg::PartMade(Box::new(request.key), view)
}

/// Compares runs with published values. It always answers; the panic hook reports a fault of it.
fn check_values(check: ValueCheck) -> Msg {
    let table = catch_unwind(AssertUnwindSafe(|| check.table()));
    Msg::ValuesChecked(check.token, Box::new(table.unwrap_or_default()))
}

/// Makes a report. It always answers; the panic hook reports a fault of it.
fn make_report(request: ReportRequest) -> Msg {
    let text = catch_unwind(AssertUnwindSafe(|| request.text()));
    let text = text.unwrap_or_else(|_| "The report failed by a fault of seacable.".to_owned());
    Msg::Report(Box::new(request), text)
}

/// Reads or writes files as an effect asks for.
fn file_effect(effect: Effect, dir: &Path) -> Vec<Msg> {
    let answer = match effect {
        Effect::ReadCases => Msg::CasesRead(dir.to_owned(), case_library::list(dir)),
        Effect::ReadCase(path) => read_case(&path),
        Effect::SaveCase {
            path,
            text,
            expected,
            new,
        } => save_case(path, text, expected.as_deref(), new),
        Effect::NewFile { path, text } => match super::files::write_new(&path, &text) {
            Ok(()) => read_case(&path),
            Err(why) => Msg::NotMade(why),
        },
        Effect::KeepRecovery { path, text, kept } => {
            let edits = text.map(|text| RecoveredEdits { text, kept });
            let kept = recovery::store(&path, edits.as_ref());
            return warning(kept, "The unsaved changes cannot be kept for recovery");
        }
        Effect::TakeOverRecovery { path, text, kept } => {
            let edits = text.map(|text| RecoveredEdits { text, kept });
            let kept = recovery::take_over(&path, edits.as_ref());
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
            let found = JobRequest::resumed(&dir, until);
            Msg::ResumeReady(dir, until, found)
        }
        Effect::DeleteRuns(dirs) => return delete_runs(dirs),
        Effect::WriteNotes(dir, notes) => return write_notes(&dir, &notes),
        Effect::ReadRunCase {
            dir,
            wanted,
            beside,
        } => read_run_case(dir, wanted, &beside),
        Effect::ReadEdited(path) => Msg::Edited(external_editor::read(&path)),
        Effect::ReadSettings => Msg::SettingsRead(Box::new(UserSettings::load())),
        Effect::KeepRun(run) => keep_run(run),
        Effect::WriteText { path, text, what } => write_text(&path, &text, what),
        Effect::WriteMade(request) => match request.text() {
            (path, Some(text), what) => write_text(&path, &text, what),
            _ => Msg::Say(Severity::Info, "There is nothing to write.".to_owned()),
        },
        _ => return Vec::new(),
    };
    vec![answer]
}

fn warning(result: io::Result<()>, what: &str) -> Vec<Msg> {
    result
        .err()
        .map(|error| Msg::Say(Severity::Warning, format!("{what}: {error}.")))
        .into_iter()
        .collect()
}

/// Passes on the events of a job; returns after the last.
fn relay(
    ticket: JobNumber,
    said: &Receiver<JobEvent>,
    mut writer: Option<RunWriter>,
    record: &Mutex<RunCurves>,
    out: &Outbox,
) -> Result<(), String> {
    let mut given_up: Option<(RunWriter, StoreError)> = None;
    let mut not_stored = None;
    let complain = |words: String| out.send(Msg::Say(Severity::Error, words));
    for mut event in said {
        let last = matches!(event, JobEvent::Finished(_));
        if let JobEvent::Finished(run) = &mut event {
            if let Some(writer) = writer.take() {
                writer.id().clone_into(&mut run.info.id);
                not_stored = writer.finish(run).err().map(|error| error.to_string());
            } else if let Some((writer, error)) = given_up.take() {
                writer.give_up(&run.info, &error);
                not_stored = Some(error.to_string());
            }
        } else if let Some(mut open) = writer.take() {
            match open.event(&event) {
                Ok(()) => writer = Some(open),
                Err(error) => {
                    // The run continues in memory.
                    complain(format!("The run cannot be stored: {error}"));
                    given_up = Some((open, error));
                }
            }
        }
        let recorded = || record.lock().unwrap_or_else(PoisonError::into_inner);
        match event {
            JobEvent::Frame(frame) => recorded().push(&frame),
            JobEvent::Case(_) | JobEvent::Checkpoint(_) => {}
            event => {
                if let JobEvent::Started { channels, .. } = &event {
                    recorded().begin(channels.clone());
                }
                out.send(Msg::Job(ticket, Box::new(event)));
                if last {
                    // After the word that it is done, which it would be taken for.
                    if let Some(why) = not_stored {
                        complain(format!(
                            "The run is shown until the program ends, but not stored: {why}"
                        ));
                    }
                    return Ok(());
                }
            }
        }
    }
    Err("The run ended without a result; this is a fault of seacable.".to_owned())
}

fn begin(request: &JobRequest) -> Result<RunWriter, StoreError> {
    RunWriter::begin(
        &RunLocation::Below(PathBuf::from(store::DEFAULT_ROOT)),
        request.initial_info(),
        &request.stored_text(),
    )
}
