//! A case made ready to compute: nodes, segments, ends and loads, in SI.
//!
//! The line is lumped: n segments join n + 1 nodes, each node carries the mass, weight, drag and added
//! mass of the halves of its segments (second order in segment length). Only what the case names is
//! in the scene. The whole line counts as under water, unless
//! the case says that it crosses the surface.

mod alternate_equilibria;
mod bed;
mod bodies;
pub mod build;
mod buoyancy;
mod chord_correction;
mod convergence_norm;
mod elasticity;
mod ends;
mod energy;
mod equation;
mod event;
mod explicit;
pub mod flexure;
mod initial_friction;
mod initial_guess;
mod initial_shape;
pub mod line;
pub mod mesh;
mod mixed_iteration;
pub mod outputs;
mod rigid_payload;
pub mod rope;
mod segment_kernel;
mod segment_tangent;
mod submergence;
mod traveller;
mod unused_inputs;
pub mod water;
mod waves;

pub use build::{SceneError, build};
pub(crate) use ends::entry as response_entry;
pub use event::{Change, Event};
pub use flexure::Flexure;
pub use line::{AttachedBody, End, Joint, Scene, Segment};
pub use rigid_payload::RigidPayload;
pub use rope::RopeStiffness;
pub use traveller::Traveller;
pub use water::Water;
pub use waves::{Record, records};
