//! What a study computes at a point: a run that can be stored, or a system at rest, which is not.

use std::sync::atomic::AtomicBool;

use crate::case::Case;
use crate::run::Run;
use crate::run::job::{self, Request};
use crate::system::at_rest::SystemAtRest;
use crate::system::motion::job_request::JobRequest;
use crate::system::motion::system_in_time::SystemInTime;

/// What a study computes at a point.
#[derive(Debug, Clone)]
pub enum StudyJob {
    /// A run of a case of a line, or of a system in time.
    Run(JobRequest),
    /// A system at rest.
    AtRest(Box<Request<SystemAtRest>>),
}

impl StudyJob {
    /// Computes it.
    pub fn execute(&self, cancel: &AtomicBool) -> Run {
        match self {
            Self::Run(request) => request.execute(cancel, &mut |_| {}),
            Self::AtRest(request) => job::execute(request, cancel, &mut |_| {}),
        }
    }
}

impl From<JobRequest> for StudyJob {
    fn from(request: JobRequest) -> Self {
        Self::Run(request)
    }
}

impl From<Request<Case>> for StudyJob {
    fn from(request: Request<Case>) -> Self {
        Self::Run(request.into())
    }
}

impl From<Request<SystemInTime>> for StudyJob {
    fn from(request: Request<SystemInTime>) -> Self {
        Self::Run(request.into())
    }
}

impl From<Request<SystemAtRest>> for StudyJob {
    fn from(request: Request<SystemAtRest>) -> Self {
        Self::AtRest(Box::new(request))
    }
}
