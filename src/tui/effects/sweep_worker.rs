//! Sweeps: read and judged by a thread of their own, computed by one for each, at lower priority than the screen.

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::ordered_worker::OrderedWorker;
use super::outbox::Outbox;
use crate::background::lower_priority;
use crate::report::sweep::SweepReport;
use crate::run::store;
use crate::study::sweep::slurm::SlurmFile;
use crate::study::sweep::{
    SweepFolder, SweepOutcomes, SweepPlan, SweepProgress, SweepSnapshot, stored_sweeps,
};
use crate::tui::msg::Msg;
use crate::tui::state::JobNumber;
use crate::tui::state::sweep_request::{SweepEffect, SweepMsg, SweepRequest};
use crate::tui::state::sweep_verdict::SweepVerdict;
use crate::tui::state::sweeps::SweepRead;
use crate::visible;

/// How often a sweep says how far it is, at most.
const TELL: Duration = Duration::from_millis(200);

/// Why there is no answer after a panic.
const FAULT: &str = "This failed by a fault of seacable.";

/// The threads.
#[derive(Debug)]
pub(super) struct SweepWorker {
    reader: OrderedWorker,
    /// Records take longer to read than results, which do not wait for them.
    judge: OrderedWorker,
    out: Outbox,
    /// The flags that stop what is computed.
    jobs: HashMap<JobNumber, Arc<AtomicBool>>,
}

impl SweepWorker {
    pub(super) fn new(out: Outbox) -> Self {
        Self {
            reader: OrderedWorker::start("sweeps", out.clone()),
            judge: OrderedWorker::start("verdicts", out.clone()),
            out,
            jobs: HashMap::new(),
        }
    }

    /// Does what is asked for; answers come as messages.
    pub(super) fn perform(&mut self, effect: SweepEffect) -> Vec<Msg> {
        match effect {
            SweepEffect::Start(ticket, request) => self.start(ticket, *request),
            effect @ (SweepEffect::Check(_) | SweepEffect::Compare(..)) => {
                self.judge.perform(|| answered(effect))
            }
            effect => self.reader.perform(|| answered(effect)),
        }
    }

    /// Stops a sweep; what is done of it stays.
    pub(super) fn cancel(&self, ticket: JobNumber) {
        if let Some(cancel) = self.jobs.get(&ticket) {
            cancel.store(true, Ordering::Relaxed);
        }
    }

    /// A sweep has ended.
    pub(super) fn forget(&mut self, ticket: JobNumber) {
        self.jobs.remove(&ticket);
    }

    fn start(&mut self, ticket: JobNumber, request: SweepRequest) -> Vec<Msg> {
        let (cancel, out) = (Arc::new(AtomicBool::new(false)), self.out.clone());
        self.jobs.insert(ticket, Arc::clone(&cancel));
        let started = std::thread::Builder::new()
            .name(format!("sweep-{ticket}"))
            .spawn(move || {
                lower_priority();
                let compute = || compute(ticket, &request, &cancel, &out);
                // It always answers; the panic hook reports a fault of it.
                let ended = catch_unwind(AssertUnwindSafe(|| on_all_cores_but_one(compute)));
                let ended = ended.unwrap_or_else(|_| Err(FAULT.to_owned()));
                out.send(Msg::Sweep(SweepMsg::Ended(ticket, ended)));
            });
        match started {
            Ok(_) => Vec::new(),
            Err(error) => {
                let why = format!("The system gives no thread for the load cases: {error}.");
                vec![Msg::Sweep(SweepMsg::Ended(ticket, Err(why)))]
            }
        }
    }
}

/// Reads or judges, at lower priority than the screen.
fn answered(effect: SweepEffect) -> Vec<Msg> {
    lower_priority();
    let answer = on_all_cores_but_one(|| answer(effect));
    answer.into_iter().map(Msg::Sweep).collect()
}

/// Reads or judges.
fn answer(effect: SweepEffect) -> Option<SweepMsg> {
    Some(match effect {
        SweepEffect::List(file) => {
            let stored = stored_sweeps(Path::new(store::DEFAULT_ROOT), &file);
            SweepMsg::Listed(file, stored)
        }
        SweepEffect::Read { dir, known } => {
            let read = || match known {
                Some(known) => known.newer(),
                None => SweepSnapshot::read(&dir, &AtomicBool::new(false)),
            };
            let read = catch_unwind(AssertUnwindSafe(|| read().map(SweepRead::new)));
            SweepMsg::Read(dir, read.unwrap_or_else(|_| Err(FAULT.to_owned())))
        }
        SweepEffect::Check(snapshot) => {
            let verdict = catch_unwind(AssertUnwindSafe(|| SweepVerdict::of(&snapshot)));
            let verdict = verdict.unwrap_or_else(|_| SweepVerdict {
                done: snapshot.done(),
                ..SweepVerdict::default()
            });
            SweepMsg::Checked(snapshot.dir.clone(), Arc::new(verdict))
        }
        SweepEffect::Compare(snapshot, request) => {
            let same = catch_unwind(AssertUnwindSafe(|| request.is_of(&snapshot)));
            SweepMsg::Compared(snapshot.dir.clone(), request.text, same.unwrap_or(false))
        }
        SweepEffect::Start(..) => return None,
    })
}

/// Computes the load cases of a text, and writes the tables of a sweep that has ended, as `seacable sweep` does.
fn compute(
    ticket: JobNumber,
    request: &SweepRequest,
    cancel: &AtomicBool,
    out: &Outbox,
) -> Result<(SweepRead, bool), String> {
    let plan = request.plan()?;
    let folder = folder(&plan)?;
    let dir = folder.dir().to_owned();
    out.send(Msg::Sweep(SweepMsg::Begun(ticket, dir.clone())));
    let (sweep, question) = (&plan.sweep, &plan.question);
    let (begun, told) = (Instant::now(), Mutex::new(None::<Instant>));
    let tell = |progress: SweepProgress| {
        let mut told = told.lock().unwrap_or_else(PoisonError::into_inner);
        let is_due = told.is_none_or(|told| told.elapsed() >= TELL);
        if is_due || progress.done == progress.of {
            *told = Some(Instant::now());
            let seconds = begun.elapsed().as_secs_f64();
            out.send(Msg::Sweep(SweepMsg::Progress(ticket, progress, seconds)));
        }
    };
    let outcomes = match question.statistics.until_settled {
        true => sweep.compute_until_settled(&folder, question, cancel, &tell),
        false => sweep.compute(Some(&folder), cancel, &tell),
    };
    if let Some(why) = not_stored(&outcomes) {
        return Err(why);
    }
    let cancelled = cancel.load(Ordering::Relaxed);
    if !cancelled {
        let answers = sweep.answers(&outcomes, question);
        let found = (&outcomes, answers.as_ref());
        let report = SweepReport::new((sweep, question), found, true, Some(&dir));
        report.store(&folder).map_err(|error| error.to_string())?;
    }
    let snapshot = SweepSnapshot::computed(&dir, Arc::new(plan), outcomes);
    Ok((SweepRead::new(snapshot), cancelled))
}

/// The folder of a stored sweep of exactly these load cases, else a new one.
fn folder(plan: &SweepPlan) -> Result<SweepFolder, String> {
    let variation = &plan.sweep.variation;
    let names = plan.sweep.results.names();
    let stored = stored_sweeps(Path::new(store::DEFAULT_ROOT), &variation.base.file());
    let known = stored
        .into_iter()
        .find(|entry| entry.info.is_of(variation, &names));
    let folder = match known {
        Some(known) => {
            refuse_on_cluster(&known.dir, variation.points.len())?;
            SweepFolder::open(&known.dir).map(|(folder, _)| folder)
        }
        None => SweepFolder::create(None, variation, (names, None)),
    };
    folder.map_err(|error| error.to_string())
}

/// A cluster may compute the same, which the command line asks it about.
fn refuse_on_cluster(dir: &Path, load_cases: usize) -> Result<(), String> {
    let found = SlurmFile::of_folder(dir, load_cases).map_err(|error| error.to_string())?;
    match found.1.filter(|record| !record.gathered) {
        None => Ok(()),
        Some(_) => Err(format!(
            "These load cases are computed by a cluster; `seacable sweep --resume {} --slurm` goes on.",
            visible::path(dir)
        )),
    }
}

/// Why a run could not be stored, which ends the sweep.
fn not_stored(outcomes: &SweepOutcomes) -> Option<String> {
    let SweepOutcomes::Runs(runs, _) = outcomes else {
        return None;
    };
    let mut refused = runs.iter().flatten().filter_map(|run| run.as_ref().err());
    let found = refused.find(|why| why.starts_with("its run cannot be stored"));
    found.map(|why| format!("A load case stopped the others: {why}"))
}

/// Computes on all cores but the one of the screen.
fn on_all_cores_but_one<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(cores.saturating_sub(1).max(1))
        .start_handler(|_| lower_priority())
        .build();
    match pool {
        Ok(pool) => pool.install(work),
        Err(_) => work(),
    }
}
