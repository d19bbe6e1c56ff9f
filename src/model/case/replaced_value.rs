//! A value of a source that an edit replaced.

use super::model::{Mark, Provenance};

/// The value in whose place the user's is.
#[derive(Debug, Clone, PartialEq)]
pub struct ReplacedValue {
    /// The value with its unit; empty where none is known or none was given.
    pub value: String,
    /// Its provenance, where that is known.
    pub standing: Option<Provenance>,
    /// What states it.
    pub origin: Origin,
}

impl ReplacedValue {
    /// `yours; the file says 1326 m (published)`.
    #[must_use]
    pub fn words(&self) -> String {
        let origin = self.origin.words();
        if self.origin == Origin::Unknown {
            return format!("{YOURS}; {origin}");
        }
        if self.value.is_empty() {
            return format!("{YOURS}; {origin} nothing here");
        }
        let standing = self
            .standing
            .map_or_else(String::new, |s| format!(" ({})", s.name()));
        format!("{YOURS}; {origin} {}{standing}", self.value)
    }
}

/// The replaced value of a key whose mark is for another value than it has.
pub(super) fn void(mark: &Mark, value: &str, unit: &str) -> Option<ReplacedValue> {
    let stated = mark.value.as_ref()?.to_string();
    (!same_value(&stated, value)).then(|| ReplacedValue {
        value: with_unit(&stated, unit),
        standing: Some(mark.status),
        origin: Origin::Mark,
    })
}

pub(super) fn with_unit(value: &str, unit: &str) -> String {
    match unit {
        "" | "-" => value.to_owned(),
        _ if value.is_empty() => String::new(),
        unit => format!("{value} {unit}"),
    }
}

/// What states the value in whose place the user's is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// The file.
    File,
    /// The file as it was opened; it has been saved since.
    Opened,
    /// The file of this title that comes with the program.
    Shipped,
    /// The mark of the key, which names the value it is for.
    Mark,
    /// It is not known: a stored run has the value that was set, not the one before.
    Unknown,
}

impl Origin {
    /// "the file says", to be followed by a value.
    const fn words(self) -> &'static str {
        match self {
            Self::File => "the file says",
            Self::Opened => "the file as opened says",
            Self::Shipped => "the file as shipped says",
            Self::Mark => "its mark is for",
            Self::Unknown => "set on top of the file",
        }
    }
}

/// The word for the standing of an input that the user changed.
pub const YOURS: &str = "yours";

/// Whether two values, as a file gives them, are the same: `0.3` and `0.30` are.
pub(super) fn same_value(a: &str, b: &str) -> bool {
    let numbers = a.parse::<f64>().ok().zip(b.parse::<f64>().ok());
    let bare = |text: &str| text.split_whitespace().collect::<String>();
    match numbers {
        Some((a, b)) => a.total_cmp(&b).is_eq(),
        None => a == b || (a.starts_with('[') && bare(a) == bare(b)),
    }
}
