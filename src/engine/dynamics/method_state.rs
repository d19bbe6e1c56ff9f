//! What a method keeps from step to step beside the state of the system, so that a march resumes to the same bits.

use serde::{Deserialize, Serialize};

use super::WorkCounts;
use crate::numerics::V3;
use crate::solve::ConvergenceRate;

/// Saved state of a method; every method has its own part of it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct MethodState {
    /// Generalized-alpha: rate of the acceleration over the step before \[m/s³\].
    pub jerk: Vec<V3>,
    /// Generalized-alpha: weight of the jerk in the predictor, 1, or 0 after a step that could not be solved.
    #[serde(rename = "trust")]
    pub jerk_weight: f64,
    /// Quasi-static march: length of the step before \[s\].
    #[serde(rename = "before")]
    pub last_step: Option<f64>,
    /// Quasi-static march: positions one step back \[m\].
    pub x_before: Vec<V3>,
    /// Quasi-static march: whether drag coefficients are frozen.
    #[serde(rename = "remembers")]
    pub drag_is_frozen: bool,
    /// RK4: the fastest decay at the end of the step before \[1/s\] and its node.
    #[serde(default)]
    pub decay: Option<(f64, usize)>,
    /// Newton's measured rate of convergence.
    #[serde(rename = "convergence")]
    pub rate: Option<ConvergenceRate>,
    /// Work so far.
    #[serde(rename = "tally")]
    pub work_counts: WorkCounts,
}
