//! The case file: what the user says, in TOML, with the unit of every number in its key.
//!
//! [`model`] holds the words, as plain data; [`channels`] names what a run of the case records.

pub mod channels;
pub mod model;

pub use channels::{Channel, LineEnd, Source, channels};
pub use model::*;
