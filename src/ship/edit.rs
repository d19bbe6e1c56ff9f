//! The keys of a ship file as an editor lists and sets them.

use super::fields::SHIP;
use super::model::Ship;
use super::parse;
use crate::case::fields::{FieldRow, Lister};
use crate::case::{self, Diagnostic, Node};

/// Every key the file can have, given or not, table by table. A text that is not TOML gives no rows.
#[must_use]
pub fn rows(text: &str) -> Vec<FieldRow> {
    let Ok(root) = Node::parse(text) else {
        return Vec::new();
    };
    let marks = case::words_of::<Ship>(text).map_or_else(|_| Default::default(), |ship| ship.marks);
    let lister = Lister {
        schema: &SHIP,
        text,
        root: &root,
        marks: &marks,
    };
    let mut rows = lister.table("ship", &["ship"], "ship");
    for table in SHIP.tables.iter().filter(|table| table.path != "ship") {
        if root.get(table.path).is_some() && table.path != "marks" {
            rows.extend(lister.table(table.path, &[table.path], table.path));
        }
    }
    rows
}

/// The text of the ship with one key set to a value, given as a user types it: a TOML value, or a bare word where the
/// field takes words. Nothing but the value changes; a key that the file leaves out is added to its table.
///
/// # Errors
///
/// The key is not known, the value is of the wrong type or out of range, or all faults of the file with it.
pub fn set(text: &str, key_path: &str, value: &str) -> Result<String, Vec<Diagnostic>> {
    let edited = case::put(&SHIP, text, key_path, value).map_err(|diagnostic| vec![diagnostic])?;
    parse(&edited, &format!("{key_path} = {value}")).map(|_| edited)
}
