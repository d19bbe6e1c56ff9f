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

/// The file of a table with this many rows.
pub(super) fn write<T>(
    columns: &[CsvColumn<T>],
    table: &T,
    rows: usize,
) -> Result<Vec<u8>, StoreError> {
    let written = columns.iter().filter(|column| (column.written)(table));
    let written: Vec<_> = written.map(|c| (c.name, (c.values)(table))).collect();
    let mut csv = CsvWriter::new(written.iter().map(|(name, _)| name))?;
    for row in 0..rows {
        let values = written.iter().map(|(_, values)| values.get(row));
        csv.row(values.map(|value| value.copied().map(text).unwrap_or_default()))?;
    }
    csv.bytes()
}

/// Reads a table as far as it can be read, and what is wrong with its file.
pub(super) fn read<T: Default>(
    columns: &[CsvColumn<T>],
    dir: &Path,
    name: &str,
) -> (T, Option<String>) {
    let mut csv = CsvReader::open(dir, name);
    let required = columns.iter().filter(|column| column.required);
    let required: Vec<&str> = required.map(|column| column.name).collect();
    csv.require(&required);
    csv.note_unknown(|name| columns.iter().any(|column| column.name == name));
    let places: Vec<Option<usize>> = columns.iter().map(|c| csv.position(c.name)).collect();
    let mut read: Vec<Vec<f64>> = vec![Vec::new(); columns.len()];
    let mut rows = 0;
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
        for (column, value) in read.iter_mut().zip(values) {
            column.extend(value);
        }
        rows += 1;
    }
    let mut table = T::default();
    for (column, values) in columns.iter().zip(read) {
        // A column with gaps is as good as absent.
        if values.len() == rows {
            (column.set)(&mut table, values);
        }
    }
    (table, csv.problem())
}
