//! Where a solver pours what it computes: frames out, "stop" in. All that threads, bars, files and
//! cancelling need, and nothing a solver has to wait for.

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

/// Whether the solver is to go on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progressing {
    /// Go on.
    Continue,
    /// Stop after this step.
    Stop,
}

/// Takes every accepted step.
pub trait Sink {
    /// Called after every accepted step, output times included.
    fn accept(&mut self, instant: Instant<'_>) -> Progressing;
}

impl<F: FnMut(Instant<'_>) -> Progressing> Sink for F {
    fn accept(&mut self, instant: Instant<'_>) -> Progressing {
        self(instant)
    }
}
