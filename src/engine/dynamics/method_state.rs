//! What a method keeps from step to step beside the state of the system, so that a march resumes to the same bits.

use serde::{Deserialize, Serialize};

use super::WorkCounts;
use crate::numerics::V3;
use crate::solve::ConvergenceRate;

/// Saved state of a method; every method has its own part of it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct MethodState {
    /// Generalized-alpha: rate of the acceleration over the step before, part by part \[m/s³\].
    pub jerk: Vec<Vec<V3>>,
    /// Generalized-alpha: weight of the jerk in the predictor, 1, or 0 after a step that could not be solved.
    pub jerk_weight: f64,
    /// Quasi-static march: length of the step before \[s\].
    pub last_step: Option<f64>,
    /// Quasi-static march: the displacements of that step, part by part \[m\].
    pub displaced: Vec<Vec<V3>>,
    /// Quasi-static march: whether drag coefficients are frozen.
    pub drag_is_frozen: bool,
    /// RK4: the fastest decay at the end of the step before \[1/s\] and its node.
    #[serde(default)]
    pub decay: Option<(f64, usize)>,
    /// Newton's measured rate of convergence.
    pub rate: Option<ConvergenceRate>,
    /// Work so far.
    pub work_counts: WorkCounts,
}

impl MethodState {
    /// Whether it is of a system whose parts have these numbers of nodes, and all of its numbers are finite.
    #[must_use]
    pub fn fits(&self, nodes: &[usize]) -> bool {
        let lists = [&self.jerk, &self.displaced];
        let sizes = |list: &Vec<Vec<V3>>| list.iter().map(Vec::len).eq(nodes.iter().copied());
        let mut numbers = lists.iter().flat_map(|list| list.iter().flatten());
        lists.iter().all(|list| list.is_empty() || sizes(list))
            && numbers.all(|vector| vector.iter().all(|number| number.is_finite()))
    }
}
