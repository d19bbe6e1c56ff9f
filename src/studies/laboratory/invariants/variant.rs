//! A system as it is asked for in another way, and where its results are those of the system.

use std::collections::BTreeMap;

use toml::Table;

use super::space::Space;

/// An end of a line: its name and `a` or `b`.
pub(super) type NamedLineEnd = (String, char);

/// A system asked for in another way.
#[derive(Debug, Clone)]
pub struct SystemVariant {
    /// Its file.
    pub file: Table,
    /// Ends of lines that are called otherwise in it.
    pub(super) ends: BTreeMap<NamedLineEnd, NamedLineEnd>,
    /// Points and bodies that are called otherwise in it.
    pub(super) parts: BTreeMap<String, String>,
    /// How it lies.
    pub(super) space: Space,
}

impl SystemVariant {
    /// A file with the names and places of the system.
    pub(super) fn of_file(file: Table) -> Self {
        Self {
            file,
            ends: BTreeMap::new(),
            parts: BTreeMap::new(),
            space: Space::default(),
        }
    }

    /// What an end of a line of the system is called in it.
    pub(super) fn end(&self, line: &str, end: char) -> NamedLineEnd {
        let known = (line.to_owned(), end);
        self.ends.get(&known).cloned().unwrap_or(known)
    }

    /// What a point or body of the system is called in it.
    pub fn part<'a>(&'a self, name: &'a str) -> &'a str {
        self.parts.get(name).map_or(name, String::as_str)
    }

    /// The file as text.
    #[must_use]
    pub fn text(&self) -> String {
        text(&self.file)
    }
}

/// A file as text.
#[must_use]
pub fn text(file: &Table) -> String {
    // Tables of numbers and words have a text.
    toml::to_string(file).unwrap_or_default()
}
