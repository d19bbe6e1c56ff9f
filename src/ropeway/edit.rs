//! The keys of a ropeway file as an editor lists and sets them.

use super::fields::ROPEWAY;
use super::model::Ropeway;
use super::parse;
use crate::case::fields::{FieldRow, Lister};
use crate::case::{self, Diagnostic, Node};

/// Every input the file can have, given or not. A text that is not TOML gives no rows.
#[must_use]
pub fn rows(text: &str, ropeway: &Ropeway) -> Vec<FieldRow> {
    let Ok(root) = Node::parse(text) else {
        return Vec::new();
    };
    let lister = Lister {
        schema: &ROPEWAY,
        text,
        root: &root,
        marks: &ropeway.marks,
    };
    let mut rows = lister.table("ropeway", &["ropeway"], "ropeway");
    for table in ["setting", "cargo", "platform", "ship", "water"] {
        rows.extend(lister.table(table, &[table], table));
    }
    rows.extend(lister.named("rope", "rope"));
    for table in ["winch", "motion", "dynamics"] {
        rows.extend(lister.table(table, &[table], table));
    }
    if ropeway.finite_element.is_some() {
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
    let mut edited = text.to_owned();
    let mut faults = Vec::new();
    for (key, value) in edits {
        match case::put(&ROPEWAY, &edited, key, value) {
            Ok(next) => edited = next,
            Err(fault) => faults.push(fault),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let shown: Vec<String> = edits.iter().map(|(k, v)| format!("{k} = {v}")).collect();
    parse(&edited, &shown.join(", ")).map(|_| edited)
}
