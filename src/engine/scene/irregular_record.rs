//! Irregular records of a case.

use crate::physics::sea::{Component, Spectrum};

/// An irregular record of a case and its components.
#[derive(Debug, Clone, PartialEq)]
pub struct IrregularRecord {
    /// `waves`, or an end with its axis.
    pub name: String,
    /// Whether it is of waves, reported by their height, or of a motion, reported by its root mean square.
    pub of_waves: bool,
    /// Seed of its frequencies and phases.
    pub seed: u64,
    /// The spectrum asked for.
    pub spectrum: Spectrum,
    /// Its components.
    pub components: Vec<Component>,
}
