//! Files of other programs: read, written, audited.

use seacable_base::{files, limits, number, padding, visible};
use seacable_engine::{scene, statics};
use seacable_model::{case, kinds, line_types};
use seacable_numerics as numerics;
use seacable_physics as physics;
use seacable_systems::system;

pub mod audit;
pub mod export;
pub mod import;
pub mod open;
