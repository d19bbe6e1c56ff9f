//! What cannot be as a file says, found only once its words are worked out.

use std::fmt;

use super::diagnostic::Finding;
use super::tree::Node;
use super::{join, split};

/// Something that cannot be as the file says, or should be looked at.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InvalidValue {
    /// The key meant, as the parts of its path: `["layer", "bundle", "pitch_radius_m"]`.
    pub path: Vec<String>,
    /// What is wrong.
    pub problem: String,
    /// What would be right.
    pub remedy: String,
}

impl InvalidValue {
    pub(crate) fn new(
        path: &[&str],
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self {
            path: path.iter().map(|part| (*part).to_owned()).collect(),
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }

    /// At a key path given as one word.
    pub(crate) fn at(key: &str, problem: impl Into<String>, remedy: impl Into<String>) -> Self {
        let parts = split(key).unwrap_or_default();
        let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
        Self::new(&parts, problem, remedy)
    }

    /// The key path as one word: `layer.bundle.pitch_radius_m`.
    #[must_use]
    pub fn key(&self) -> String {
        join(&self.path)
    }

    /// The finding at the key meant, or, when that is not written, at the table it belongs to.
    pub(crate) fn found(&self, tree: &Node) -> Finding {
        let depth = self.path.len();
        let node = (0..=depth)
            .rev()
            .find_map(|parts| tree.find(self.path.get(..parts)?));
        let span = node.map_or(0..0, |node| node.span.clone());
        Finding::new(&span, self.key(), &self.problem, &self.remedy)
    }
}

impl fmt::Display for InvalidValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}; {}", self.key(), self.problem, self.remedy)
    }
}
