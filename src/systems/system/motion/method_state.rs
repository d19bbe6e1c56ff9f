//! What a method carries from step to step.

use crate::{numerics::V3, solve::ConvergenceRate};
use serde::{Deserialize, Serialize};

/// What a method takes from one step to the next.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct MethodState {
    /// Newton iterations so far.
    pub iterations: u64,
    /// Evaluations of an explicit method so far.
    pub evaluations: u64,
    /// Rate of Newton's convergence.
    #[serde(rename = "convergence")]
    pub rate: Option<ConvergenceRate>,
    /// Weight of the jerk in the prediction.
    pub jerk_weight: f64,
    /// Rates of the accelerations over the step before, part by part \[m/s³\]; empty for other methods than generalized-alpha.
    pub jerk: Vec<Vec<V3>>,
    /// Length of the last accepted step of a quasi-static march \[s\], and its displacements, part by part \[m\].
    #[serde(default)]
    pub last_step: Option<f64>,
    /// See [`MethodState::last_step`].
    #[serde(default)]
    pub displaced: Vec<Vec<V3>>,
    /// Whether such a march has velocities at which drag coefficients are frozen.
    #[serde(default)]
    pub drag_is_frozen: bool,
}
