//! The tutorial: steps on the screen itself, each done by what the user did.

mod progress;
mod steps;

pub use self::steps::{COUNT, TutorialStep};

/// The tutorial while it runs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tutorial {
    /// The step shown, from 0.
    pub step: usize,
    /// What was so when the step began.
    since: Since,
}

/// What a step is compared with: the state when it began.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Since {
    /// The text of the open file.
    text: String,
    /// How many stored runs were complete.
    runs: usize,
    /// How many messages there were.
    messages: usize,
}

/// Rows of the strip in which the step is shown.
pub const ROWS: u16 = 3;
