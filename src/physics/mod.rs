//! Forces on a line, one file a law: each gives its value and its exact tangent, in SI, without reference to a solver or a
//! case file.

pub mod added_mass;
pub mod bed_reaction;
pub mod bending;
pub mod current;
pub mod drag;
pub mod drag_law;
pub mod friction;

pub mod kirchhoff;
pub mod motion;
pub mod payload;
pub mod ramp;
pub mod rigid_body;
pub mod rope;
pub mod sea;
pub mod seabed;
pub mod tension;

pub use current::Current;
pub use drag_law::DragLaw;
pub use friction::{Friction, Grip};
pub use motion::EndMotion;
pub use payload::Body;
pub use rigid_body::RigidBody;
pub use seabed::Seabed;
