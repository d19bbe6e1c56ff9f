//! A run on its way, complete enough to go on later as if it had never stopped: to the same bits.

use serde::{Deserialize, Serialize};

use super::{History, LineShape, Profile};
use crate::dynamics::{Carried, Grid, Place};
use crate::solve::State;

/// A run on its way, at an output time.
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
    /// Squares of the longest that segments with a breaking load were \[m²\].
    #[serde(default)]
    pub longest: Vec<f64>,
    /// What the start gave to be said.
    pub warnings: Vec<String>,
    /// Where the march is.
    pub place: Place,
    /// The state of the line.
    pub state: State,
    /// What the method carries from step to step.
    pub carried: Carried,
    /// The line node by node, with its envelopes.
    pub profile: Profile,
}

impl Checkpoint {
    /// Whether a march with these times goes on where this one stands.
    #[must_use]
    pub fn fits(&self, grid: &Grid) -> bool {
        self.whole_step_s.to_bits() == grid.dt.to_bits() && self.per_output == grid.per_output
    }
}

/// Where a run goes on from.
#[derive(Debug, Clone, PartialEq)]
pub struct Resume {
    /// Where it stands.
    pub checkpoint: Checkpoint,
    /// What it has recorded up to there.
    pub history: History,
    /// Shapes stored up to there.
    pub shapes: Vec<LineShape>,
}

impl Resume {
    /// From the record of a run that may have gone beyond its last checkpoint.
    #[must_use]
    pub fn new(checkpoint: Checkpoint, mut history: History, mut shapes: Vec<LineShape>) -> Self {
        let until = checkpoint.place.time + 1e-9 * checkpoint.whole_step_s;
        let rows = history.time.partition_point(|t| *t <= until);
        history.time.truncate(rows);
        for channel in &mut history.channels {
            channel.values.truncate(rows);
        }
        shapes.retain(|shape| shape.time <= until);
        Self {
            checkpoint,
            history,
            shapes,
        }
    }
}
