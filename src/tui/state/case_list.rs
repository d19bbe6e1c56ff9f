//! The list of cases.

use std::path::PathBuf;

use tui_input::Input;

use crate::fuzzy::FuzzyFilter;

/// A case file as the list shows it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CaseEntry {
    /// Where it is.
    pub path: PathBuf,
    /// Path below the directory listed.
    pub name: String,
    /// Title and source, or what is wrong with the file: one line, then the whole story.
    pub about: Result<(String, String), (String, String)>,
}

/// A filter of a list.
#[derive(Debug, Clone, Default)]
pub struct Filter {
    /// What is typed.
    pub input: Input,
    /// True while it is typed.
    pub typing: bool,
}

impl PartialEq for Filter {
    fn eq(&self, other: &Self) -> bool {
        self.typing == other.typing && self.input.value() == other.input.value()
    }
}

impl Filter {
    /// A filter of these words, as if they had been typed.
    #[must_use]
    pub fn of_words(words: &str) -> Self {
        Self {
            input: Input::new(words.to_owned()),
            typing: false,
        }
    }

    /// Whether it is typed, or holds lines back.
    #[must_use]
    pub fn is_in_use(&self) -> bool {
        self.typing || !self.is_empty()
    }

    /// Whether it lets everything pass.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.input.value().is_empty()
    }
}

/// The list of cases.
#[derive(Debug, Clone, Default)]
pub struct CaseList {
    /// The directory listed.
    pub dir: PathBuf,
    /// Whether it is read.
    pub is_read: bool,
    /// The file that was named, while it is read and its equilibrium searched: the list is read after it.
    pub opening: Option<PathBuf>,
    /// All of its cases, by name.
    pub entries: Vec<CaseEntry>,
    /// Cursor among the entries that pass the filter.
    pub cursor: usize,
    /// The filter; empty passes everything.
    pub filter: Filter,
}

impl CaseList {
    /// The entries that pass the filter.
    #[must_use]
    pub fn shown(&self) -> Vec<&CaseEntry> {
        if self.filter.is_empty() {
            return self.entries.iter().collect();
        }
        let parts = |entry: &CaseEntry| match &entry.about {
            Ok((title, source)) => vec![entry.name.clone(), title.clone(), source.clone()],
            Err((line, _)) => vec![entry.name.clone(), line.clone()],
        };
        let lines: Vec<Vec<String>> = self.entries.iter().map(parts).collect();
        let places = FuzzyFilter::new(self.filter.input.value()).places(&lines);
        places
            .into_iter()
            .map(|place| &self.entries[place])
            .collect()
    }

    /// The entry under the cursor.
    #[must_use]
    pub fn current(&self) -> Option<&CaseEntry> {
        self.shown().get(self.cursor).copied()
    }
}
