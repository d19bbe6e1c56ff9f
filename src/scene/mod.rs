//! A case made ready to compute: nodes, segments, ends and loads, in SI.
//!
//! The line is lumped: n segments join n + 1 nodes, each node carries the mass, weight, drag and added
//! mass of the halves of its segments (second order in segment length). Only what the case names is
//! in the scene. The whole line counts as under water.

mod bodies;
pub mod build;
mod buoyancy;
mod equation;
pub mod flexure;
mod foretold;
mod guess;
mod half;
pub mod line;
pub mod reading;
mod shape;

pub use build::{SceneError, build};
pub use flexure::Flexure;
pub use line::{End, Hung, Joint, Scene, Segment};
