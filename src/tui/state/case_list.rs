//! The list of cases.

use std::path::PathBuf;

use tui_input::Input;

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

impl Filter {
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
    /// All of its cases, by name.
    pub entries: Vec<CaseEntry>,
    /// Cursor among the entries that pass the filter.
    pub cursor: usize,
    /// The filter; empty passes everything.
    pub filter: Filter,
}

impl CaseList {
    /// The entries that pass the filter.
    pub fn shown(&self) -> impl Iterator<Item = &CaseEntry> {
        let filter = self.filter.input.value().to_lowercase();
        self.entries.iter().filter(move |entry| {
            let about = match &entry.about {
                Ok((title, source)) => format!("{title} {source}"),
                Err((line, _)) => line.clone(),
            };
            passes(&format!("{} {about}", entry.name), &filter)
        })
    }

    /// The entry under the cursor.
    #[must_use]
    pub fn current(&self) -> Option<&CaseEntry> {
        self.shown().nth(self.cursor)
    }
}

/// True when every word of the filter occurs in the text.
#[must_use]
pub fn passes(text: &str, lowercase_filter: &str) -> bool {
    let text = text.to_lowercase();
    lowercase_filter
        .split_whitespace()
        .all(|word| text.contains(word))
}
