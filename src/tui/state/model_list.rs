//! The list of what a file is made of.

use super::case_list::Filter;
use crate::case::structure::OutlineRow;
use crate::fuzzy::FuzzyFilter;

/// The tables of the file that is open, and the cursor in them.
#[derive(Debug, Clone, Default)]
pub struct ModelList {
    /// The tables, in the order of their declaration.
    pub rows: Vec<OutlineRow>,
    /// Cursor among the tables that pass the filter.
    pub cursor: usize,
    /// The filter of the list.
    pub filter: Filter,
    /// The path that the cursor goes to once the file has it.
    pub wanted: Option<String>,
}

impl ModelList {
    /// The tables that pass the filter.
    #[must_use]
    pub fn shown(&self) -> Vec<&OutlineRow> {
        let lines = self.rows.iter().map(|row| vec![&row.path, &row.summary]);
        let filter = FuzzyFilter::new(self.filter.input.value());
        let places = filter.places(&lines.collect::<Vec<_>>());
        places.into_iter().map(|at| &self.rows[at]).collect()
    }

    /// The row under the cursor.
    #[must_use]
    pub fn current(&self) -> Option<&OutlineRow> {
        self.shown().get(self.cursor).copied()
    }

    /// Takes the rows of a newer text; the cursor stays on its table, or goes to the one that was wanted.
    pub fn renew(&mut self, rows: Vec<OutlineRow>) {
        let old = self.current().map(|row| row.path.clone());
        self.rows = rows;
        let at = |path: &String| self.shown().iter().position(|row| row.path == *path);
        let wanted = self.wanted.as_ref().and_then(at);
        let found = wanted.or_else(|| old.as_ref().and_then(at));
        let last = self.shown().len().saturating_sub(1);
        if wanted.is_some() {
            self.wanted = None;
        }
        self.cursor = found.unwrap_or(self.cursor).min(last);
    }
}
