//! Forces on a line, one file a law: each gives its value and its exact tangent, in SI, without reference to a solver or a
//! case file.

use seacable_numerics as numerics;

pub mod added_mass;
pub mod bed_friction;
pub mod bed_reaction;
pub mod bending;
pub mod current;
pub mod current_grid;
pub mod drag;
pub mod drag_law;

pub mod kirchhoff;
pub mod motion;
pub mod node_direction;
pub mod payload;
pub mod ramp;
pub mod rigid_body;
pub mod rope;
pub mod sea;
pub mod seabed;
pub mod suction;
pub mod tension;
pub mod wall_tension;

pub use bed_friction::{Friction, FrictionAnchor};
pub use current::CurrentProfile;
pub use current_grid::{CurrentGrid, CurrentGridError};
pub use drag_law::DragLaw;
pub use motion::EndMotion;
pub use node_direction::NodeDirection;
pub use payload::BodyProperties;
pub use rigid_body::RigidBody;
pub use seabed::ElasticBed;
pub use suction::Suction;
pub use wall_tension::PipeWall;
