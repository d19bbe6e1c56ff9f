//! What a study is of.

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
