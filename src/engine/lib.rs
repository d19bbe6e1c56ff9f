//! Lines in SI: forces as elements, statics, dynamics, modes.

use seacable_base::{number, work_log};
use seacable_model::case;
use seacable_numerics as numerics;
use seacable_physics as physics;

pub mod dynamics;
pub mod line_between_ends;
pub mod modes;
pub mod scene;
pub mod solve;
pub mod statics;
