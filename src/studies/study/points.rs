//! A case computed at many points, side by side: what studies have in common.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use rayon::prelude::*;

use super::study_job::StudyJob;
use crate::case::fields::number;
use crate::case::{self, Attachment, Diagnostic, QuantityId, StudyValue, edit};
use crate::run::job::Request;
use crate::run::store::{StoreError, StoringRecorder};
use crate::run::{Quantity, Run, RunInfo, RunState};
use crate::system::motion::job_request::JobRequest;

/// The case that points are set on top of.
#[derive(Debug, Clone, PartialEq)]
pub struct BaseCase {
    /// Its text, overrides applied.
    pub text: String,
    /// Where it stands, so that the files it names are found.
    pub path: String,
    /// Keys that were set on top of the file, as `key=value`.
    pub overrides: Vec<String>,
    /// The files that it carries, with the tables that were parsed of them, which its points share.
    pub files: BTreeMap<String, Attachment>,
}

/// A key with the value it has at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// Key path.
    pub key: String,
    /// Its value, in the unit of the key.
    pub value: StudyValue,
}

impl Setting {
    /// A key at a value.
    #[must_use]
    pub fn new(key: &str, value: StudyValue) -> Self {
        Self {
            key: key.to_owned(),
            value,
        }
    }

    /// Key and value as an option sets them.
    #[must_use]
    pub fn as_override(&self) -> String {
        format!("{}={}", self.key, self.written())
    }

    /// The value as it is written in a case file.
    #[must_use]
    pub fn written(&self) -> String {
        match &self.value {
            StudyValue::Number(value) => number(*value),
            StudyValue::Word(word) => word.clone(),
        }
    }
}

/// A point at which a case is computed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StudyPoint {
    /// What is set there.
    pub settings: Vec<Setting>,
}

/// The case at a point, or why it refuses the settings.
pub type PointRequest = Result<Request, String>;

impl BaseCase {
    /// A case without overrides.
    #[must_use]
    pub fn new(text: &str, path: &str) -> Self {
        Self {
            text: text.to_owned(),
            path: path.to_owned(),
            overrides: Vec::new(),
            files: BTreeMap::new(),
        }
    }

    /// Its file name.
    #[must_use]
    pub fn file(&self) -> String {
        let file = Path::new(&self.path).file_name();
        file.map_or_else(String::new, |name| name.to_string_lossy().into_owned())
    }

    /// The case with some settings on top.
    ///
    /// # Errors
    /// Why the case refuses them.
    pub fn request(&self, settings: &[Setting]) -> PointRequest {
        let written: Vec<String> = settings.iter().map(Setting::written).collect();
        let keys = settings.iter().map(|setting| setting.key.as_str());
        let edits: Vec<(&str, &str)> = keys.zip(written.iter().map(String::as_str)).collect();
        let text = edit::set_all(&self.text, &edits).map_err(|faults| reasons(&faults))?;
        let set = settings.iter().map(Setting::as_override);
        let overrides = self.overrides.iter().cloned().chain(set).collect();
        self.request_of(text, overrides)
    }

    /// The case as another text, with these overrides.
    ///
    /// # Errors
    /// What is wrong with the text.
    pub fn request_of(&self, text: String, overrides: Vec<String>) -> PointRequest {
        let folder = Path::new(&self.path).parent().unwrap_or(Path::new(""));
        let case = case::parse_sharing(&text, (&self.path, folder), &self.files);
        let case = case.map_err(|faults| reasons(&faults))?;
        Ok(Request {
            case,
            text,
            file: self.file(),
            overrides,
            id: String::new(),
        })
    }
}

/// Diagnostics in a line.
pub(super) fn reasons(faults: &[Diagnostic]) -> String {
    let problems = faults.iter().map(|d| format!("{}: {}", d.key, d.problem));
    problems.collect::<Vec<_>>().join("; ")
}

/// The run of a point, without its history.
#[derive(Debug, Clone, PartialEq)]
pub struct PointRun {
    /// What was computed, how, at what cost.
    pub info: RunInfo,
    /// Its results.
    pub summary: Vec<Quantity>,
    /// Where it is stored, if it is.
    pub dir: Option<PathBuf>,
}

impl PointRun {
    /// A result of a run that came to its end.
    #[must_use]
    pub fn result(&self, id: &QuantityId) -> Option<&Quantity> {
        let done = self.info.state == RunState::Done;
        self.summary.iter().find(|q| done && q.id == *id)
    }

    /// Why it did not come to its end; none where it did.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        match self.info.state {
            RunState::Done => None,
            RunState::Failed => Some(self.info.failure.as_deref().unwrap_or("it failed")),
            RunState::Cancelled | RunState::Partial => Some("it was stopped"),
        }
    }
}

/// What became of a point: its run, or the reason why the case refuses it or the run cannot be stored.
pub type PointOutcome = Result<PointRun, String>;

/// How far the computation of some points is.
#[derive(Debug, Clone, Copy)]
pub struct PointProgress<'a> {
    /// Points computed so far, this one included.
    pub done: usize,
    /// Points in all.
    pub of: usize,
    /// The point that has just been computed.
    pub index: usize,
    /// What became of it.
    pub outcome: &'a PointOutcome,
}

/// Computes points side by side on the threads of the caller's pool, one at a time on each, and stores nothing; points whose runs are
/// stored are a [sweep](super::sweep). A point that fails stops no other. Once `cancel` is set no further one begins; a point that did not
/// begin has no outcome.
pub fn compute<J: Into<StudyJob> + Send>(
    requests: Vec<Result<J, String>>,
    cancel: &AtomicBool,
    progress: &(dyn Fn(PointProgress<'_>) + Sync),
) -> Vec<Option<PointOutcome>> {
    let compute = |request: Result<J, String>| outcome(request?.into(), None, cancel);
    side_by_side(requests, cancel, compute, |done, of, index, outcome| {
        progress(PointProgress {
            done,
            of,
            index,
            outcome,
        });
    })
}

/// Computes points side by side, and tells of each how many are done, of how many, which it was and what became of it. Once `cancel` is
/// set no further one begins.
pub(super) fn side_by_side<R: Send, T: Send>(
    requests: Vec<R>,
    cancel: &AtomicBool,
    compute: impl Fn(R) -> T + Sync,
    told: impl Fn(usize, usize, usize, &T) + Sync,
) -> Vec<Option<T>> {
    let (of, count) = (requests.len(), AtomicUsize::new(0));
    let one = |(index, request): (usize, R)| {
        if cancel.load(Ordering::Relaxed) {
            return None;
        }
        let outcome = compute(request);
        told(
            1 + count.fetch_add(1, Ordering::Relaxed),
            of,
            index,
            &outcome,
        );
        Some(outcome)
    };
    let points = requests.into_par_iter().enumerate().with_max_len(1);
    points.map(one).collect()
}

/// Computes a point, and stores its run where a place is given; a system at rest leaves none.
pub(super) fn outcome(job: StudyJob, store: Option<&Path>, cancel: &AtomicBool) -> PointOutcome {
    let (run, dir) = match (job, store) {
        (StudyJob::Run(mut job), Some(place)) => {
            let stored = execute_stored(&mut job, place, cancel).map_err(|error| {
                // Nor can those of the other points.
                cancel.store(true, Ordering::Relaxed);
                format!("its run cannot be stored: {error}")
            });
            let (run, dir) = stored?;
            (run, Some(dir))
        }
        (job, _) => (job.execute(cancel), None),
    };
    let Run { info, summary, .. } = run;
    Ok(PointRun { info, summary, dir })
}

/// Computes a job and stores its run: while it is computed, or at its end where that comes in a moment.
fn execute_stored(
    job: &mut JobRequest,
    dir: &Path,
    cancel: &AtomicBool,
) -> Result<(Run, PathBuf), StoreError> {
    let mut recorder = StoringRecorder::begin_late(dir, job.initial_info(), &job.stored_text())?;
    job.name(recorder.id());
    let mut run = job.execute(cancel, &mut |event| {
        if !recorder.event(&event) {
            cancel.store(true, Ordering::Relaxed);
        }
    });
    let dir = recorder.finish(&mut run, false)?;
    Ok((run, dir))
}
