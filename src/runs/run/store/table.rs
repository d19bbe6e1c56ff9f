//! Tables of the store as CSV text, and back as far as they can be read.

use std::{
    fs::File,
    io::{self, Read, Seek, SeekFrom, Take},
    path::Path,
};

use super::StoreError;
use crate::files::read::run_table;

/// CSV text being written.
pub(super) struct CsvWriter {
    writer: csv::Writer<Vec<u8>>,
}

impl CsvWriter {
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

/// A table being read, row by row: as many whole rows as there are, and why it stops where it does. A missing file, a torn
/// last line or a broken row is a problem that is reported, never an error: the rows before it are good.
#[derive(Debug)]
pub(super) struct CsvReader {
    name: String,
    reader: Option<csv::Reader<Take<File>>>,
    columns: Vec<String>,
    fields: csv::StringRecord,
    problem: Option<String>,
    /// Columns that are not known, in words.
    unknown: Option<String>,
    /// The problem of a file all of whose whole rows are read.
    torn: Option<String>,
}

impl CsvReader {
    /// Opens a table, and reads its column names.
    pub(super) fn open(dir: &Path, name: &str) -> Self {
        let mut stream = Self {
            name: name.to_owned(),
            reader: None,
            columns: Vec::new(),
            fields: csv::StringRecord::new(),
            problem: None,
            unknown: None,
            torn: None,
        };
        match whole_lines(&dir.join(name)) {
            Ok((lines, torn)) => {
                stream.torn = torn.then(|| {
                    format!("{name} ends in the middle of a line; that line was left out.")
                });
                let mut builder = csv::ReaderBuilder::new();
                builder
                    .has_headers(false)
                    .flexible(true)
                    .buffer_capacity(1 << 16);
                stream.reader = Some(builder.from_reader(lines));
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                stream.problem = Some(format!("{name} is missing."));
            }
            Err(error) => stream.problem = Some(format!("{name} cannot be read: {error}.")),
        }
        if stream.read() {
            stream.columns = stream.fields.iter().map(str::to_owned).collect();
        } else if stream.problem.is_none() {
            stream.problem = stream.torn.take().or(Some(format!("{name} is empty.")));
        }
        stream
    }

    /// Column names; none where there is nothing.
    pub(super) fn columns(&self) -> &[String] {
        &self.columns
    }

    /// The next row, as long as the columns, with the number of its line.
    pub(super) fn next(&mut self) -> Option<(u64, &csv::StringRecord)> {
        if !self.read() {
            if self.problem.is_none() {
                self.problem = self.torn.take();
            }
            return None;
        }
        let line = self.fields.position().map_or(0, csv::Position::line);
        if self.fields.len() != self.columns.len() {
            self.give_up(format!(
                "{}, line {line}: {} fields where {} are expected; the file was read up to there.",
                self.name,
                self.fields.len(),
                self.columns.len()
            ));
            return None;
        }
        Some((line, &self.fields))
    }

    /// Reads no further, for this reason.
    pub(super) fn give_up(&mut self, why: String) {
        self.reader = None;
        self.problem.get_or_insert(why);
    }

    /// Where the column of this name is.
    pub(super) fn position(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == name)
    }

    /// Reads on only where all these columns are there; returns where they are.
    pub(super) fn require(&mut self, names: &[&str]) -> Vec<usize> {
        let missing = names.iter().find(|name| self.position(name).is_none());
        if let (Some(missing), false) = (missing, self.columns.is_empty()) {
            self.give_up(format!(
                "{} has the columns `{}` and lacks `{missing}`; it was left out.",
                self.name,
                self.columns.join(",")
            ));
        }
        names
            .iter()
            .filter_map(|name| self.position(name))
            .collect()
    }

    /// Notes the columns that are not known, which are left out.
    pub(super) fn note_unknown(&mut self, known: impl Fn(&str) -> bool) {
        let unknown = self.columns.iter().filter(|name| !known(name));
        let unknown: Vec<&str> = unknown.map(String::as_str).collect();
        self.unknown = (!unknown.is_empty()).then(|| {
            format!(
                "{} has columns that this version does not know, which were left out: {}.",
                self.name,
                unknown.join(", ")
            )
        });
    }

    /// What is wrong with the file, when something is.
    pub(super) fn problem(self) -> Option<String> {
        self.problem.or(self.unknown)
    }

    /// Reads a row, whatever its length.
    fn read(&mut self) -> bool {
        let Some(reader) = &mut self.reader else {
            return false;
        };
        match reader.read_record(&mut self.fields) {
            Ok(true) => true,
            Ok(false) => {
                self.reader = None;
                false
            }
            Err(error) => {
                let why = format!("{} cannot be read any further: {error}.", self.name);
                self.give_up(why);
                false
            }
        }
    }
}

/// The whole lines of a file, and whether more follows.
fn whole_lines(path: &Path) -> io::Result<(Take<File>, bool)> {
    let mut file = run_table(path)?;
    let length = file.metadata()?.len();
    let mut whole = length;
    let mut block = [0_u8; 4096];
    loop {
        let from = whole.saturating_sub(block.len() as u64);
        let size = usize::try_from(whole - from).unwrap_or(block.len());
        file.seek(SeekFrom::Start(from))?;
        let bytes = &mut block[..size];
        file.read_exact(bytes)?;
        if let Some(last) = bytes.iter().rposition(|b| *b == b'\n') {
            whole = from + last as u64 + 1;
            break;
        }
        whole = from;
        if from == 0 {
            break;
        }
    }
    file.seek(SeekFrom::Start(0))?;
    Ok((file.take(whole), whole < length))
}

/// That a line holds something else than numbers.
pub(super) fn not_a_number(name: &str, line: u64) -> String {
    format!(
        "{name}, line {line} holds something that is not a finite number; it was read up to there."
    )
}
