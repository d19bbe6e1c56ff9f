//! What a job reports while it computes.

use super::{OutputFrame, Run, SearchProgress};
use crate::case::ChannelId;

/// Where the events of a computation go; none where nobody waits for them.
pub type Listener<'a> = Option<&'a mut dyn FnMut(JobEvent)>;

/// What a job reports while it computes.
#[derive(Debug, Clone, PartialEq)]
pub enum JobEvent {
    /// A round of the search for an accuracy begins.
    Searching(SearchProgress),
    /// The computation begins; these channels will be recorded.
    Started {
        /// In the order of [`OutputFrame::values`].
        channels: Vec<ChannelId>,
        /// Names of the lines, in the order of their numbers; none of a line by itself.
        lines: Vec<String>,
    },
    /// The text of the case as it is computed, where a search chose its mesh and its steps: what checkpoints are of.
    Case(String),
    /// An output time.
    Frame(Box<OutputFrame>),
    /// The state of the computation, from which it can be resumed, as the text of its file.
    Checkpoint(String),
    /// The run is complete; companion runs now estimate its errors.
    Estimating,
    /// The end, whatever it was: see [`RunInfo::state`](super::RunInfo::state).
    Finished(Box<Run>),
}
