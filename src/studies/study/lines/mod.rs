//! Tables of lines at rest, a line a row: CSV of single lines in still water, CSV of single lines in a current, and JSON
//! lines of either kind with several sections.
//!
//! A row that cannot be read or has no answer keeps its place, with the reason in `status`; it never stops the others.

mod answered;
mod current_table;
mod in_current;
mod object;
mod still_table;
mod table;

pub use in_current::{EndForces, LineInCurrent};

use crate::limits::{LINES, LINES_IN_CURRENT};
use answered::check_count;
pub use answered::{AnsweredTable, TableError};
use rayon::prelude::*;

/// Solves every line of a table in CSV or of JSON lines, distinguished by their first character; on all cores, in order.
///
/// CSV of lines in still water needs `x_m, z_m, length_m, ea_n, weight_n_per_m` and may have `friction`,
/// `bed_below_a_m`, `bed_slope_deg`, `surface_above_a_m`; any other column is passed through. The answer adds
/// `h_b_n, v_b_n, h_a_n, v_a_n, on_bed_m`, `status` (`ok`, or why not) and `shape`, with the signs of
/// [`Solution`](crate::statics::catenary::Solution).
///
/// # Errors
/// [`TableError`] when the columns are not there or the bytes are no table.
pub fn solve(input: &[u8]) -> Result<AnsweredTable, TableError> {
    let input = input.strip_prefix(b"\xef\xbb\xbf").unwrap_or(input);
    if input.trim_ascii_start().first() == Some(&b'{') {
        return objects(&String::from_utf8_lossy(input));
    }
    let layout = if current_table::recognises(input) {
        current_table::LAYOUT
    } else {
        still_table::LAYOUT
    };
    table::solve(input, &layout)
}

/// JSON lines with their answers added; blank lines and notes (objects with none of the keys of a line) stay as they are.
fn objects(text: &str) -> Result<AnsweredTable, TableError> {
    let lines: Vec<&str> = text.lines().collect();
    check_count(&LINES, lines.len())?;
    let in_current = lines.iter().filter(|line| line.contains("\"current\""));
    check_count(&LINES_IN_CURRENT, in_current.count())?;
    let answers: Vec<object::AnsweredLine> = lines
        .par_iter()
        .enumerate()
        .map(|(i, line)| object::answer(line, i + 1))
        .collect();
    let mut answered = AnsweredTable::default();
    for answer in answers {
        answered.rows += usize::from(answer.is_line);
        answered.refused += usize::from(answer.refused);
        answered.text.extend_from_slice(answer.text.as_bytes());
        answered.text.push(b'\n');
    }
    Ok(answered)
}
