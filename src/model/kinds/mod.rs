//! The kinds of file, distinguished by the table that every file of a kind begins with, and by what files of other programs have.

mod file_bytes;
pub mod foreign;

use std::path::Path;

pub use file_bytes::FileBytes;

/// What a TOML file describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum FileType {
    /// A line case. Also every file of no other kind, whose errors are then reported as those of a case.
    #[value(name = "case")]
    Line,
    /// A cross-section.
    Section,
    /// A ropeway.
    Ropeway,
    /// A ship at single-point mooring.
    Ship,
    /// A system of lines.
    System,
}

impl FileType {
    /// All kinds. A ropeway file has `[ship]` too, so that ropeways precede ships.
    pub const ALL: [Self; 5] = [
        Self::Line,
        Self::Section,
        Self::Ropeway,
        Self::Ship,
        Self::System,
    ];

    /// The table that every file of the kind has: the kind in a word.
    #[must_use]
    pub const fn table(self) -> &'static str {
        match self {
            Self::Line => "case",
            Self::Section => "section",
            Self::Ropeway => "ropeway",
            Self::Ship => "ship",
            Self::System => "system",
        }
    }

    /// What a file of the kind is, and the command for it, in words.
    #[must_use]
    pub const fn description(self) -> (&'static str, &'static str) {
        match self {
            Self::Line => ("a line case", "`seacable run` computes it"),
            Self::Section => ("a cross-section", "`seacable section` works it out"),
            Self::Ropeway => ("a ropeway", "`seacable ropeway` works it out"),
            Self::Ship => ("a ship", "`seacable ship` works it out"),
            Self::System => ("a system of lines", "`seacable run` computes it"),
        }
    }

    /// The kind of a file.
    #[must_use]
    pub fn of_path(path: &Path) -> Self {
        FileBytes::read(path).kind()
    }

    /// The kind of a file with this text.
    #[must_use]
    pub fn of_file(path: &Path, text: &str) -> Self {
        match foreign::is_named_yaml(path) {
            true => Self::System,
            false => Self::of_text(text),
        }
    }

    /// The kind of the file with this text.
    #[must_use]
    pub fn of_text(text: &str) -> Self {
        let is_header = |line: &&str| line.trim_start().starts_with('[');
        let has = |kind: &Self| {
            let (table, header) = (kind.table(), format!("[{}]", kind.table()));
            // Before the first table `system.title = "..."` says the same.
            let is_dotted = |line: &str| {
                let key = line.trim_start().strip_prefix(table);
                key.is_some_and(|rest| rest.trim_start().starts_with(['.', '=']))
            };
            let mut of_root = text.lines().take_while(|line| !is_header(line));
            let mut headers = text.lines().filter(is_header);
            headers.any(|line| line.trim_start().starts_with(&header)) || of_root.any(is_dotted)
        };
        let others = Self::ALL.into_iter().filter(|kind| *kind != Self::Line);
        let foreign = || match foreign::is_foreign(text) {
            true => Self::System,
            false => Self::Line,
        };
        others.into_iter().find(has).unwrap_or_else(foreign)
    }
}
