//! Tables of numbers described by their columns: one description of a column serves writing and reading.
//!
//! Files are read by the names of their columns. A column that is missing is absent from the table, unless the table is
//! nothing without it; a column that is unknown is left out. A file of an older or newer version is read as far as both
//! versions agree.

use std::path::Path;

use super::StoreError;
use super::number::{parse, text};
use super::table::{CsvReader, CsvWriter, not_a_number};

/// A column of numbers of a table `T`.
pub(super) struct CsvColumn<T> {
    /// Name with unit, as in the file.
    pub(super) name: &'static str,
    /// Whether a table without it cannot be read; all its values are numbers.
    pub(super) required: bool,
    /// Whether a table writes it.
    pub(super) written: fn(&T) -> bool,
    /// Its values; fewer than rows where they are absent.
    pub(super) values: fn(&T) -> Vec<f64>,
    /// Sets its values.
    pub(super) set: fn(&mut T, Vec<f64>),
}

/// Describes a column held in a field of a table: `column!(Profile, "arc_m", arc, required)`.
macro_rules! column {
    ($table:ty, $name:literal, $field:ident, required) => {
        column!($table, $name, $field, true, |_| true)
    };
    ($table:ty, $name:literal, $field:ident, $written:expr) => {
        column!($table, $name, $field, false, $written)
    };
    ($table:ty, $name:literal, $field:ident, $required:literal, $written:expr) => {
        CsvColumn::<$table> {
            name: $name,
            required: $required,
            written: $written,
            values: |table| table.$field.clone(),
            set: |table, values| table.$field = values,
        }
    };
}
pub(super) use column;

/// The column of the name of a line, which tables of several lines begin with.
pub(super) const LINE: &str = "line";

/// The table of a line, by its name, with this many rows.
pub(super) type NamedLineTable<'a, T> = (&'a str, &'a T, usize);

/// The file of the tables of some lines, one after the other. A column that any of them has is written for all of them.
pub(super) fn write<T>(
    columns: &[CsvColumn<T>],
    tables: &[NamedLineTable<'_, T>],
) -> Result<Vec<u8>, StoreError> {
    let has_names = tables.iter().any(|(line, ..)| !line.is_empty());
    let is_written = |column: &&CsvColumn<T>| tables.iter().any(|(_, t, _)| (column.written)(t));
    let written: Vec<_> = columns.iter().filter(is_written).collect();
    let names = has_names.then_some(LINE).into_iter();
    let mut csv = CsvWriter::new(names.chain(written.iter().map(|column| column.name)))?;
    for (line, table, rows) in tables {
        let values: Vec<Vec<f64>> = written.iter().map(|c| (c.values)(table)).collect();
        for row in 0..*rows {
            let name = has_names.then(|| (*line).to_owned()).into_iter();
            let values = values.iter().map(|values| values.get(row).copied());
            csv.row(name.chain(values.map(|value| value.map(text).unwrap_or_default())))?;
        }
    }
    csv.bytes()
}

/// Reads the tables of lines as far as they can be read, with their names, and what is wrong with the file.
pub(super) fn read<T: Default>(
    columns: &[CsvColumn<T>],
    dir: &Path,
    name: &str,
) -> (Vec<(String, T)>, Option<String>) {
    let mut csv = CsvReader::open(dir, name);
    let required = columns.iter().filter(|column| column.required);
    let required: Vec<&str> = required.map(|column| column.name).collect();
    csv.require(&required);
    csv.note_unknown(|name| name == LINE || columns.iter().any(|column| column.name == name));
    let line_at = csv.position(LINE);
    let places: Vec<Option<usize>> = columns.iter().map(|c| csv.position(c.name)).collect();
    let mut tables: Vec<TableBeingRead> = Vec::new();
    while let Some((line, fields)) = csv.next() {
        let field = |place: &Option<usize>| place.and_then(|at| fields.get(at)).unwrap_or("");
        let values: Vec<Option<f64>> = places.iter().map(|place| parse(field(place))).collect();
        let mut all = columns.iter().zip(&places).zip(&values);
        let wrong = all.any(|((column, place), value)| {
            value.is_none() && (column.required || !field(place).is_empty())
        });
        if wrong {
            csv.give_up(not_a_number(name, line));
            break;
        }
        let line = field(&line_at);
        if tables.last().is_none_or(|table| table.line != line) {
            tables.push(TableBeingRead {
                line: line.to_owned(),
                rows: 0,
                columns: vec![Vec::new(); columns.len()],
            });
        }
        if let Some(table) = tables.last_mut() {
            for (column, value) in table.columns.iter_mut().zip(values) {
                column.extend(value);
            }
            table.rows += 1;
        }
    }
    let whole = tables.into_iter().map(|read| {
        let mut table = T::default();
        for (column, values) in columns.iter().zip(read.columns) {
            // A column with gaps is as good as absent.
            if values.len() == read.rows {
                (column.set)(&mut table, values);
            }
        }
        (read.line, table)
    });
    (whole.collect(), csv.problem())
}

/// The table of a line that is being read.
struct TableBeingRead {
    line: String,
    rows: usize,
    columns: Vec<Vec<f64>>,
}
