//! A system compared with its published values: rows of the validation table.

use super::quantities::{unit, value};
use super::solved::SolvedSystem;
use crate::reference::ValidationRow;

/// Rows for every published value of a system, in the order of its file.
#[must_use]
pub fn rows(solved: &SolvedSystem) -> Vec<ValidationRow> {
    let printed = solved.file.published.iter();
    printed
        .map(|printed| {
            // Closed forms are exact to rounding.
            let found = value(solved, &printed.quantity).map(|value| (value, Some(0.0)));
            printed.held(unit(&printed.quantity), found)
        })
        .collect()
}
