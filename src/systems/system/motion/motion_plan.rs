//! How a run of a system is computed, and what is recorded of it.

use super::moving_system::MovingSystem;
use super::system_bounds::bounds;
use crate::case::{PublishedCurve, QuantityId, Solver};
use crate::run::Settings;
use crate::run::response::AskedResponse;

/// How a run of a system is computed, and what is recorded of it.
#[derive(Debug, Clone)]
pub(super) struct MotionPlan {
    /// What its file asks of the solver.
    pub(super) solver: Solver,
    /// The settings that it uses.
    pub(super) settings: Settings,
    /// What is recorded of it.
    pub(super) recorded: MotionResults,
}

/// What is recorded of a run of a system beside its history.
#[derive(Debug, Clone, Default)]
pub(super) struct MotionResults {
    /// Least time between the shapes that are kept \[s\]; none where none are.
    pub(super) shape_interval_s: Option<f64>,
    /// From when on extremes are kept apart from those of the start \[s\]; nothing where they are not.
    pub(super) settled_from_s: Option<f64>,
    /// The results that the file holds against published values and limits.
    pub(super) stated: Vec<QuantityId>,
    /// The published curves that the run is held against, with their numbers from 0.
    pub(super) curves: Vec<(usize, PublishedCurve)>,
    /// The response of the lines, where it is asked for.
    pub(super) response: Option<AskedResponse>,
}

impl MotionPlan {
    /// What a file asks for, and what its system needs; nothing but the history, at this interval \[s\], is recorded.
    pub(super) fn new(solver: &Solver, interval_s: f64, system: &MovingSystem) -> Self {
        Self {
            solver: solver.clone(),
            settings: bounds(system).settings(solver, interval_s),
            recorded: MotionResults::default(),
        }
    }
}
