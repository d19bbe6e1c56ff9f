//! What a file says: keys, checks, edits, cross-sections, line types.

pub mod case;
pub mod checks;
pub mod kinds;
pub mod line_types;
pub mod published;
pub mod section;
pub mod templates;
