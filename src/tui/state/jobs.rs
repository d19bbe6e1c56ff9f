//! Jobs that run, wait or have ended.

use std::collections::VecDeque;
use std::path::PathBuf;

use super::case_list::Filter;
use super::job_process::JobProcess;
use crate::fuzzy::FuzzyFilter;
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
    /// Its process ended without a word; what can be done about it.
    Killed(String),
    /// Computed on another host; how far it is, in words.
    Elsewhere(String),
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
            Self::Killed(_) => "killed",
            Self::Elsewhere(_) => "elsewhere",
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
    /// What is known of its process, where it is one of its own.
    pub process: Option<Box<JobProcess>>,
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
    /// The directory that the program works in, where stored runs and load cases are computed by processes of their own.
    pub processes: Option<PathBuf>,
    /// Why those end with the login, where the system ends them.
    pub ended_by_logout: Option<String>,
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
            processes: None,
            ended_by_logout: None,
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
        self.lines_of_purpose(JobPurpose::Run)
            .filter(|l| l.state == JobState::Running)
            .count()
    }

    /// How many stored runs, and sweeps of them, wait or compute.
    #[must_use]
    pub fn open(&self) -> usize {
        self.open_lines().count()
    }

    /// How many of them end with this program.
    #[must_use]
    pub fn open_here(&self) -> usize {
        self.open_lines().filter(|l| l.process.is_none()).count()
    }

    fn open_lines(&self) -> impl Iterator<Item = &JobLine> {
        let stored = [JobPurpose::Run, JobPurpose::Sweep];
        let all = stored
            .into_iter()
            .flat_map(|purpose| self.lines_of_purpose(purpose));
        all.filter(|l| l.state.is_open())
    }

    fn lines_of_purpose(&self, purpose: JobPurpose) -> impl Iterator<Item = &JobLine> {
        self.lines.iter().filter(move |l| l.purpose == purpose)
    }
}
