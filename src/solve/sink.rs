//! Receives the accepted steps of a solver, and may stop it: the only coupling to threads, progress bars and files.

use super::State;

/// An accepted instant.
#[derive(Debug, Clone, Copy)]
pub struct AcceptedStep<'a> {
    /// Time \[s\].
    pub time: f64,
    /// The state at that time.
    pub state: &'a State,
    /// Steps accepted so far.
    pub steps: u64,
    /// Whether a whole step of the march ends here: the start, and times that do not depend on how steps are halved.
    pub whole: bool,
}

/// Whether the solver continues.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progressing {
    /// Continue.
    Continue,
    /// Stop after this step.
    Stop,
}

/// Receives every accepted step.
pub trait Sink {
    /// Called at the start and after every accepted step.
    fn accept(&mut self, instant: AcceptedStep<'_>) -> Progressing;

    /// Called after an accepted step at time t \[s\] where velocities, accelerations or forces jump, with the state after the jump.
    fn jump(&mut self, _time: f64, _state: &State) {}
}

impl<F: FnMut(AcceptedStep<'_>) -> Progressing> Sink for F {
    fn accept(&mut self, instant: AcceptedStep<'_>) -> Progressing {
        self(instant)
    }
}
