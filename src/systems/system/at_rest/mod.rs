//! A system at rest as a run computes it: a record of one instant, on meshes that companions and searches change.
//!
//! Studies and searches for an accuracy know a line at rest by its run without steps. A system at rest is the same to them, so that what
//! holds for a chain holds for a platform on three of them.

mod record;
mod refinable_rest;
mod results;
mod searchable_rest;
mod system_at_rest;

pub use record::readings;
pub use results::{main_results, named_result};
pub use system_at_rest::SystemAtRest;
