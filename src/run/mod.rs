//! A case computed: what came out, what it cost, how far to trust it.
//!
//! [`model`] holds a [`Run`] as plain data; [`store`] keeps it on disk.

pub mod job;
pub mod model;
pub mod store;

pub use model::*;
