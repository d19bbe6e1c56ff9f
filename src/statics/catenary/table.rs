//! A table of single lines: CSV in, the same rows with their forces out.
//!
//! Columns are found by name, in any order. A row that cannot be read or has no answer keeps its place and
//! says why in `status`, with line and column; it never stops the others.

use std::io;

use csv::{ByteRecord, ReaderBuilder, StringRecord, Terminator, WriterBuilder};
use rayon::prelude::*;
use thiserror::Error;

use super::{Bed, Ends, Line, Refusal, SectionProps, Solution};

/// Columns that must be there.
const NEEDED: [&str; 5] = ["x_m", "z_m", "length_m", "ea_n", "weight_n_per_m"];
/// Columns that may be left out or empty.
const OPTIONAL: [&str; 4] = [
    "friction",
    "bed_below_a_m",
    "bed_slope_deg",
    "surface_above_a_m",
];
/// Columns that are written; already present in the input they are left out of what is passed through.
const ANSWERS: [&str; 7] = [
    "h_b_n", "v_b_n", "h_a_n", "v_a_n", "on_bed_m", "status", "shape",
];

/// Why there is no table at all.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TableFault {
    /// Columns are missing from the first line.
    #[error("the first line must name the columns; missing: {0}")]
    Columns(String),
    /// A column stands there twice.
    #[error("column {0} is named twice in the first line")]
    Twice(String),
    /// The table could not be read or written.
    #[error(transparent)]
    Csv(#[from] csv::Error),
}

/// What was written.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Written {
    /// The table, as CSV.
    pub text: Vec<u8>,
    /// Rows in it.
    pub rows: usize,
    /// Rows without an answer.
    pub refused: usize,
}

/// Solves every row of a table; on all cores, rows in their order.
///
/// In: `x_m, z_m, length_m, ea_n, weight_n_per_m` and, where wanted, `friction`, `bed_below_a_m` (empty: no bed),
/// `bed_slope_deg` (positive uphill from A to B), `surface_above_a_m` (for floating lines). Any other column
/// is passed through. Out: the input columns, then `h_b_n, v_b_n, h_a_n, v_a_n, on_bed_m`, `status` (`ok`, or why
/// not) and `shape`. Signs as in [`Solution`].
///
/// # Errors
/// [`TableFault`] when the columns are not there or the bytes are no table.
pub fn solve_table(input: &[u8]) -> Result<Written, TableFault> {
    let input = input.strip_prefix(b"\xef\xbb\xbf").unwrap_or(input);
    let mut reader = ReaderBuilder::new().flexible(true).from_reader(input);
    let head = StringRecord::from_byte_record_lossy(reader.byte_headers()?.clone());
    let columns = Columns::find(&head)?;
    let rows: Vec<ByteRecord> = reader.byte_records().collect::<Result<_, _>>()?;
    let answers: Vec<Answer> = rows.par_iter().map(|row| columns.answer(row)).collect();
    write(&columns, &head, &rows, &answers).map_err(TableFault::from)
}

/// Where the columns are.
struct Columns {
    count: usize,
    needed: [usize; 5],
    optional: [Option<usize>; 4],
    /// Columns that are passed through.
    kept: Vec<usize>,
}

/// A row's line, or what is wrong with the row.
type Answer = Result<Solution, String>;

impl Columns {
    fn find(head: &StringRecord) -> Result<Self, TableFault> {
        let name = |i: usize| head[i].trim().to_ascii_lowercase();
        let names: Vec<String> = (0..head.len()).map(name).collect();
        let place = |wanted: &str| names.iter().position(|name| name == wanted);
        let missing: Vec<&str> = NEEDED
            .into_iter()
            .filter(|name| place(name).is_none())
            .collect();
        if !missing.is_empty() {
            return Err(TableFault::Columns(missing.join(", ")));
        }
        for known in NEEDED.iter().chain(&OPTIONAL) {
            if names.iter().filter(|name| name == known).count() > 1 {
                return Err(TableFault::Twice((*known).to_string()));
            }
        }
        Ok(Self {
            count: head.len(),
            needed: NEEDED.map(|name| place(name).unwrap_or(usize::MAX)),
            optional: OPTIONAL.map(place),
            kept: (0..head.len())
                .filter(|&i| !ANSWERS.contains(&names[i].as_str()))
                .collect(),
        })
    }

    fn answer(&self, row: &ByteRecord) -> Answer {
        let line = row.position().map_or(0, csv::Position::line);
        if row.len() != self.count {
            return Err(format!(
                "line {line}: {} cells where the first line names {} columns",
                row.len(),
                self.count
            ));
        }
        let at = |column: &str, what: String| format!("line {line}, column {column}: {what}");
        let number = |place: usize, column: &str| {
            let text = String::from_utf8_lossy(&row[place]);
            let text = text.trim();
            match text.parse::<f64>() {
                Ok(value) => Ok(value),
                Err(_) if text.is_empty() => Err(at(column, "empty; a number is needed".into())),
                Err(_) => Err(at(column, format!("\"{text}\" is not a number"))),
            }
        };
        let mut needed = [0.0; 5];
        for (i, value) in needed.iter_mut().enumerate() {
            *value = number(self.needed[i], NEEDED[i])?;
        }
        let mut optional = [None; 4];
        for (i, value) in optional.iter_mut().enumerate() {
            let given = self.optional[i].filter(|&place| !row[place].trim_ascii().is_empty());
            *value = given.map(|place| number(place, OPTIONAL[i])).transpose()?;
        }
        let [friction, below, slope, surface_above_a_m] = optional;
        if below.is_none() && slope.is_some_and(|slope| slope != 0.0) {
            return Err(at(
                "bed_slope_deg",
                "there is a slope but no bed; give bed_below_a_m, 0 for a bed through A".into(),
            ));
        }
        let [x_m, z_m, length, ea, weight] = needed;
        let section = [SectionProps::new(length, weight, ea)];
        let row = Line {
            ends: Ends { x_m, z_m },
            sections: &section,
            bed: below.map(|below_a_m| Bed {
                below_a_m,
                slope_rad: slope.unwrap_or(0.0).to_radians(),
                friction: friction.unwrap_or(0.0),
            }),
            surface_above_a_m,
        };
        row.solve().map_err(|refusal| match column(&refusal) {
            Some(column) => at(column, refusal.to_string()),
            None => format!("line {line}: {refusal}"),
        })
    }
}

/// The column a refused number stands in.
fn column(refusal: &Refusal) -> Option<&'static str> {
    let Refusal::Input { quantity, .. } = refusal else {
        return None;
    };
    Some(match quantity.split(" [").next()? {
        "x of end B" => "x_m",
        "z of end B" => "z_m",
        "the unstretched length" => "length_m",
        "the weight per metre" => "weight_n_per_m",
        "the axial stiffness EA" => "ea_n",
        "the depth of the bed below A" => "bed_below_a_m",
        "the slope of the bed" => "bed_slope_deg",
        "the friction of the bed" => "friction",
        _ => return None,
    })
}

fn write(
    columns: &Columns,
    head: &StringRecord,
    rows: &[ByteRecord],
    answers: &[Answer],
) -> Result<Written, csv::Error> {
    let mut writer = WriterBuilder::new()
        .terminator(Terminator::Any(b'\n'))
        .from_writer(Vec::with_capacity(200 * rows.len() + 200));
    let names = columns.kept.iter().map(|&i| &head[i]);
    writer.write_record(names.chain(ANSWERS))?;
    for (row, answer) in rows.iter().zip(answers) {
        for &i in &columns.kept {
            writer.write_field(row.get(i).unwrap_or_default())?;
        }
        match answer {
            Ok(s) => {
                for value in [s.h_b_n, s.v_b_n, s.h_a_n, s.v_a_n, s.on_bed_m] {
                    // Adding zero turns -0 into 0.
                    writer.write_field(format!("{}", value + 0.0))?;
                }
                writer.write_field("ok")?;
                writer.write_field(s.shape_name())?;
            }
            Err(words) => {
                for _ in 0..5 {
                    writer.write_field("")?;
                }
                writer.write_field(words)?;
                writer.write_field("")?;
            }
        }
        writer.write_record(None::<&[u8]>)?;
    }
    let text = writer
        .into_inner()
        .map_err(|e| io::Error::other(e.to_string()))?;
    Ok(Written {
        text,
        rows: rows.len(),
        refused: answers.iter().filter(|answer| answer.is_err()).count(),
    })
}
