//! Jobs that run, wait or have ended.

use std::collections::VecDeque;

pub use crate::jobs::JobRequest;
use crate::run::Progress;

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
