//! Tables of the store as CSV text, and back as far as they can be trusted.

use std::{fs, io, path::Path};

use super::StoreError;

/// CSV text being made.
pub(super) struct Csv {
    writer: csv::Writer<Vec<u8>>,
}

impl Csv {
    /// A table with these column names.
    pub(super) fn new<I, S>(columns: I) -> Result<Self, StoreError>
    where
        I: IntoIterator<Item = S>,
        S: AsRef<[u8]>,
    {
        let mut csv = Self::headless();
        csv.row(columns)?;
        Ok(csv)
    }

    /// Rows to be appended to a table that has its column names.
    pub(super) fn headless() -> Self {
        Self {
            writer: csv::Writer::from_writer(Vec::new()),
        }
    }

    /// Adds a row.
    pub(super) fn row<I, S>(&mut self, fields: I) -> Result<(), StoreError>
    where
        I: IntoIterator<Item = S>,
        S: AsRef<[u8]>,
    {
        let written = self.writer.write_record(fields);
        written.map_err(|e| StoreError::io("Writing", "a table")(io::Error::other(e)))
    }

    /// The text.
    pub(super) fn bytes(self) -> Result<Vec<u8>, StoreError> {
        let inner = self.writer.into_inner();
        inner.map_err(|e| StoreError::io("Writing", "a table")(io::Error::other(e.to_string())))
    }
}

/// A table as read: as many whole rows as there are, and why it stops where it does.
#[derive(Debug, Default)]
pub(super) struct Rows {
    /// Column names.
    pub(super) columns: Vec<String>,
    /// Rows, each as long as `columns`, with the number of its line.
    pub(super) rows: Vec<(u64, Vec<String>)>,
    /// What is wrong with the file, when something is.
    pub(super) trouble: Option<String>,
}

/// Reads a table. A missing file, a torn last line or a broken row become `trouble`, never an error:
/// what stands before it is still good.
pub(super) fn read(dir: &Path, name: &str) -> Rows {
    let bytes = match fs::read(dir.join(name)) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            return Rows {
                trouble: Some(format!("{name} is missing.")),
                ..Rows::default()
            };
        }
        Err(error) => {
            return Rows {
                trouble: Some(format!("{name} cannot be read: {error}.")),
                ..Rows::default()
            };
        }
    };
    let whole = bytes
        .iter()
        .rposition(|&b| b == b'\n')
        .map_or(0, |last| last + 1);
    let mut table = rows(name, bytes.get(..whole).unwrap_or_default());
    if whole < bytes.len() && table.trouble.is_none() {
        table.trouble = Some(format!(
            "{name} ends in the middle of a line; that line was left out."
        ));
    }
    if table.columns.is_empty() && table.trouble.is_none() {
        table.trouble = Some(format!("{name} is empty."));
    }
    table
}

fn rows(name: &str, bytes: &[u8]) -> Rows {
    let mut table = Rows::default();
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .from_reader(bytes);
    for record in reader.records() {
        let fields = match record {
            Ok(fields) => fields,
            Err(error) => {
                table.trouble = Some(format!("{name} cannot be read any further: {error}."));
                break;
            }
        };
        let line = fields.position().map_or(0, csv::Position::line);
        let fields: Vec<String> = fields.iter().map(str::to_owned).collect();
        if table.columns.is_empty() {
            table.columns = fields;
        } else if fields.len() == table.columns.len() {
            table.rows.push((line, fields));
        } else {
            table.trouble = Some(format!(
                "{name}, line {line}: {} fields where {} are due; the file was read up to there.",
                fields.len(),
                table.columns.len()
            ));
            break;
        }
    }
    table
}

impl Rows {
    /// True when the columns are exactly these; says so in `trouble` and drops the rows otherwise.
    pub(super) fn expect(&mut self, name: &str, columns: &[&str]) -> bool {
        let same = self
            .columns
            .iter()
            .map(String::as_str)
            .eq(columns.iter().copied());
        if !same && !self.columns.is_empty() {
            self.rows.clear();
            self.trouble = Some(format!(
                "{name} has the columns `{}` where `{}` are due; it was left out.",
                self.columns.join(","),
                columns.join(",")
            ));
        }
        same
    }
}
