//! A CSV table with a line a row: columns found by name in, the same rows with the columns of the answer out.

use std::io;

use csv::{ByteRecord, ReaderBuilder, StringRecord, Terminator, WriterBuilder};
use rayon::prelude::*;

use super::answered::{AnsweredTable, TableError, check_count, shown};
use crate::limits::Limit;

/// A column of numbers, by the names it may have.
pub(super) struct NumberColumn {
    pub names: &'static [&'static str],
    /// Whether every row needs a number; otherwise the column may be absent and a cell empty.
    pub required: bool,
}

impl NumberColumn {
    /// A column in which every row needs a number.
    pub(super) const fn required(names: &'static [&'static str]) -> Self {
        let required = true;
        Self { names, required }
    }

    /// A column that may be absent.
    pub(super) const fn optional(names: &'static [&'static str]) -> Self {
        let required = false;
        Self { names, required }
    }
}

/// Numbers of the answer to a row in the order of their columns, and its shape where there is such a column.
pub(super) struct RowAnswer {
    pub numbers: Vec<f64>,
    pub shape: &'static str,
}

/// Numbers of a row in the order of the columns of the layout.
pub(super) type RowNumbers = [Option<f64>; MOST_COLUMNS];

/// Greatest number of columns of a layout.
const MOST_COLUMNS: usize = 16;

/// The columns of a kind of table, and the answer to a row.
pub(super) struct LineTableFormat {
    pub columns: &'static [NumberColumn],
    /// Columns that are written: numbers, then `status`, then `shape` where there is one. Present in the input they are
    /// left out of what is passed through.
    pub answers: &'static [&'static str],
    /// Greatest number of rows.
    pub limit: &'static Limit,
    /// The answer to the numbers of a row.
    pub answer: fn(&RowNumbers) -> Result<RowAnswer, RowError>,
}

/// Why a row has no answer.
pub(super) struct RowError {
    /// The column that holds the fault, where it is one.
    pub column: Option<&'static str>,
    pub problem: String,
}

pub(super) fn reader(input: &[u8]) -> csv::Reader<&[u8]> {
    ReaderBuilder::new().flexible(true).from_reader(input)
}

/// Names of columns, trimmed and in small letters.
pub(super) fn names(head: &StringRecord) -> Vec<String> {
    head.iter()
        .map(|name| name.trim().to_ascii_lowercase())
        .collect()
}

/// Solves every row of a table; on all cores, rows in their order.
///
/// # Errors
/// [`TableError`] when the columns are not there or the bytes are no table.
pub(super) fn solve(input: &[u8], layout: &LineTableFormat) -> Result<AnsweredTable, TableError> {
    let mut reader = reader(input);
    let head = StringRecord::from_byte_record_lossy(reader.byte_headers()?.clone());
    let names = names(&head);
    let table = InputTable {
        layout,
        count: head.len(),
        places: places(layout.columns, &names)?,
    };
    let rows: Vec<ByteRecord> = reader.byte_records().collect::<Result<_, _>>()?;
    check_count(layout.limit, rows.len())?;
    let answers: Vec<Result<RowAnswer, String>> =
        rows.par_iter().map(|row| table.answer(row)).collect();
    let kept: Vec<usize> = (0..head.len())
        .filter(|&i| !layout.answers.contains(&names[i].as_str()))
        .collect();
    Ok(AnsweredTable {
        text: write(&head, &kept, &rows, layout.answers, &answers)?,
        rows: rows.len(),
        refused: answers.iter().filter(|answer| answer.is_err()).count(),
    })
}

/// Which column of the input each column of the layout is.
fn places(columns: &[NumberColumn], names: &[String]) -> Result<Vec<Option<usize>>, TableError> {
    let of = |column: &NumberColumn| -> Vec<usize> {
        let known = |i: &usize| column.names.contains(&names[*i].as_str());
        (0..names.len()).filter(known).collect()
    };
    let found: Vec<Vec<usize>> = columns.iter().map(of).collect();
    let each = || columns.iter().zip(&found);
    let missing: Vec<&str> = each()
        .filter(|(column, places)| column.required && places.is_empty())
        .map(|(column, _)| column.names[0])
        .collect();
    if !missing.is_empty() {
        return Err(TableError::Missing(missing.join(", ")));
    }
    if let Some((column, _)) = each().find(|(_, places)| places.len() > 1) {
        return Err(TableError::Twice(column.names[0].to_owned()));
    }
    Ok(found.iter().map(|places| places.first().copied()).collect())
}

struct InputTable<'a> {
    layout: &'a LineTableFormat,
    /// Columns of the input.
    count: usize,
    /// Where the columns of the layout are.
    places: Vec<Option<usize>>,
}

impl InputTable<'_> {
    fn answer(&self, row: &ByteRecord) -> Result<RowAnswer, String> {
        let line = row.position().map_or(0, csv::Position::line);
        if row.len() != self.count {
            return Err(format!(
                "line {line}: {} cells where the first line names {} columns",
                row.len(),
                self.count
            ));
        }
        let answer = self.numbers(row).and_then(|n| (self.layout.answer)(&n));
        answer.map_err(|RowError { column, problem }| match column {
            Some(column) => format!("line {line}, column {column}: {problem}"),
            None => format!("line {line}: {problem}"),
        })
    }

    fn numbers(&self, row: &ByteRecord) -> Result<RowNumbers, RowError> {
        let mut numbers = [None; MOST_COLUMNS];
        let columns = self.layout.columns.iter().zip(&self.places);
        for (number, (column, place)) in numbers.iter_mut().zip(columns) {
            if let Some(place) = *place {
                *number = cell(column, &row[place])?;
            }
        }
        Ok(numbers)
    }
}

/// The number in a cell; `None` where it is empty and may be.
fn cell(column: &NumberColumn, bytes: &[u8]) -> Result<Option<f64>, RowError> {
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim();
    let wrong = |problem: String| RowError {
        column: Some(column.names[0]),
        problem,
    };
    match text.parse() {
        Ok(number) => Ok(Some(number)),
        Err(_) if text.is_empty() && column.required => {
            Err(wrong("empty; a number is needed".to_owned()))
        }
        Err(_) if text.is_empty() => Ok(None),
        Err(_) => Err(wrong(format!("\"{text}\" is not a number"))),
    }
}

fn write(
    head: &StringRecord,
    kept: &[usize],
    rows: &[ByteRecord],
    columns: &[&str],
    answers: &[Result<RowAnswer, String>],
) -> Result<Vec<u8>, csv::Error> {
    let mut writer = WriterBuilder::new()
        .terminator(Terminator::Any(b'\n'))
        .from_writer(Vec::with_capacity(200 * rows.len() + 200));
    let names = kept.iter().map(|&i| &head[i]);
    writer.write_record(names.chain(columns.iter().copied()))?;
    for (row, answer) in rows.iter().zip(answers) {
        for &i in kept {
            writer.write_field(row.get(i).unwrap_or_default())?;
        }
        for (i, column) in columns.iter().enumerate() {
            match (answer, *column) {
                (Ok(_), "status") => writer.write_field("ok")?,
                (Ok(answer), "shape") => writer.write_field(answer.shape)?,
                (Ok(answer), _) => writer.write_field(shown(answer.numbers[i]))?,
                (Err(problem), "status") => writer.write_field(problem)?,
                (Err(_), _) => writer.write_field("")?,
            }
        }
        writer.write_record(None::<&[u8]>)?;
    }
    let text = writer
        .into_inner()
        .map_err(|e| io::Error::other(e.to_string()))?;
    Ok(text)
}
