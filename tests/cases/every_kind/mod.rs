//! What holds for files of every kind: edits of structure, parameters, templates.

mod parameters;
mod structure;
mod templates;
