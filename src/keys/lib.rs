//! The keys of a file in TOML: their declaration, tree, edits, expressions and diagnostics. It knows no cable.

use seacable_base::{files, limits, visible};

pub mod check;
pub mod decimal;
pub mod diagnostic;
pub mod edit;
pub mod fields;
pub mod parameters;
pub mod read;
pub mod schema;
pub mod size;
pub mod structure;
pub mod text_lines;
pub mod tree;
pub mod typed_value;

/// What the macros write with.
#[doc(hidden)]
pub use toml_edit;

pub use diagnostic::{Diagnostic, Finding};
pub use tree::{TomlEntry, TomlNode};
