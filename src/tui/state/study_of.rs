//! What a study is of, and how far it is.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::case::QuantityId;

/// What a study varies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StudyOf {
    /// Every input.
    Inputs,
    /// Every effect of the scene, left out.
    Physics,
}

impl StudyOf {
    /// The title of its page.
    #[must_use]
    pub fn title(self, result: &QuantityId) -> String {
        match self {
            Self::Inputs => format!("what matters to {result}"),
            Self::Physics => format!("what {result} needs"),
        }
    }
}

/// A study that computes behind the screen.
#[derive(Debug, Clone)]
pub struct RunningStudy {
    /// What it varies.
    pub of: StudyOf,
    /// Stops it.
    pub cancel: Arc<AtomicBool>,
    /// Variants computed so far.
    pub done: usize,
    /// All variants; 0 before they are known.
    pub all: usize,
}

impl RunningStudy {
    /// A study that begins.
    #[must_use]
    pub const fn new(of: StudyOf, cancel: Arc<AtomicBool>) -> Self {
        Self {
            of,
            cancel,
            done: 0,
            all: 0,
        }
    }
}
