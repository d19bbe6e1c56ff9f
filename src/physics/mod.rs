//! Forces on a line, one file a force: each gives its value and its exact tangent. No solver is known
//! here, and no case file: numbers in SI.

pub mod added_mass;
pub mod bending;
pub mod current;
pub mod drag;
pub mod drag_law;
pub mod friction;
pub mod growth;
pub mod kirchhoff;
pub mod motion;
pub mod payload;
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
