//! A file that another file has its lines from, with places of its own.

use std::ops::Range;

use super::fault::{Fault, line_and_column};

/// A file of another program that a design names. Its bytes are counted on from the end of the design.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReferencedFile {
    /// Its name in the design.
    pub name: String,
    /// Where it is named.
    pub named_at: Range<usize>,
    /// What its first byte is counted as.
    pub start: usize,
    /// Its text.
    pub text: String,
}

impl ReferencedFile {
    /// Whether bytes are those of this file.
    #[must_use]
    pub fn holds(&self, span: &Range<usize>) -> bool {
        span.start >= self.start
    }

    /// Line and column, both from 1, of a byte.
    #[must_use]
    pub fn line_and_column(&self, at: usize) -> (u32, u32) {
        line_and_column(&self.text, at.saturating_sub(self.start))
    }

    /// A fault of this file where the design names it, with the row in its words.
    #[must_use]
    pub fn at_its_name(&self, fault: &Fault, key: &str) -> Fault {
        let problem = match (self.holds(&fault.span), fault.key.as_str()) {
            (false, _) => format!("in `{}`: {}", self.name, fault.problem),
            (true, at) => {
                let (line, column) = self.line_and_column(fault.span.start);
                let (name, said) = (&self.name, &fault.problem);
                format!("in `{name}`, line {line}, column {column}, {at}: {said}")
            }
        };
        Fault::new(self.named_at.clone(), key, problem, &fault.remedy)
    }
}
