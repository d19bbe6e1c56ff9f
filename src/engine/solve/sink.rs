//! Receives the accepted steps of a solver, and may stop it: the only coupling to threads, progress bars and files.

use super::State;

/// An accepted instant, of a line or of what has a state of another kind.
#[derive(Debug)]
pub struct AcceptedStep<'a, X = State> {
    /// Time \[s\].
    pub time: f64,
    /// The state at that time.
    pub state: &'a X,
    /// Steps accepted so far.
    pub steps: u64,
    /// Whether a whole step of the march ends here: the start, and times that do not depend on how steps are halved.
    pub whole: bool,
}

impl<X> Clone for AcceptedStep<'_, X> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<X> Copy for AcceptedStep<'_, X> {}

/// Whether the solver continues.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progressing {
    /// Continue.
    Continue,
    /// Stop after this step.
    Stop,
}

/// Receives every accepted step.
pub trait Sink<X = State> {
    /// Called at the start and after every accepted step.
    fn accept(&mut self, instant: AcceptedStep<'_, X>) -> Progressing;

    /// Called after an accepted step at time t \[s\] where velocities, accelerations or forces jump, with the state after the jump.
    fn jump(&mut self, _time: f64, _state: &X) {}
}

impl<X, F: FnMut(AcceptedStep<'_, X>) -> Progressing> Sink<X> for F {
    fn accept(&mut self, instant: AcceptedStep<'_, X>) -> Progressing {
        self(instant)
    }
}
