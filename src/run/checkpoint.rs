//! A run on its way, complete enough to go on later as if it had never stopped: to the same bits.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::response::Response;
use super::store::{Rows, Shapes, StoreError};
use super::touchdown_speed::TouchdownSpeed;
use super::{LineShape, Profile};
use crate::dynamics::{MarchProgress, MethodState, TimeGrid};
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
    /// How the line lay down on the bed so far.
    #[serde(default)]
    pub front: Option<TouchdownSpeed>,
    /// What the start gave to be said.
    pub warnings: Vec<String>,
    /// Where the march is.
    pub place: MarchProgress,
    /// The state of the line.
    pub state: State,
    /// What the method carries from step to step.
    pub carried: MethodState,
    /// The line node by node, with its envelopes.
    pub profile: Profile,
    /// How far the nodes moved, where the case asks for that.
    #[serde(default)]
    pub response: Option<Response>,
}

impl Checkpoint {
    /// Whether a march with these times goes on where this one stands.
    #[must_use]
    pub fn fits(&self, grid: &TimeGrid) -> bool {
        self.whole_step_s.to_bits() == grid.dt.to_bits() && self.per_output == grid.per_output
    }
}

/// Where a run goes on from.
#[derive(Debug, Clone, PartialEq)]
pub struct Resume {
    /// Where it stands.
    pub checkpoint: Checkpoint,
    /// The run directory with what it has recorded up to there, and perhaps beyond.
    pub dir: PathBuf,
}

/// Takes a row of the record: time \[s\], values of the channels, and the shape at that time where there is one.
type Take<'a> = dyn FnMut(f64, &[f64], Option<LineShape>) + 'a;

impl Resume {
    /// Reads the record up to where the run goes on.
    ///
    /// # Errors
    /// The record does not reach so far.
    pub(super) fn replay(&self, take: &mut Take<'_>) -> Result<(), StoreError> {
        let slop = 1e-9 * self.checkpoint.whole_step_s;
        let until = self.checkpoint.place.time + slop;
        let mut rows = Rows::open(&self.dir);
        let mut shapes = Shapes::open(&self.dir);
        let mut shape = shapes.next();
        let mut reached = f64::NEG_INFINITY;
        while let Some((time, values)) = rows.next() {
            if time > until {
                break;
            }
            let here = shape.take_if(|shape| shape.time <= time);
            take(time, values, here);
            reached = time;
            if shape.is_none() {
                shape = shapes.next();
            }
        }
        if reached < until - 2.0 * slop {
            return Err(rows.short_of(&self.dir, until));
        }
        Ok(())
    }
}
