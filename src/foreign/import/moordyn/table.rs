//! A table of a section: its header, and rows whose columns are known by name.

use super::sections::SectionBlock;
use crate::import::fault::Fault;
use crate::import::mooring::Given;
use crate::import::words::{Row, Word};

/// A column: the name by which messages call it, and other names that headers have for it.
pub type HeaderColumn = (&'static str, &'static [&'static str]);

/// A table with the columns that its program reads by their order.
#[derive(Debug, Clone)]
pub struct SectionTable<'t> {
    /// The name of its section.
    title: &'static str,
    columns: Vec<HeaderColumn>,
    /// Columns that every row has.
    required: usize,
    rows: Vec<Row<'t>>,
    /// Whether `#` marks a number rather than a remark.
    marks: bool,
}

impl<'t> SectionTable<'t> {
    /// The table of a block. Its header has these columns, of which the last may be missing.
    ///
    /// # Errors
    /// The header is missing, or names columns where the program reads others.
    pub fn of_block(
        block: &SectionBlock<'t>,
        columns: &[HeaderColumn],
        required: usize,
        faults: &mut Vec<Fault>,
    ) -> Self {
        let title = block.section.title();
        let all = block.rows.iter().filter(|row| !row.is_blank());
        let all: Vec<Row<'t>> = all.copied().collect();
        let mut rows = all.as_slice();
        while let [first, rest @ ..] = rows
            && is_count(first)
        {
            rows = rest;
        }
        let header = rows.first().filter(|row| is_header(&row.words(), columns));
        match header {
            Some(header) => {
                rows = &rows[1..];
                check_order(&header.words(), columns, title, faults);
            }
            None if rows.is_empty() => {}
            None => match behind_mark(block, rows.first(), columns) {
                Some(header) => check_order(&header, columns, title, faults),
                None => faults.push(no_header(block, columns, rows.first())),
            },
        }
        if let [first, rest @ ..] = rows
            && is_units(first)
        {
            rows = rest;
        }
        Self {
            title,
            columns: columns.to_vec(),
            required,
            rows: rows.to_vec(),
            marks: false,
        }
    }

    /// The same, of a program that marks numbers with `#`.
    pub fn with_marks(
        block: &SectionBlock<'t>,
        columns: &[HeaderColumn],
        required: usize,
        faults: &mut Vec<Fault>,
    ) -> Self {
        Self {
            marks: true,
            ..Self::of_block(block, columns, required, faults)
        }
    }

    /// The words of a column.
    pub fn words(&self, column: usize) -> impl Iterator<Item = Word<'t>> {
        self.rows
            .iter()
            .filter_map(move |row| row.words().get(column).copied())
    }

    /// How many rows it has.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether it has no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Its rows, each as the reader of one makes it; faults are gathered, and rows with any left out.
    pub fn read<T>(
        &self,
        faults: &mut Vec<Fault>,
        mut read: impl FnMut(&TableRow<'_, 't>) -> Result<T, Fault>,
    ) -> Vec<T> {
        let mut all = Vec::new();
        for row in &self.rows {
            let words = match self.marks {
                true => row.words_with_marks(),
                false => row.words(),
            };
            if words.iter().all(|word| word.text == "END") {
                continue;
            }
            let row = TableRow {
                table: self,
                row: *row,
                words,
            };
            let read = row.is_complete().and_then(|()| read(&row));
            match read {
                Ok(item) => all.push(item),
                Err(fault) => faults.push(Fault {
                    row: row
                        .words
                        .first()
                        .map(|id| Box::new((self.title, id.text.to_owned()))),
                    ..fault
                }),
            }
        }
        all
    }
}

/// A row of a table.
#[derive(Debug, Clone)]
pub struct TableRow<'a, 't> {
    table: &'a SectionTable<'t>,
    /// The row.
    pub row: Row<'t>,
    /// Its words.
    pub words: Vec<Word<'t>>,
}

impl<'t> TableRow<'_, 't> {
    fn is_complete(&self) -> Result<(), Fault> {
        let required = self.table.required;
        let given = self.words.len();
        if given >= required {
            return Ok(());
        }
        let missing: Vec<&str> = self.table.columns[given..required]
            .iter()
            .map(|(name, _)| *name)
            .collect();
        let end = self.row.span().end;
        Err(Fault::new(
            self.row.span().start..end,
            self.table.title,
            format!("the row has {given} columns where {required} are needed"),
            format!(
                "add {} at its end, or what is missing before",
                missing.join(", ")
            ),
        ))
    }

    /// The key of a column in messages.
    #[must_use]
    pub fn key(&self, column: usize) -> String {
        match self.table.columns.get(column) {
            Some((name, _)) => format!("{}, {name}", self.table.title),
            None => self.table.title.to_owned(),
        }
    }

    /// The number in a column.
    ///
    /// # Errors
    /// It is none.
    pub fn number(&self, column: usize) -> Result<Given<f64>, Fault> {
        let word = self.words[column];
        Ok(Given::new(word.required(&self.key(column))?, word.span()))
    }

    /// A number that must be above 0.
    ///
    /// # Errors
    /// It is no number, or not above 0.
    pub fn positive(&self, column: usize) -> Result<Given<f64>, Fault> {
        let number = self.number(column)?;
        if number.value > 0.0 {
            return Ok(number);
        }
        Err(self.fault(
            column,
            format!("`{}` is not above 0", self.words[column].text),
            "give a positive number",
        ))
    }

    /// A number that must not be negative.
    ///
    /// # Errors
    /// It is no number, or negative.
    pub fn not_negative(&self, column: usize) -> Result<Given<f64>, Fault> {
        let number = self.number(column)?;
        if number.value >= 0.0 {
            return Ok(number);
        }
        Err(self.fault(
            column,
            format!("`{}` is negative", self.words[column].text),
            "give 0 or a positive number",
        ))
    }

    /// The number in a column that may be missing.
    ///
    /// # Errors
    /// It is there and no number.
    pub fn optional(&self, column: usize) -> Result<Option<Given<f64>>, Fault> {
        match self.words.get(column) {
            Some(_) => self.number(column).map(Some),
            None => Ok(None),
        }
    }

    /// Three numbers from a column on.
    ///
    /// # Errors
    /// One is no number.
    pub fn triple(&self, from: usize) -> Result<[Given<f64>; 3], Fault> {
        Ok([
            self.number(from)?,
            self.number(from + 1)?,
            self.number(from + 2)?,
        ])
    }

    /// The numbers between bars in a column.
    ///
    /// # Errors
    /// One is no number.
    pub fn bars(&self, column: usize) -> Result<Given<Vec<f64>>, Fault> {
        let word = self.words[column];
        let key = self.key(column);
        let parts = word.parts('|');
        let numbers: Result<Vec<f64>, Fault> =
            parts.iter().map(|part| part.required(&key)).collect();
        Ok(Given::new(numbers?, word.span()))
    }

    /// A fault at a column.
    #[must_use]
    pub fn fault(
        &self,
        column: usize,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Fault {
        let span = self
            .words
            .get(column)
            .map_or_else(|| self.row.span(), Word::span);
        Fault::new(span, self.key(column), problem, remedy)
    }
}

/// Whether a row states how many rows follow, as in files of the first version: `3 NLines - number of lines`.
fn is_count(row: &Row<'_>) -> bool {
    let words = row.words();
    matches!(words.as_slice(), [count, name, ..]
        if count.text.parse::<usize>().is_ok() && name.text.starts_with(['N', 'n']) && name.text.len() > 3
            && name.number().is_none() && row.text.to_lowercase().contains("number of"))
}

/// Whether a row behind a header has the units: `MoorDyn` passes over it whatever it has, but a row of the table has numbers.
fn is_units(row: &Row<'_>) -> bool {
    let is_in_brackets = row.text.trim_start().starts_with(['(', '[']);
    is_in_brackets || row.words().iter().all(|word| word.number().is_none())
}

/// Whether a row names columns: two of its words at least are among their names, and one in three.
fn is_header(words: &[Word<'_>], columns: &[HeaderColumn]) -> bool {
    let known = words
        .iter()
        .filter(|word| columns.iter().any(|column| is_named(column, word.text)))
        .count();
    known >= 2 && 3 * known >= words.len()
}

/// The names of the columns in a remark right before the rows: `# Node Type X Y Z`.
fn behind_mark<'t>(
    block: &SectionBlock<'t>,
    first: Option<&Row<'t>>,
    columns: &[HeaderColumn],
) -> Option<Vec<Word<'t>>> {
    let before = block.rows.iter().take_while(|row| Some(*row) != first);
    let mut remarks = before.map(Row::words_with_marks);
    let found = remarks.find(|words| is_header(words, columns))?;
    // `# Node` names the first column behind its mark, `# Type` by its mark.
    let marked = found.first().filter(|word| word.text == "#");
    let named = found.get(1).filter(|word| is_named(&columns[0], word.text));
    let from = usize::from(marked.is_some() && named.is_some());
    Some(found[from..].to_vec())
}

/// Whether a header names a column so.
pub fn is_named((name, others): &HeaderColumn, word: &str) -> bool {
    let word = word.trim_end_matches(['*', ',']);
    name.trim_end_matches('*').eq_ignore_ascii_case(word)
        || others.iter().any(|other| other.eq_ignore_ascii_case(word))
}

/// Names that stand where the program reads another column.
fn check_order(words: &[Word<'_>], columns: &[HeaderColumn], title: &str, faults: &mut Vec<Fault>) {
    for (word, column) in words.iter().zip(columns) {
        let elsewhere = || {
            columns
                .iter()
                .find(|other| is_named(other, word.text))
                .map(|other| other.0)
        };
        if is_named(column, word.text) {
            continue;
        }
        if let Some(other) = elsewhere() {
            faults.push(Fault::new(
                word.span(),
                format!("{title}, {}", column.0),
                format!("the header names {other} where {} is read", column.0),
                "columns are read by their order; put them into that of the format",
            ));
            return;
        }
    }
}

fn no_header(block: &SectionBlock<'_>, columns: &[HeaderColumn], first: Option<&Row<'_>>) -> Fault {
    let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
    let title = block.section.title();
    Fault::new(
        first.map_or_else(|| block.span.clone(), Row::span),
        title,
        format!("the section {title} has no row with the names of its columns"),
        format!("put this row first: {}", names.join(" ")),
    )
}
