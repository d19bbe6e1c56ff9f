//! A case computed: what came out, what it cost, how far to trust it.
//!
//! [`model`] holds a [`Run`] as plain data.

pub mod job;
pub mod model;

pub use model::*;
