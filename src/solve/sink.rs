//! Receives the accepted steps of a solver, and may stop it: the only coupling to threads, progress bars and files.

use super::State;

/// An accepted instant.
#[derive(Debug, Clone, Copy)]
pub struct Instant<'a> {
    /// Time \[s\].
    pub time: f64,
    /// The state at that time.
    pub state: &'a State,
    /// Steps accepted so far.
    pub steps: u64,
    /// Whether this is an output time.
    pub output: bool,
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
    /// Called after every accepted step, output times included.
    fn accept(&mut self, instant: Instant<'_>) -> Progressing;
}

impl<F: FnMut(Instant<'_>) -> Progressing> Sink for F {
    fn accept(&mut self, instant: Instant<'_>) -> Progressing {
        self(instant)
    }
}
