//! A case computed: what came out, what it cost, how far to trust it.
//!
//! [`model`] holds a [`Run`] as plain data; [`store`] keeps it on disk.

pub mod job;
pub mod model;
mod names;
pub mod store;

pub use model::*;
pub use names::quantity_name;
