//! What a method carries from step to step beside the state, so that a march can be taken up later as if it had never
//! stopped.

use serde::{Deserialize, Serialize};

use super::WorkCounts;
use crate::numerics::V3;

/// What a method carries; every method has its own part of it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct MethodState {
    /// Generalized-alpha: change of acceleration over the step before, per second \[m/s³\].
    pub jerk: Vec<V3>,
    /// Generalized-alpha: 1, or 0 after a step that could not be solved.
    pub trust: f64,
    /// Quasi-static march: length of the step before \[s\].
    pub before: Option<f64>,
    /// Quasi-static march: positions one step back \[m\].
    pub x_before: Vec<V3>,
    /// Quasi-static march: whether drag coefficients are held.
    pub remembers: bool,
    /// RK4: the fastest decay at the end of the step before \[1/s\] and its node.
    #[serde(default)]
    pub decay: Option<(f64, usize)>,
    /// Newton's measured rate \[1/m\].
    pub rate: Option<f64>,
    /// Work so far.
    #[serde(rename = "tally")]
    pub work_counts: WorkCounts,
}
