//! Jobs that run, wait or have ended.

use std::borrow::Cow;
use std::collections::VecDeque;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::case_list::Filter;
use crate::case::stand_alone;
use crate::kinds::FileType;
use crate::run::event::JobEvent;
use crate::run::job::{self, Request};
use crate::run::store;
use crate::run::{Progress, ResumedRun, Run, RunInfo, resume_request};
use crate::system::motion::checkpoint::{self, ResumedSystem};
use crate::system::motion::job::{self as system_job, SystemRequest};
use crate::tui::fuzzy::FuzzyFilter;

/// Number of a job in this session; a message with a number we no longer wait for is dropped.
pub type JobNumber = u64;

/// What a job is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JobPurpose {
    /// The re-solve after an edit; the newest wins and nothing is stored.
    Live,
    /// Asked for by the user, and stored.
    Run,
    /// Trials of hard cases.
    Trials,
    /// The load cases of a file, each of them stored.
    Sweep,
}

/// State of a job.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum JobState {
    /// Waits for its turn.
    Queued,
    /// Computes.
    Running,
    /// Complete.
    Done,
    /// Gave up, for this reason.
    Failed(String),
    /// Stopped by the user.
    Cancelled,
}

impl JobState {
    /// Its word on screen.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Self::Queued => "queued",
            Self::Running => "running",
            Self::Done => "done",
            Self::Failed(_) => "failed",
            Self::Cancelled => "cancelled",
        }
    }

    /// True while it may still compute.
    #[must_use]
    pub fn is_open(&self) -> bool {
        matches!(self, Self::Queued | Self::Running)
    }
}

/// A job as the list shows it.
#[derive(Debug, Clone)]
pub struct JobLine {
    /// Its number.
    pub ticket: JobNumber,
    /// What it computes, in words.
    pub name: String,
    /// What it is for.
    pub purpose: JobPurpose,
    /// Its state.
    pub state: JobState,
    /// How far it is.
    pub progress: Progress,
}

/// What a job computes.
#[derive(Debug, Clone)]
pub enum JobRequest {
    /// A run of a line case, from its start or from where an earlier run is resumed.
    Line(Box<Request>, Option<Box<ResumedRun>>),
    /// The same of a system of lines in time.
    System(Box<SystemRequest>, Option<Box<ResumedSystem>>),
}

impl JobRequest {
    /// The stored run in this directory, resumed up to a later end \[s\].
    ///
    /// # Errors
    /// Why it cannot be resumed.
    pub fn resumed(dir: &Path, until: f64) -> Result<Self, String> {
        if FileType::of(&dir.join(store::CASE)) == FileType::System {
            let (mut request, from) = checkpoint::resume_request(dir, Some(until))?;
            request.id = stem(&request.file);
            return Ok(Self::System(Box::new(request), from.map(Box::new)));
        }
        let (mut request, from) = resume_request(dir, Some(until))?;
        request.id = stem(&request.file);
        Ok(Self::Line(Box::new(request), from.map(Box::new)))
    }

    /// The time that it begins at \[s\].
    #[must_use]
    pub fn begins_at(&self) -> f64 {
        match self {
            Self::Line(_, from) => from.as_ref().map_or(0.0, |from| from.checkpoint.time()),
            Self::System(_, from) => from.as_ref().map_or(0.0, |from| from.checkpoint.time()),
        }
    }

    /// File name of its case.
    #[must_use]
    pub fn file(&self) -> &str {
        match self {
            Self::Line(request, _) => &request.file,
            Self::System(request, _) => &request.file,
        }
    }

    /// Its text.
    #[must_use]
    pub fn text(&self) -> &str {
        match self {
            Self::Line(request, _) => &request.text,
            Self::System(request, _) => &request.text,
        }
    }

    /// The content of `run.toml` while it is computed.
    #[must_use]
    pub fn initial_info(&self) -> RunInfo {
        match self {
            Self::Line(request, _) => request.initial_info(),
            Self::System(request, _) => request.initial_info(),
        }
    }

    /// The text that is stored with its run.
    #[must_use]
    pub fn stored_text(&self) -> Cow<'_, str> {
        match self {
            Self::Line(request, _) => stand_alone(&request.text, &request.case),
            Self::System(request, _) => Cow::Borrowed(&request.text),
        }
    }

    /// Computes it. Does not send [`JobEvent::Finished`]: the run is returned.
    pub fn execute(&self, cancel: &AtomicBool, events: &mut dyn FnMut(JobEvent)) -> Run {
        match self {
            Self::Line(request, from) => {
                job::execute_from(request, from.as_deref(), cancel, events)
            }
            Self::System(request, from) => {
                system_job::execute(request, from.as_deref(), cancel, events)
            }
        }
    }
}

/// What its runs are named after.
fn stem(file: &str) -> String {
    file.trim_end_matches(".toml").to_owned()
}

/// A request that waits for its turn.
#[derive(Debug, Clone)]
pub struct QueuedRequest {
    /// Number of its job.
    pub ticket: JobNumber,
    /// What to compute.
    pub request: JobRequest,
}

/// All jobs of the session, oldest first.
#[derive(Debug, Clone)]
pub struct Jobs {
    /// The jobs.
    pub lines: Vec<JobLine>,
    /// Requests that wait for their turn.
    pub waiting: VecDeque<QueuedRequest>,
    /// How many stored runs may compute at a time.
    pub limit: usize,
    /// Cursor in the list.
    pub cursor: usize,
    /// The filter of the list.
    pub filter: Filter,
    /// The next number.
    pub next: JobNumber,
}

impl Default for Jobs {
    fn default() -> Self {
        Self {
            lines: Vec::new(),
            waiting: VecDeque::new(),
            limit: 1,
            cursor: 0,
            filter: Filter::default(),
            next: 1,
        }
    }
}

impl Jobs {
    /// A new number, never used before.
    pub fn ticket(&mut self) -> JobNumber {
        let ticket = self.next;
        self.next += 1;
        ticket
    }

    /// The jobs that pass the filter.
    #[must_use]
    pub fn shown(&self) -> Vec<&JobLine> {
        if self.filter.is_empty() {
            return self.lines.iter().collect();
        }
        let parts = |line: &JobLine| vec![line.name.clone(), line.state.word().to_owned()];
        let lines: Vec<Vec<String>> = self.lines.iter().map(parts).collect();
        let places = FuzzyFilter::new(self.filter.input.value()).places(&lines);
        places.into_iter().map(|place| &self.lines[place]).collect()
    }

    /// The job under the cursor.
    #[must_use]
    pub fn current(&self) -> Option<&JobLine> {
        self.shown().get(self.cursor).copied()
    }

    /// The job of this number.
    pub fn get_mut(&mut self, ticket: JobNumber) -> Option<&mut JobLine> {
        self.lines.iter_mut().find(|line| line.ticket == ticket)
    }

    /// How many compute for the store at this moment.
    #[must_use]
    pub fn computing(&self) -> usize {
        self.of(JobPurpose::Run)
            .filter(|l| l.state == JobState::Running)
            .count()
    }

    /// How many stored runs, and sweeps of them, wait or compute.
    #[must_use]
    pub fn open(&self) -> usize {
        let stored = [JobPurpose::Run, JobPurpose::Sweep];
        let all = stored.into_iter().flat_map(|purpose| self.of(purpose));
        all.filter(|l| l.state.is_open()).count()
    }

    fn of(&self, purpose: JobPurpose) -> impl Iterator<Item = &JobLine> {
        self.lines.iter().filter(move |l| l.purpose == purpose)
    }
}
