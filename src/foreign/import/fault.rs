//! What is wrong with a file of another program, or not modelled, and where.

use std::collections::HashSet;
use std::ops::Range;

use crate::case::{Diagnostic, Excerpt};
use crate::visible::shortened;

/// One thing wrong with a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The bytes meant.
    pub span: Range<usize>,
    /// The column or key meant, such as `LINES, row 2, LineType`; empty for the file as a whole.
    pub key: String,
    /// What is wrong.
    pub problem: String,
    /// What would be right.
    pub remedy: String,
    /// The row of a table that has it.
    pub row: Option<Box<RowName>>,
    /// The row of another table that is not there.
    pub refers_to: Option<Box<RowName>>,
}

/// A row of a table: the title of its section, and its identifier.
pub type RowName = (&'static str, String);

impl Fault {
    /// A fault at these bytes.
    #[must_use]
    pub fn new(
        span: Range<usize>,
        key: impl Into<String>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self {
            span,
            key: key.into(),
            problem: problem.into(),
            remedy: remedy.into(),
            row: None,
            refers_to: None,
        }
    }

    /// As a diagnostic of a file with this text.
    #[must_use]
    pub fn diagnostic(&self, file: &str, text: &str) -> Diagnostic {
        let (line, column) = line_and_column(text, self.span.start);
        Diagnostic {
            file: file.to_owned(),
            line,
            column,
            key: shortened(self.key.clone()),
            problem: shortened(self.problem.clone()),
            remedy: shortened(self.remedy.clone()).into_boxed_str(),
            span: self.span.clone(),
            excerpt: Excerpt::of_span(text, &self.span),
        }
    }
}

/// Greatest number of faults of a file that are shown.
pub const GREATEST_FAULTS: usize = 100;

/// Faults in the order of a file with this text as diagnostics: the first of them, and how many there are more.
#[must_use]
pub fn diagnostics(mut faults: Vec<Fault>, file: &str, text: &str) -> Vec<Diagnostic> {
    let more = faults.len().saturating_sub(GREATEST_FAULTS);
    faults.truncate(GREATEST_FAULTS);
    let mut all: Vec<Diagnostic> = faults
        .iter()
        .map(|fault| fault.diagnostic(file, text))
        .collect();
    if let Some(last) = all.last().cloned().filter(|_| more > 0) {
        all.push(Diagnostic::further(more, last));
    }
    all
}

/// Leaves out the faults of references to rows, or to tables, that have a fault themselves.
pub fn without_followers(faults: &mut Vec<Fault>) {
    let folded = |part: &RowName| (part.0, part.1.to_lowercase());
    let rows: HashSet<RowName> = faults
        .iter()
        .filter_map(|fault| fault.row.as_deref().map(folded))
        .collect();
    let is_of_table = |fault: &&Fault| fault.row.is_none() && fault.refers_to.is_none();
    let tables = faults.iter().filter(is_of_table);
    let tables: HashSet<String> = tables.map(|fault| fault.key.clone()).collect();
    faults.retain(|fault| {
        let follows = |part: &RowName| rows.contains(&folded(part)) || tables.contains(part.0);
        !fault.refers_to.as_deref().is_some_and(follows)
    });
}

/// Line and column, in characters, both from 1, of a byte of a text.
#[must_use]
pub fn line_and_column(text: &str, at: usize) -> (u32, u32) {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    let before = &text[..at];
    let line = before.bytes().filter(|byte| *byte == b'\n').count() + 1;
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let column = before[start..].chars().count() + 1;
    let number = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
    (number(line), number(column))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters() {
        let text = "a\nµ bc";
        assert_eq!(line_and_column(text, 0), (1, 1));
        assert_eq!(line_and_column(text, text.find("bc").unwrap()), (2, 3));
        assert_eq!(line_and_column(text, 3), (2, 1));
        assert_eq!(line_and_column(text, 99), (2, 5));
    }
}
