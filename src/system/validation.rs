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
            // Closed forms are exact to rounding; the mesh error of derived results is not estimated.
            let error = (!solved.is_discretised()).then_some(0.0);
            let found = value(solved, &printed.quantity).map(|value| (value, error));
            printed.held(unit(&printed.quantity), found)
        })
        .collect()
}
