//! Studies of cases, and runs compared.

use seacable_base::{background, files, limits, number, seal, strays, visible};
use seacable_display::{chart, table};
use seacable_engine::{scene, statics};
use seacable_model::{case, checks, kinds};
use seacable_numerics as numerics;
use seacable_physics as physics;
use seacable_runs::{reference, run};
use seacable_statistics::{extremes, fatigue};
use seacable_systems::system;

pub mod comparison;
pub mod laboratory;
pub mod study;
