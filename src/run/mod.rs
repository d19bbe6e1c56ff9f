//! A case computed: what came out, what it cost, how far to trust it.
//!
//! [`model`] holds a [`Run`] as plain data; [`store`] keeps it on disk.

mod along;
mod began;
mod checkpoint;
mod compute;
pub mod curves;
mod cycles;
mod envelope;
mod errors;
mod front;
mod gather;
pub mod job;
pub mod limits;
mod marching;
pub mod model;
mod modes;
mod names;
mod onward;
mod opposed;
mod peaks;
mod recorder;
pub mod response;
mod rest;
mod ropes;
pub mod settings;
pub mod statistic;
mod steady;
pub mod store;
mod tape;
mod thin;

pub use along::evaluate as along_line;
pub use checkpoint::{Checkpoint, Resume};
pub use model::*;
pub use names::quantity_name;
pub use onward::onward;
pub use ropes::RopeProfile;
pub use thin::Thinned;
