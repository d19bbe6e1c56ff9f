//! How far a march has come, for checkpoints and for the step control.

use serde::{Deserialize, Serialize};

/// Greatest number of times a step that cannot be solved is halved.
pub(super) const MAX_HALVINGS: u32 = 14;

/// Step lengths of a march: the whole step, and halved up to [`MAX_HALVINGS`] times.
const LENGTHS: usize = MAX_HALVINGS as usize + 1;

/// How far a march has come.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct MarchProgress {
    /// Time at which the whole step began that is being taken \[s\].
    pub time: f64,
    /// Whole steps completed.
    pub whole: u64,
    /// Steps of the present length taken of the whole step.
    #[serde(default)]
    pub done: u64,
    /// How many times whole steps are halved at present.
    pub level: u32,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Accepted steps of each length, halved 0, 1, 2 ... times.
    #[serde(default)]
    pub halved: [u64; LENGTHS],
}

impl MarchProgress {
    /// Whether a march comes to this: no more halvings than there are, and a part of a whole step taken.
    #[must_use]
    pub fn is_possible(&self) -> bool {
        self.level <= MAX_HALVINGS && self.done <= 1 << self.level && self.time.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_march_takes_no_more_parts_of_a_step_than_there_are() {
        let at = |level, done, time| MarchProgress {
            level,
            done,
            time,
            ..MarchProgress::default()
        };
        assert!(at(0, 1, 0.0).is_possible());
        assert!(at(3, 8, 2.0).is_possible());
        assert!(!at(3, 9, 2.0).is_possible());
        assert!(at(MAX_HALVINGS, 1 << MAX_HALVINGS, 2.0).is_possible());
        assert!(!at(MAX_HALVINGS + 1, 0, 2.0).is_possible());
        assert!(!at(0, 0, f64::NAN).is_possible());
    }
}
