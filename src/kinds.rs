//! The kinds of file that seacable opens, distinguished by their first table.

use std::path::Path;

use crate::ropeway::is_ropeway;
use crate::section::is_section;
use crate::ship::is_ship;

/// What a TOML file describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A line case: [`crate::case`]. Also every file of no other kind, whose errors are then reported as those of a case.
    Line,
    /// A cross-section: [`crate::section`].
    Section,
    /// A ropeway: [`crate::ropeway`].
    Ropeway,
    /// A ship at single-point mooring: [`crate::ship`].
    Ship,
}

impl Kind {
    /// The kind of a file.
    #[must_use]
    pub fn of(path: &Path) -> Self {
        if is_section(path) {
            Self::Section
        } else if is_ropeway(path) {
            Self::Ropeway
        } else if is_ship(path) {
            Self::Ship
        } else {
            Self::Line
        }
    }
}
