//! The tables of a path: declarations and headers.

use super::super::fields::{Schema, TableSchema, TableShape, join};

/// The declaration of the table of a path.
#[must_use]
pub fn declaration(schema: &'static Schema, path: &[String]) -> Option<&'static TableSchema> {
    table_of(schema, path).map(|(table, _)| table)
}

/// A path for people.
pub(super) fn shown(path: &[String]) -> String {
    join(path)
}

/// The declaration of the table of a path, and whether the path ends with the name of one of several.
pub fn table_of(schema: &'static Schema, path: &[String]) -> Option<(&'static TableSchema, bool)> {
    let mut pattern = String::new();
    let mut parts = path.iter();
    let mut found = None;
    while let Some(part) = parts.next() {
        let table = schema
            .tables_in(&pattern)
            .find(|table| table.key() == part)?;
        pattern = table.pattern().into_owned();
        let named = table.shape != TableShape::One && parts.next().is_some();
        found = Some((table, named));
    }
    found
}

/// The header of a table of this path: `[materials.chain]`, `[[lines.sections]]`.
pub(super) fn header(schema: &'static Schema, path: &[String]) -> Option<String> {
    let mut words: Vec<&str> = Vec::new();
    let mut list = false;
    let mut at = 0;
    while at < path.len() {
        let (table, _) = table_of(schema, &path[..=at])?;
        words.push(&path[at]);
        list = table.shape == TableShape::List;
        at += 1;
        if table.shape != TableShape::One {
            if table.shape == TableShape::ByName {
                words.push(path.get(at)?);
            }
            at += 1;
        }
    }
    let joined = join(&words);
    Some(match list {
        true => format!("[[{joined}]]"),
        false => format!("[{joined}]"),
    })
}
