//! A case computed: what came out, what it cost, how far to trust it.
//!
//! [`model`] holds a [`Run`] as plain data; [`store`] keeps it on disk.

mod along;
mod compute;
mod errors;
pub mod job;
pub mod limits;
pub mod model;
mod names;
mod recorder;
pub mod settings;
pub mod statistic;
pub mod store;

pub use model::*;
pub use names::quantity_name;
