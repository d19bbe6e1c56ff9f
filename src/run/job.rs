//! A case computed on a thread: events out, a cancel flag in.

use super::{Frame, Run};
use crate::case::Case;

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// The case, checked.
    pub case: Case,
    /// Its text, with every override applied; kept with the run.
    pub text: String,
    /// File name of the case.
    pub file: String,
    /// Keys set on top of the file, as `key=value`.
    pub overrides: Vec<String>,
    /// Name of the run.
    pub id: String,
}

/// What a job says while it goes on.
#[derive(Debug, Clone, PartialEq)]
pub enum Event {
    /// The scene stands; these channels (name, unit) will be filled.
    Started {
        /// Names and units, in the order of [`Frame::values`].
        channels: Vec<(String, String)>,
    },
    /// An output instant.
    Frame(Box<Frame>),
    /// The run is complete; companions now estimate its errors.
    Estimating,
    /// The end, whatever it was: see [`super::RunInfo::state`].
    Finished(Box<Run>),
}
