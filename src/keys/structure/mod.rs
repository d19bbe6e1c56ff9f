//! Edits of what a file is made of: tables added, removed, copied, renamed, put in another order, divided. Every other byte stays as it is;
//! what comes out is the file that a person would have written.
//!
//! [`apply`] changes a text and does not check the file as a whole.

mod add;
pub mod blocks;
mod divide;
mod order;
pub mod outline;
pub mod references;
mod remove;
mod rename;
mod tables;

use super::fields::{Schema, TableShape, join, split};
use super::tree::TomlNode;

pub use add::{free_name, values_of};
pub use outline::{OutlineRow, outline};
pub use tables::{declaration, table_of};

/// An edit of what a file is made of. Paths are key paths: `materials.chain`, `lines.a.sections.2`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum StructureEdit {
    /// A table that is new.
    Add {
        /// The path of its table, without its own name: `lines`, `bodies.platform.members`.
        table: String,
        /// Its name, where it is one of several by name.
        name: Option<String>,
        /// Its keys with their values as typed.
        values: Vec<(String, String)>,
    },
    /// Keys of a table set and left out.
    Fill {
        /// Its path.
        path: String,
        /// Keys with their values as typed; none: left out.
        values: Vec<(String, Option<String>)>,
    },
    /// A table taken out, with all tables in it.
    Remove {
        /// Its path.
        path: String,
    },
    /// A copy behind a table.
    Copy {
        /// Its path.
        path: String,
        /// Name of the copy; none where its list knows no names.
        name: Option<String>,
    },
    /// Another name, wherever the file uses it.
    Rename {
        /// Its path.
        path: String,
        /// The new name.
        to: String,
    },
    /// Before the one before it, or behind the one behind it.
    Move {
        /// Its path.
        path: String,
        /// Towards the end.
        down: bool,
    },
    /// One divided into two at a length from its start \[m\].
    Divide {
        /// Its path.
        path: String,
        /// The length of the first part \[m\], as typed.
        at_m: String,
    },
    /// Several edits, one after the other.
    All(Vec<StructureEdit>),
}

/// The text with an edit.
///
/// # Errors
/// Why it cannot be made, as full sentences.
pub fn apply(schema: &'static Schema, text: &str, edit: &StructureEdit) -> Result<String, String> {
    if TomlNode::parse(text).is_err() {
        return Err("The file is not TOML; mend it in an editor first.".to_owned());
    }
    let path_of =
        |path: &str| split(path).ok_or_else(|| format!("`{path}` is not the path of a table."));
    match edit {
        StructureEdit::Add {
            table,
            name,
            values,
        } => add::add(schema, text, &path_of(table)?, name.as_deref(), values),
        StructureEdit::Fill { path, values } => add::fill(schema, text, path, values),
        StructureEdit::Remove { path } => remove::remove(text, &path_of(path)?),
        StructureEdit::Copy { path, name } => {
            rename::copy(schema, text, &path_of(path)?, name.as_deref())
        }
        StructureEdit::Rename { path, to } => rename::rename(schema, text, &path_of(path)?, to),
        StructureEdit::Move { path, down } => order::shift(schema, text, &path_of(path)?, *down),
        StructureEdit::Divide { path, at_m } => divide::divide(schema, text, &path_of(path)?, at_m),
        StructureEdit::All(edits) => edits
            .iter()
            .try_fold(text.to_owned(), |text, edit| apply(schema, &text, edit)),
    }
}

/// Whether a path is that of one of several tables of a kind: `materials.chain`, `lines.a.sections.2`.
#[must_use]
pub fn is_one_of_several(schema: &'static Schema, path: &str) -> bool {
    let found = split(path).and_then(|parts| table_of(schema, &parts));
    found.is_some_and(|(table, named)| named && table.shape != TableShape::One)
}

/// The path without its last part; empty for that of a table of the file.
#[must_use]
pub fn parent(path: &str) -> String {
    let parts = split(path).unwrap_or_default();
    join(&parts[..parts.len().saturating_sub(1)])
}
