//! The case file: what the user says, in TOML, with the unit of every number in its key.
//!
//! [`model`] holds the words, as plain data.

pub mod model;

pub use model::*;
