//! The state of a computation at an output time, complete enough to be resumed to the same bits.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::Profile;
use super::response::Response;
use super::touchdown_speed::TouchdownSpeed;
use crate::dynamics::{MarchProgress, MethodState, TimeGrid};
use crate::solve::State;

/// The state of a computation at an output time. Written as `checkpoint.toml`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    /// Length of a whole step \[s\].
    pub whole_step_s: f64,
    /// Whole steps an output interval.
    pub per_output: u64,
    /// Events of the line so far.
    pub phase: usize,
    /// Newton iterations of the search for the start.
    pub start_iterations: u64,
    /// Greatest value of every channel so far and its time \[s\].
    pub peaks: Vec<(f64, f64)>,
    /// Smallest value of every channel so far and its time \[s\].
    pub troughs: Vec<(f64, f64)>,
    /// Squares of the greatest lengths of segments with a breaking load \[m²\].
    #[serde(default, rename = "longest")]
    pub greatest_lengths: Vec<f64>,
    /// Touchdown of the line on the bed so far.
    #[serde(default, rename = "front")]
    pub touchdown: Option<TouchdownSpeed>,
    /// Warnings of the start.
    pub warnings: Vec<String>,
    /// Position of the time march.
    pub place: MarchProgress,
    /// The state of the line.
    pub state: State,
    /// State of the time integration method.
    #[serde(rename = "carried")]
    pub method_state: MethodState,
    /// The line node by node, with its envelopes.
    pub profile: Profile,
    /// Sums over the displacements, where the case asks for them.
    #[serde(default)]
    pub response: Option<Response>,
}

impl Checkpoint {
    /// Whether a march with this time grid can continue from here.
    #[must_use]
    pub fn fits(&self, grid: &TimeGrid) -> bool {
        self.whole_step_s.to_bits() == grid.dt.to_bits() && self.per_output == grid.per_output
    }
}

/// A stored run to be resumed.
#[derive(Debug, Clone, PartialEq)]
pub struct Resume {
    /// Its state.
    pub checkpoint: Checkpoint,
    /// The run directory, with the record up to there and perhaps beyond.
    pub dir: PathBuf,
}
