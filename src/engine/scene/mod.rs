//! A case made ready to compute: nodes, segments, ends and forces, in SI.
//!
//! [`build()`] makes a [`Scene`] of a case. The [`LumpedLine`] has n segments between n + 1 nodes; each node carries the mass,
//! weight, drag and added mass of the halves of its segments (second order in segment length). Its forces are computed in one
//! pass (`segment_kernel`). All other forces are [`Elements`], listed once. Only what the case names is in the scene. The whole
//! line counts as submerged unless the case says that it crosses the surface.

mod alternate_equilibria;
mod bodies;
mod body_added_mass;
pub mod build;
mod buoyancy;
mod chord_correction;
mod convergence_norm;
mod creep;
mod elasticity;
mod element;
pub mod elements;
mod end_tangent;
mod ends;
mod energy;
mod equation;
mod error;
mod event;
mod explicit;
mod initial_bed_friction;
mod initial_guess;
pub mod initial_shape;
mod irregular_record;
mod labels;
mod length_on_bed;
pub mod line;
pub mod mesh;
mod mixed_iteration;
mod node_tensions;
pub mod outputs;
mod placed_ends;
pub mod rao_file;
mod release;
pub mod rope;
#[expect(clippy::module_inception, reason = "the type of the room")]
pub mod scene;
mod segment_block;
mod segment_kernel;
mod segment_tangent;
mod sliding_length;
mod snap;
mod step_reading;
mod submergence;
mod turning_clamps;
mod unused_inputs;
mod vectors;
pub mod water;
mod wave_kinematics;
mod waves;

pub use bodies::{Hydrodynamics, clump_bed_area, payload_bed_area, shape_form};
pub use build::build;
pub use build::current as current_profile;
pub use buoyancy::spread;
pub use elements::{
    BedContact, DrumPull, Elements, FedEnd, Flexure, MassDamping, PaidOut, RigidPayload,
    TravellingBody,
};
pub use ends::end_motion;
pub(crate) use ends::entry as response_entry;
pub use error::SceneError;
pub use event::{SceneChange, SceneEvent};
pub use initial_bed_friction::LaidFrom;
pub use initial_guess::{ClosedForm, between as straight_between};
pub use irregular_record::{IrregularMotion, IrregularRecord};
pub use labels::{Joint, Labels};
pub use line::{AttachedBody, EndCondition, LumpedLine, Segment};
pub use rope::RopeStiffness;
pub use scene::{InitialState, Scene};
pub use step_reading::EnergyRates;
pub use submergence::{LostBuoyancy, lost_buoyancy};
pub use turning_clamps::ClampLoad;
pub use unused_inputs::loads_without_effect;
pub use vectors::{direction, per_axis};
pub use water::Water;
pub use waves::{records, sea, steep_waves};
