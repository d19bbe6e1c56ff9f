//! The keys of a ropeway file as an editor lists and sets them.

use super::read::RopewayFile;
use crate::case::{Diagnostic, kind};
use crate::case::{FieldRow, Lister};

/// Every input the file can have, given or not. A text that is not TOML gives no rows.
#[must_use]
pub fn rows(text: &str) -> Vec<FieldRow> {
    kind::rows::<RopewayFile>(text)
}

pub(super) fn list(lister: &Lister<'_>) -> Vec<FieldRow> {
    let mut rows = lister.table("ropeway", &["ropeway"], "ropeway");
    for table in ["setting", "cargo", "platform", "ship", "water"] {
        rows.extend(lister.table(table, &[table], table));
    }
    rows.extend(lister.named("rope", "rope"));
    for table in ["winch", "motion", "dynamics"] {
        rows.extend(lister.table(table, &[table], table));
    }
    if lister.root.get("finite_element").is_some() {
        rows.extend(lister.table(
            "finite_element",
            &["finite_element"],
            "finite-element check",
        ));
    }
    rows
}

/// The text with one key set to a value, given as a user types it. Nothing but the value changes; a key that
/// the file leaves out is added to its table.
///
/// # Errors
/// As [`set_all`].
pub fn set(text: &str, key_path: &str, value: &str) -> Result<String, Vec<Diagnostic>> {
    set_all(text, &[(key_path, value)])
}

/// The text with several keys set one after the other; the ropeway is worked out once all are set.
///
/// # Errors
/// A key is not known, a value is of the wrong type or out of range, or the ropeway cannot be with them.
pub fn set_all(text: &str, edits: &[(&str, &str)]) -> Result<String, Vec<Diagnostic>> {
    kind::set_all::<RopewayFile>(text, edits)
}
