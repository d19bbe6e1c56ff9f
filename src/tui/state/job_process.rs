//! Jobs that are processes of their own: what is asked of them, and what is said of them.

use std::path::{Path, PathBuf};

use super::jobs::{JobNumber, JobState};
use crate::case::TextDigest;
use crate::jobs::spec::plain;
use crate::jobs::{JobRequest, SweepRequest};
use crate::run::Progress;

/// What is known of a job that is a process of its own.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct JobProcess {
    /// Its number on its host, once it has one.
    pub number: Option<u64>,
    /// Its host, where that is another one.
    pub host: Option<String>,
    /// The file of its case.
    pub case: PathBuf,
    /// What is special about its run, or empty.
    pub label: String,
    /// The case text it computes.
    pub text: TextDigest,
    /// Its method.
    pub method: String,
    /// Simulated time asked for \[s\].
    pub duration_s: f64,
    /// The directory of its run or sweep, once there is one.
    pub results: Option<PathBuf>,
}

impl JobProcess {
    /// Whether it is of the file at a path, as seen from a directory.
    #[must_use]
    pub fn is_of(&self, directory: &Path, path: &Path) -> bool {
        self.host.is_none() && self.case == plain(directory, path)
    }
}

/// What a process is to compute.
#[derive(Debug, Clone)]
pub enum ProcessWork {
    /// A run.
    Run(JobRequest),
    /// Load cases.
    Sweep(SweepRequest),
}

/// A job to be started as a process.
#[derive(Debug, Clone)]
pub struct NewProcess {
    /// What it computes.
    pub work: ProcessWork,
    /// The same in words.
    pub name: String,
    /// What is special about its run, or empty.
    pub label: String,
    /// The file of its case.
    pub case: PathBuf,
}

/// A job that another screen, or an earlier one, has started.
#[derive(Debug, Clone)]
pub struct FoundJob {
    /// What it computes, in words.
    pub name: String,
    /// Whether it computes load cases.
    pub is_sweep: bool,
    /// What is known of it.
    pub process: JobProcess,
    /// Its state.
    pub state: JobState,
    /// How far it is.
    pub progress: Progress,
}

/// What the screen asks of jobs that are processes.
#[derive(Debug, Clone)]
pub enum ProcessEffect {
    /// Start one as the job of this number.
    Submit(JobNumber, Box<NewProcess>),
    /// Follow the one that has the second number on this host as the job of the first.
    Adopt(JobNumber, u64),
    /// Whether what a job records is shown.
    Show(JobNumber, bool),
}

/// What is said of jobs that are processes.
#[derive(Debug, Clone)]
pub enum ProcessMsg {
    /// One was found, or one of another host has changed.
    Found(Box<FoundJob>),
    /// One of another host is gone: its host and its number there.
    Gone(String, u64),
    /// A job has this number on this host.
    Numbered(JobNumber, u64),
    /// A job is so.
    Is(JobNumber, JobState),
    /// A job could not be started as a process, for this reason.
    NotSubmitted(JobNumber, Box<NewProcess>, String),
    /// Why jobs end with the login, in words.
    EndedByLogout(String),
}
