//! A case computed, and compared with what is published.

use seacable_base::{background, clock, files, limits, number, seal, strays, visible};
use seacable_display::table;
use seacable_engine::{dynamics, modes, scene, solve, statics};
#[cfg(test)]
use seacable_model::section;
use seacable_model::{case, checks, published};
use seacable_numerics as numerics;
use seacable_physics as physics;
use seacable_statistics::fatigue;

pub mod reference;
pub mod run;
