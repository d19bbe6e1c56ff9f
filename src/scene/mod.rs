//! A case made ready to compute: nodes, segments, ends and loads, in SI.
//!
//! The line is lumped: n segments join n + 1 nodes, each node carries the mass, weight, drag and added
//! mass of the halves of its segments (second order in segment length). Only what the case names is
//! in the scene. The whole line counts as under water, unless
//! the case says that it crosses the surface.

mod bed;
mod bodies;
mod books;
pub mod build;
mod buoyancy;
pub mod division;
mod elasticity;
mod ends;
mod equation;
mod event;
mod excess;
mod explicit;
mod felt;
pub mod flexure;
mod foretold;
mod guess;
mod half;
mod idle;
mod laid;
pub mod line;
mod mirror;
pub mod reading;
pub mod rope;
mod sea;
mod segments;
mod shape;
mod traveller;
mod turning;
pub mod water;
mod wetting;

pub use build::{SceneError, build};
pub(crate) use ends::entry as response_entry;
pub use event::{Change, Event};
pub use flexure::Flexure;
pub use line::{End, Hung, Joint, Scene, Segment};
pub use rope::RopeReading;
pub use sea::{Record, records};
pub use traveller::Traveller;
pub use turning::Turning;
pub use water::Water;
