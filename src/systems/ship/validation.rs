//! The ship's motion against published values: rows of the validation table.

use super::model::Ship;
use super::motion_analysis::{MotionAnalysis, MotionError};
use super::quantities::{quantity, unit};
use crate::published::ValidationRow;

/// A row for every published value, in the order of the file.
#[must_use]
pub fn rows(
    ship: &Ship,
    motion: Option<&Result<MotionAnalysis, MotionError>>,
) -> Vec<ValidationRow> {
    let computed = |name: &str| match motion {
        None => Err("The file has no [motion], or its analysis is still running.".to_owned()),
        Some(Err(error)) => Err(format!("The motion analysis failed: {error}.")),
        // A record is a sum of components, exact to rounding.
        Some(Ok(motion)) => quantity(motion, name)
            .map(|value| (value, Some(0.0)))
            .ok_or_else(|| format!("There is no quantity {name}.")),
    };
    let published = ship.published.iter();
    let common = ship.ship.tolerance_reason.as_deref();
    published
        .map(|printed| printed.held(unit(&printed.quantity), computed(&printed.quantity)))
        .map(|row| row.with_common_reason(common))
        .collect()
}
