//! A ship's motion held against what its source printed: rows of the validation table.

use super::model::Ship;
use super::motion_analysis::{MotionAnalysis, MotionError};
use super::quantities::{quantity, unit};
use crate::reference::ValidationRow;

/// Rows for every published value of a ship, in the order of its file.
#[must_use]
pub fn rows(
    ship: &Ship,
    motion: Option<&Result<MotionAnalysis, MotionError>>,
) -> Vec<ValidationRow> {
    let found = |name: &str| match motion {
        None => Err("The file has no [motion], or it is still being worked out.".to_owned()),
        Some(Err(why)) => Err(format!("There is no such motion: {why}.")),
        // A record is summed to rounding.
        Some(Ok(motion)) => quantity(motion, name)
            .map(|value| (value, Some(0.0)))
            .ok_or_else(|| format!("There is no quantity {name}.")),
    };
    let published = ship.published.iter();
    published
        .map(|printed| printed.held(unit(&printed.quantity), found(&printed.quantity)))
        .collect()
}
