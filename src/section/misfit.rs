//! What does not fit in a section, and how sizes are worded.

use std::fmt;

use crate::case::join;
use crate::report::number::digits;

/// Something about a section that cannot be, or should be looked at.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Misfit {
    /// The key meant, as the parts of its path: `["layer", "bundle", "pitch_radius_m"]`.
    pub path: Vec<String>,
    /// What is wrong.
    pub problem: String,
    /// What would be right.
    pub remedy: String,
}

impl Misfit {
    pub(super) fn new(
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

    /// The key path as one word: `layer.bundle.pitch_radius_m`.
    #[must_use]
    pub fn key(&self) -> String {
        join(&self.path)
    }
}

impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}; {}", self.key(), self.problem, self.remedy)
    }
}

/// A length in millimetres, for people: `23.12 mm`.
pub(super) fn mm(metres: f64) -> String {
    format!("{} mm", digits(metres * 1e3, 4))
}

/// An angle in degrees, for people: `10 deg`.
pub(super) fn degrees(radians: f64) -> String {
    format!("{} deg", digits(radians.to_degrees(), 4))
}

/// A length as a number for the file that is not smaller than it: `0.02312`.
pub(super) fn at_least(metres: f64) -> String {
    let step = 1e-5_f64;
    digits((metres / step - 1e-6).ceil() * step, 9)
}

/// A length as a number for the file that is not greater than it.
pub(super) fn at_most(metres: f64) -> String {
    let step = 1e-5_f64;
    digits((metres / step + 1e-6).floor() * step, 9)
}
