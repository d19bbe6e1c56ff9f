//! A key of a case with the values it is varied over.

use super::VariationError;
use crate::case::fields::{Field, ValueType};
use crate::case::{Diagnostic, RangeError, ValueRange, edit, takes_values};

/// A key that is varied.
#[derive(Debug, Clone, PartialEq)]
pub struct VariedKey {
    /// Key path: `current.speed_m_per_s`.
    pub path: String,
    /// The key.
    pub field: &'static Field,
    /// Its values.
    pub range: ValueRange,
}

impl VariedKey {
    /// Reads `KEY=VALUES` for a case.
    ///
    /// # Errors
    /// The case has no such key, or the key cannot have these values.
    pub fn parse(word: &str, case_text: &str) -> Result<Self, VariationError> {
        Self::parse_by(word, |path| edit::field(case_text, path))
    }

    /// Reads `KEY=VALUES` for a case whose fields are known.
    ///
    /// # Errors
    /// As [`Self::parse`].
    pub fn parse_by(
        word: &str,
        field: impl Fn(&str) -> Result<&'static Field, Diagnostic>,
    ) -> Result<Self, VariationError> {
        let parts = word.split_once('=');
        let (path, values) = parts.ok_or_else(|| VariationError::Syntax(word.to_owned()))?;
        let path = path.trim();
        let field = field(path).map_err(VariationError::Key)?;
        if field.kind == ValueType::Triple {
            return Err(VariationError::Coordinates(path.to_owned()));
        }
        if !takes_values(path, field) {
            return Err(VariationError::NoNumber(
                path.to_owned(),
                field.range_text(),
            ));
        }
        let wrong = |error: RangeError| VariationError::Range(path.to_owned(), error);
        let range = ValueRange::parse(values, field).map_err(wrong)?;
        Ok(Self {
            path: path.to_owned(),
            field,
            range,
        })
    }

    /// Unit as shown; empty for pure numbers and words.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        match self.field.in_words(&self.path).1 {
            "-" => "",
            unit => unit,
        }
    }
}
