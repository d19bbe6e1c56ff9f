//! The list of what a file is made of.

use crate::case::structure::OutlineRow;

/// The tables of the file that is open, and the cursor in them.
#[derive(Debug, Clone, Default)]
pub struct ModelList {
    /// The tables, in the order of their declaration.
    pub rows: Vec<OutlineRow>,
    /// Cursor.
    pub cursor: usize,
    /// The path that the cursor goes to once the file has it.
    pub wanted: Option<String>,
}

impl ModelList {
    /// The row under the cursor.
    #[must_use]
    pub fn current(&self) -> Option<&OutlineRow> {
        self.rows.get(self.cursor)
    }

    /// Takes the rows of a newer text; the cursor stays on its table, or goes to the one that was wanted.
    pub fn renew(&mut self, rows: Vec<OutlineRow>) {
        let old = self.current().map(|row| row.path.clone());
        let at = |path: &String| rows.iter().position(|row| row.path == *path);
        let wanted = self.wanted.as_ref().and_then(at);
        if wanted.is_some() {
            self.wanted = None;
        }
        let found = wanted.or_else(|| old.as_ref().and_then(at));
        self.cursor = found
            .unwrap_or(self.cursor)
            .min(rows.len().saturating_sub(1));
        self.rows = rows;
    }
}
