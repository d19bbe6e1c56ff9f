//! Tables of a file, and those that a case file has.

use std::borrow::Cow;

use TableShape::{ByName, List, One};

/// A table of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableSchema {
    /// Path pattern: `materials`, `ends.a`.
    pub path: String,
    /// How many there are.
    pub shape: TableShape,
    /// Whether it must be there.
    pub required: bool,
    /// One line of help.
    pub help: &'static str,
    /// The pattern of its fields where several tables share them: `ends.*`.
    shared: Option<String>,
}

impl TableSchema {
    /// A table that shares its fields with no other.
    #[must_use]
    pub fn new(path: String, shape: TableShape, required: bool, help: &'static str) -> Self {
        Self {
            path,
            shape,
            required,
            help,
            shared: None,
        }
    }

    /// The same table with the fields of this pattern.
    pub fn with_fields(mut self, pattern: String) -> Self {
        self.shared = Some(pattern);
        self
    }

    /// The key of the table in the one it stands in.
    #[must_use]
    pub fn key(&self) -> &str {
        self.path.rsplit('.').next().unwrap_or(&self.path)
    }

    /// How its header is written: `[payload]`, `[materials.<name>]`, `[[line]]`.
    #[must_use]
    pub fn header(&self) -> String {
        let path = self.path.replace(".*", "");
        match self.shape {
            One => format!("[{path}]"),
            ByName => format!("[{path}.<name>]"),
            List => format!("[[{path}]]"),
        }
    }

    /// The pattern of its fields: `solver`, `materials.*`.
    #[must_use]
    pub fn pattern(&self) -> Cow<'_, str> {
        match (&self.shared, self.shape) {
            (Some(pattern), _) => pattern.into(),
            (None, One) => Cow::Borrowed(&self.path),
            (None, ByName | List) => format!("{}.*", self.path).into(),
        }
    }
}

/// How many tables stand under a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableShape {
    /// One: `[solver]`.
    One,
    /// Any number, by name: `[materials.chain]`.
    ByName,
    /// A list: `[[line]]`.
    List,
}
