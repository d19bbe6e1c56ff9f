//! The formats of a report.

use std::path::Path;

/// A format of a report.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum ReportFormat {
    /// Plain text on 80 columns, charts in characters.
    #[default]
    Text,
    /// Markdown with tables, charts in characters.
    Markdown,
    /// One HTML page without script, charts as SVG.
    Html,
    /// The results as a table for spreadsheets.
    Csv,
    /// The results as a JSON object for scripts.
    Json,
}

impl ReportFormat {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Text,
        Self::Markdown,
        Self::Html,
        Self::Csv,
        Self::Json,
    ];

    /// The ending of its files.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Text => "txt",
            Self::Markdown => "md",
            Self::Html => "html",
            Self::Csv => "csv",
            Self::Json => "json",
        }
    }

    /// The format that the ending of a file tells.
    #[must_use]
    pub fn of_file(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        let mut all = Self::ALL.into_iter();
        all.find(|format| format.ending() == ending)
            .or((ending == "htm").then_some(Self::Html))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn endings_tell_formats() {
        let of = |name: &str| ReportFormat::of_file(Path::new(name));
        for format in ReportFormat::ALL {
            assert_eq!(of(&format!("a/b.c.{}", format.ending())), Some(format));
        }
        assert_eq!(of("REPORT.HTM"), Some(ReportFormat::Html));
        assert_eq!(of("report"), None);
        assert_eq!(of("report.pdf"), None);
    }
}
