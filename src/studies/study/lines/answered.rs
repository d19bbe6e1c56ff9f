//! Answers of a table of lines, and why a table has none.

use crate::{limits::Limit, statics::catenary::Solution};
use thiserror::Error;

/// Why bytes are no table of lines.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TableError {
    /// Columns are missing from the first line.
    #[error("the first line must name the columns; missing: {0}")]
    Missing(String),
    /// A column is named twice.
    #[error("column {0} is named twice in the first line")]
    Twice(String),
    /// There are more lines than allowed.
    #[error("the table has {0} lines; {1}")]
    TooMany(f64, String),
    /// The table could not be read or written.
    #[error(transparent)]
    Csv(#[from] csv::Error),
}

/// A table with its answers.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct AnsweredTable {
    /// The table, as CSV or JSON lines.
    pub text: Vec<u8>,
    /// Rows in it.
    pub rows: usize,
    /// Rows without an answer.
    pub refused: usize,
}

/// What a line in a current is answered with, and `status`.
pub(super) const END_FORCES_AND_STATUS: [&str; 11] = [
    "pull_a_x_n",
    "pull_a_y_n",
    "pull_a_z_n",
    "pull_b_x_n",
    "pull_b_y_n",
    "pull_b_z_n",
    "tension_a_n",
    "tension_b_n",
    "error_n",
    "segments",
    "status",
];

/// A number as it is written; adding zero turns -0 into 0.
pub(super) fn shown(number: f64) -> String {
    format!("{}", number + 0.0)
}

/// H and V at B, H and V at A \[N\], length on the bed \[m\].
pub(super) fn at_rest(solution: &Solution) -> [f64; 5] {
    let s = solution;
    [s.h_b_n, s.v_b_n, s.h_a_n, s.v_a_n, s.on_bed_m]
}

/// Refuses a table of more lines than allowed, before the first is solved.
pub(super) fn check_count(limit: &Limit, lines: usize) -> Result<(), TableError> {
    let lines = lines as f64;
    match limit.is_exceeded_by(lines) {
        true => Err(TableError::TooMany(
            lines,
            limit.remedy("give it in parts", lines),
        )),
        false => Ok(()),
    }
}
