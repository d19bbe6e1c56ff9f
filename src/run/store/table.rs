//! Tables of the store as CSV text, and back as far as they can be trusted.

use std::{
    fs::File,
    io::{self, Read, Seek, SeekFrom, Take},
    path::Path,
};

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

/// A table being read, row by row: as many whole rows as there are, and why it stops where it does. A missing file, a torn
/// last line or a broken row are told, never an error: what stands before them is still good.
#[derive(Debug)]
pub(super) struct Stream {
    name: String,
    reader: Option<csv::Reader<Take<File>>>,
    columns: Vec<String>,
    fields: csv::StringRecord,
    trouble: Option<String>,
    /// What is told when all whole rows are read.
    torn: Option<String>,
}

impl Stream {
    /// Opens a table, and reads its column names.
    pub(super) fn open(dir: &Path, name: &str) -> Self {
        let mut stream = Self {
            name: name.to_owned(),
            reader: None,
            columns: Vec::new(),
            fields: csv::StringRecord::new(),
            trouble: None,
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
                stream.trouble = Some(format!("{name} is missing."));
            }
            Err(error) => stream.trouble = Some(format!("{name} cannot be read: {error}.")),
        }
        if stream.read() {
            stream.columns = stream.fields.iter().map(str::to_owned).collect();
        } else if stream.trouble.is_none() {
            stream.trouble = stream.torn.take().or(Some(format!("{name} is empty.")));
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
            if self.trouble.is_none() {
                self.trouble = self.torn.take();
            }
            return None;
        }
        let line = self.fields.position().map_or(0, csv::Position::line);
        if self.fields.len() != self.columns.len() {
            self.give_up(format!(
                "{}, line {line}: {} fields where {} are due; the file was read up to there.",
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
        self.trouble.get_or_insert(why);
    }

    /// Reads on only when the columns are exactly these.
    pub(super) fn expect(&mut self, columns: &[&str]) {
        if let Some(why) = unexpected(&self.name, &self.columns, columns) {
            self.give_up(why);
        }
    }

    /// What is wrong with the file, when something is.
    pub(super) fn trouble(self) -> Option<String> {
        self.trouble
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
    let mut file = File::open(path)?;
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

/// Why columns are not those that are due; nothing where they are, or where there is no table.
fn unexpected(name: &str, columns: &[String], due: &[&str]) -> Option<String> {
    let same = columns.iter().map(String::as_str).eq(due.iter().copied());
    (!same && !columns.is_empty()).then(|| {
        format!(
            "{name} has the columns `{}` where `{}` are due; it was left out.",
            columns.join(","),
            due.join(",")
        )
    })
}

/// A small table as read, whole.
#[derive(Debug, Default)]
pub(super) struct Rows {
    /// Column names.
    pub(super) columns: Vec<String>,
    /// Rows, each as long as `columns`, with the number of its line.
    pub(super) rows: Vec<(u64, Vec<String>)>,
    /// What is wrong with the file, when something is.
    pub(super) trouble: Option<String>,
}

/// Reads a table whole, as far as it can be read.
pub(super) fn read(dir: &Path, name: &str) -> Rows {
    let mut stream = Stream::open(dir, name);
    let mut rows = Vec::new();
    while let Some((line, fields)) = stream.next() {
        rows.push((line, fields.iter().map(str::to_owned).collect()));
    }
    Rows {
        columns: stream.columns,
        rows,
        trouble: stream.trouble,
    }
}

impl Rows {
    /// Drops the rows unless the columns are exactly these, and says so in `trouble`.
    pub(super) fn expect(&mut self, name: &str, columns: &[&str]) {
        if let Some(why) = unexpected(name, &self.columns, columns) {
            self.rows.clear();
            self.trouble = Some(why);
        }
    }
}
