//! What a job computes: a run of a line case or of a system, from its start or resumed.

use std::borrow::Cow;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::checkpoint::ResumedSystem;
use super::job::SystemRequest;
use super::system_in_time::SystemInTime;
use crate::case::Case;
use crate::kinds::FileType;
use crate::run::event::JobEvent;
use crate::run::job::{self, Request};
use crate::run::store;
use crate::run::{ResumedRun, Run, RunInfo, resume_request};

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
        Self::resumed_until(dir, Some(until))
    }

    /// The same, or to the end of its case.
    ///
    /// # Errors
    /// As [`JobRequest::resumed`].
    pub fn resumed_until(dir: &Path, until: Option<f64>) -> Result<Self, String> {
        if FileType::of_path(&dir.join(store::CASE)) == FileType::System {
            let (mut request, from) = resume_request::<SystemInTime>(dir, until)?;
            request.id = stem(&request.file);
            return Ok(Self::System(Box::new(request), from.map(Box::new)));
        }
        let (mut request, from) = resume_request::<Case>(dir, until)?;
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
            Self::Line(request, _) => request.stored_text(),
            Self::System(request, _) => request.stored_text(),
        }
    }

    /// Names its run.
    pub fn name(&mut self, id: &str) {
        let known = match self {
            Self::Line(request, _) => &mut request.id,
            Self::System(request, _) => &mut request.id,
        };
        id.clone_into(known);
    }

    /// Computes it. Does not send [`JobEvent::Finished`]: the run is returned.
    pub fn execute(&self, cancel: &AtomicBool, events: &mut dyn FnMut(JobEvent)) -> Run {
        match self {
            Self::Line(request, from) => {
                job::execute_from(request, from.as_deref(), cancel, events)
            }
            Self::System(request, from) => {
                job::execute_from(request, from.as_deref(), cancel, events)
            }
        }
    }
}

impl From<Request> for JobRequest {
    fn from(request: Request) -> Self {
        Self::Line(Box::new(request), None)
    }
}

impl From<SystemRequest> for JobRequest {
    fn from(request: SystemRequest) -> Self {
        Self::System(Box::new(request), None)
    }
}

/// What its runs are named after.
fn stem(file: &str) -> String {
    file.trim_end_matches(".toml").to_owned()
}
