//! The keys of a ship file as an editor lists and sets them.

use super::read::ShipFile;
use crate::case::FieldRow;
use crate::case::{Diagnostic, kind};

/// Every key the file can have, given or not, table by table. A text that is not TOML gives no rows.
#[must_use]
pub fn rows(text: &str) -> Vec<FieldRow> {
    kind::rows::<ShipFile>(text)
}

/// The text of the ship with one key set to a value as a user types it: a TOML value, or a bare word where the key takes words.
/// Nothing but the value changes; a key that the file leaves out is added to its table.
///
/// # Errors
///
/// The key is not known, the value is of the wrong type or out of range, or all faults of the file with it.
pub fn set(text: &str, key_path: &str, value: &str) -> Result<String, Vec<Diagnostic>> {
    set_all(text, &[(key_path, value)])
}

/// The text with several keys set one after the other; the ship is checked once all are set.
///
/// # Errors
/// As [`set`].
pub fn set_all(text: &str, edits: &[(&str, &str)]) -> Result<String, Vec<Diagnostic>> {
    kind::set_all::<ShipFile>(text, edits)
}
