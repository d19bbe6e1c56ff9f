//! What the time march asks of a method of time integration.

use serde::{Deserialize, Serialize};

use super::MethodState;
use crate::solve::{Marched, NewtonError};

/// A method of time integration: its work so far, and the state to restart it from.
pub trait Integrator {
    /// Work done so far.
    fn work_counts(&self) -> WorkCounts;

    /// What the method keeps from step to step beside the state of the system.
    fn method_state(&self) -> MethodState {
        MethodState::default()
    }

    /// Restores what [`Integrator::method_state`] saved.
    fn restore(&mut self, _saved: &MethodState) {}
}

/// A method that takes steps of systems of the kind S.
pub trait Stepper<S: Marched>: Integrator {
    /// Moves `state` from t to t + dt and returns the estimated error of the step relative to the error limits (0 if the
    /// method has none). A step with a ratio above 1 is rejected if `at.reject`. A failed step leaves `state` as it was.
    ///
    /// # Errors
    /// Why the step fails at this length.
    fn step(&mut self, system: &S, at: TimeStep, state: &mut S::State) -> Result<f64, StepError>;

    /// Accelerations at time t \[s\] from positions and velocities, by the forces; a method without inertia has none.
    ///
    /// # Errors
    /// Where nothing has mass.
    fn accelerate(
        &mut self,
        _system: &S,
        _t: f64,
        _state: &mut S::State,
    ) -> Result<(), NewtonError> {
        Ok(())
    }

    /// Restarts the method at time t \[s\] where the system has changed and its forces are discontinuous.
    fn restart(&mut self, system: &S, t: f64, state: &mut S::State);

    /// Passes a kink of the prescribed motion at time t \[s\]
    /// ([`Kinematics::pass_kink`](crate::solve::Kinematics::pass_kink)), and continues the method after it. Returns whether a
    /// velocity jumps.
    ///
    /// Positions are continuous, and the velocities of free nodes are too: a prescribed node has no inertia that counts. The forces
    /// that depend on its velocity, the axial damping of the segment at it, jump with it, and so do the accelerations of free nodes.
    fn pass_kink(&mut self, system: &S, t: f64, state: &mut S::State) -> bool;
}

/// A step to take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimeStep {
    /// Start of the step \[s\].
    pub t: f64,
    /// Length of the step \[s\].
    pub dt: f64,
    /// Whether the step is rejected if its error exceeds the limits; not if it is the shortest allowed.
    pub reject: bool,
}

/// Why a step fails.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum StepError {
    /// Its equations were not solved.
    #[error(transparent)]
    Unsolved(#[from] NewtonError),
    /// Its estimated error exceeds the limits by this factor.
    #[error("the estimated error is {0:.3} of what is allowed")]
    Inaccurate(f64),
}

/// Machine-independent work of a method.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct WorkCounts {
    /// Newton iterations.
    pub iterations: u64,
    /// Evaluations of the explicit right-hand side.
    pub evaluations: u64,
}
