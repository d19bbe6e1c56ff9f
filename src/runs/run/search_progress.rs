//! How far the search for an accuracy is, in numbers and in words.

use serde::{Deserialize, Serialize};

/// How far the search for an accuracy is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SearchProgress {
    /// The round that begins, from 1.
    pub round: usize,
    /// The accuracy asked.
    pub asked: f64,
    /// The best reached so far, once a round is complete.
    pub reached: Option<f64>,
}

impl std::fmt::Display for SearchProgress {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { round, asked, .. } = self;
        write!(f, "accuracy {asked:e}: round {round}")?;
        match self.reached {
            Some(reached) => write!(f, ", {reached:.1e} reached"),
            None => Ok(()),
        }
    }
}
