//! Tables of lines at rest, a line a row: CSV of single lines in still water (see [`solve_table`]), CSV of single lines in a
//! current, and JSON lines of either kind with several sections.
//!
//! A row that cannot be read or has no answer keeps its place and says why in `status`; it never stops the others.

mod columns;
mod drift;
mod json;
mod object;

pub use drift::{InCurrent, Pulls};

use rayon::prelude::*;

use crate::statics::catenary::{TableFault, Written, solve_table};

/// Names and values of an answer, as text that CSV and JSON both take.
type Numbers = Vec<(&'static str, String)>;

/// What a line in a current is answered with.
const PULLS: [&str; 10] = [
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
];

impl Pulls {
    fn numbers(&self) -> [f64; 10] {
        let (a, b) = (self.a_n, self.b_n);
        let segments = self.segments as f64;
        [
            a.x,
            a.y,
            a.z,
            b.x,
            b.y,
            b.z,
            a.norm(),
            b.norm(),
            self.error_n,
            segments,
        ]
    }
}

/// Adding zero turns -0 into 0.
fn shown(number: f64) -> String {
    format!("{}", number + 0.0)
}

/// Solves every line of a table in CSV or of JSON lines, told apart by their first character; on all cores, in order.
///
/// # Errors
/// [`TableFault`] when the columns are not there or the bytes are no table.
pub fn solve(input: &[u8]) -> Result<Written, TableFault> {
    let input = input.strip_prefix(b"\xef\xbb\xbf").unwrap_or(input);
    if input.trim_ascii_start().first() == Some(&b'{') {
        return Ok(objects(&String::from_utf8_lossy(input)));
    }
    if columns::in_current(input) {
        return columns::solve(input);
    }
    solve_table(input)
}

/// JSON lines with their answers added; blank lines and notes (objects with none of the keys of a line) stay as they are.
fn objects(text: &str) -> Written {
    let lines: Vec<&str> = text.lines().collect();
    let answered: Vec<object::Answered> = lines
        .par_iter()
        .enumerate()
        .map(|(i, line)| object::answer(line, i + 1))
        .collect();
    let mut written = Written::default();
    for answer in answered {
        written.rows += usize::from(answer.is_line);
        written.refused += usize::from(answer.refused);
        written.text.extend_from_slice(answer.text.as_bytes());
        written.text.push(b'\n');
    }
    written
}
