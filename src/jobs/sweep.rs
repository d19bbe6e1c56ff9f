//! The load cases of a text computed as a job, as `seacable sweep` computes those of a file.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use crate::background::lower_priority;
use crate::case::kind;
use crate::kinds::FileType;
use crate::report::sweep::SweepReport;
use crate::run::store;
use crate::study::sweep::slurm::SlurmFile;
use crate::study::sweep::{
    PlanChoices, PlanError, SweepFolder, SweepOutcomes, SweepPlan, SweepProgress, SweepSnapshot,
    stored_sweeps,
};
use crate::system::SystemFile;
use crate::visible;

/// How often a sweep says how far it is, at most.
const TELL: Duration = Duration::from_millis(200);

/// The load cases of an edited text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweepRequest {
    /// Its kind.
    pub kind: FileType,
    /// The text.
    pub text: String,
    /// Where its file stands.
    pub path: PathBuf,
    /// Keys in which the text differs from the file, as `key=value`.
    pub overrides: Vec<String>,
}

impl SweepRequest {
    /// What is computed. For the threads behind the screen.
    ///
    /// # Errors
    /// Why nothing can be, in words.
    pub fn plan(&self) -> Result<SweepPlan, String> {
        let path = self.path.display().to_string();
        let choices = PlanChoices::default();
        let plan = match self.kind {
            FileType::System => {
                let read = kind::read::<SystemFile>(&self.text, &path);
                let solved = read.and_then(|read| Ok((read.whole_text(), read.compute()?)));
                solved
                    .map_err(PlanError::Invalid)
                    .and_then(|(text, solved)| {
                        SweepPlan::of_system((&text, &solved), &path, &self.overrides, choices)
                    })
            }
            _ => SweepPlan::of_line(&self.text, &path, &self.overrides, choices),
        };
        let plan = plan.map_err(|error| error.to_string())?;
        match plan.sweep.variation.keys.is_empty() {
            true => Err("There are no load cases: add [[load_cases]] to the file.".to_owned()),
            false => Ok(plan),
        }
    }
}

impl SweepRequest {
    /// Whether a sweep is of exactly these load cases, inputs and results. For the threads behind the screen.
    #[must_use]
    pub fn is_of(&self, snapshot: &SweepSnapshot) -> bool {
        let known = &snapshot.plan.sweep;
        self.plan().is_ok_and(|SweepPlan { sweep: own, .. }| {
            own.variation.base.text == known.variation.base.text
                && own.variation.points == known.variation.points
                && own.results == known.results
        })
    }
}

/// What a sweep says while it is computed.
#[derive(Debug, Clone)]
pub enum SweepEvent {
    /// It is stored in this folder.
    Begun(PathBuf),
    /// How far it is, after so many seconds.
    Progress(SweepProgress, f64),
}

/// A sweep that has ended.
#[derive(Debug)]
pub struct EndedSweep {
    /// What has become of its load cases.
    pub snapshot: SweepSnapshot,
    /// Whether it was cancelled before all of them were done.
    pub is_cancelled: bool,
}

/// Computes the load cases of a text, and writes the tables of a sweep that has ended, as `seacable sweep` does; on all cores but one.
///
/// # Errors
/// Why nothing can be computed or stored, in words.
pub fn compute_sweep(
    request: &SweepRequest,
    cancel: &AtomicBool,
    events: &(dyn Fn(SweepEvent) + Sync),
) -> Result<EndedSweep, String> {
    on_all_cores_but_one(|| compute(request, cancel, events))
}

fn compute(
    request: &SweepRequest,
    cancel: &AtomicBool,
    events: &(dyn Fn(SweepEvent) + Sync),
) -> Result<EndedSweep, String> {
    let plan = request.plan()?;
    let folder = folder(&plan)?;
    let dir = folder.dir().to_owned();
    events(SweepEvent::Begun(dir.clone()));
    let (sweep, question) = (&plan.sweep, &plan.question);
    let (begun, told) = (Instant::now(), Mutex::new(None::<Instant>));
    let tell = |progress: SweepProgress| {
        let mut told = told.lock().unwrap_or_else(PoisonError::into_inner);
        let is_due = told.is_none_or(|told| told.elapsed() >= TELL);
        if is_due || progress.done == progress.of {
            *told = Some(Instant::now());
            events(SweepEvent::Progress(
                progress,
                begun.elapsed().as_secs_f64(),
            ));
        }
    };
    let computed = sweep.compute_asked(Some(&folder), question, cancel, &tell);
    let (outcomes, finer) = computed.map_err(|error| error.to_string())?;
    if let Some(why) = not_stored(&outcomes) {
        return Err(why);
    }
    let is_cancelled = cancel.load(Ordering::Relaxed);
    if !is_cancelled {
        let answers = sweep.answers(&outcomes, question);
        let found = (&outcomes, answers.as_ref());
        let report =
            SweepReport::new((sweep, question), found, true, Some(&dir)).with_finer(&finer);
        report.store(&folder).map_err(|error| error.to_string())?;
    }
    let snapshot = SweepSnapshot::computed(&dir, Arc::new(plan), outcomes);
    Ok(EndedSweep {
        snapshot,
        is_cancelled,
    })
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
            visible::argument(dir)
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
pub fn on_all_cores_but_one<T: Send>(work: impl FnOnce() -> T + Send) -> T {
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
