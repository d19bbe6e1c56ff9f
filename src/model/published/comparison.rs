//! The comparison of a published number with a computed one.

use super::row::{Outcome, ValidationRow};

/// A computed number is good evidence when its own error is at most this part of the tolerance.
const ERROR_SHARE: f64 = 0.1;

/// Compares a computed value, with its numerical error where that is known, with the published one of a row; without a value
/// the row reads NOT RUN, with the reason.
#[must_use]
pub fn compare(
    mut row: ValidationRow,
    out_of_reach: Option<&str>,
    computed: Result<(f64, Option<f64>), String>,
) -> ValidationRow {
    match computed {
        Err(reason) => row.reason = Some(reason),
        Ok(computed) => judge(&mut row, out_of_reach, computed),
    }
    row
}

/// The greatest difference that passes; with both tolerances given, the wider one.
pub fn tolerance(value: f64, relative: Option<f64>, absolute: Option<f64>) -> f64 {
    match (relative.map(|t| t * value.abs()), absolute) {
        (Some(r), Some(a)) => r.max(a),
        (r, a) => r.or(a).unwrap_or(0.0),
    }
}

fn judge(row: &mut ValidationRow, out_of_reach: Option<&str>, (value, error): (f64, Option<f64>)) {
    let tolerance = row.tolerance.unwrap_or(0.0);
    let difference = value - row.published.unwrap_or(0.0);
    let within = difference.abs() <= tolerance;
    row.computed = Some(value);
    row.error = error;
    row.difference = Some(difference);
    (row.outcome, row.reason) = match (within, out_of_reach) {
        (true, None) => (Outcome::Pass, None),
        (true, Some(_)) => (Outcome::Pass, Some(REACHED.to_owned())),
        (false, None) => (Outcome::Fail, None),
        (false, Some(reason)) => (Outcome::Differs, Some(reason.to_owned())),
    };
    if row
        .error
        .is_some_and(|error| error > ERROR_SHARE * tolerance)
    {
        let note = "Its estimated numerical error is more than a tenth of the tolerance.";
        row.reason = Some(match row.reason.take() {
            Some(reason) => format!("{reason} {note}"),
            None => note.to_owned(),
        });
    }
}

/// Why a row reads PASS though its case states that it cannot.
pub const REACHED: &str =
    "The case declares this out of reach, and yet it is reached: the declaration can go.";
