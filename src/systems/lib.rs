//! Systems of lines, and the ropeways and ships that are computed as such.

use seacable_base::{background, files, limits, number, visible, work_log};
use seacable_engine::{dynamics, line_between_ends, modes, scene, solve, statics};
use seacable_model::{case, checks, kinds, published};
use seacable_numerics as numerics;
use seacable_physics as physics;
use seacable_runs::{reference, run};

pub mod ropeway;
pub mod ship;
pub mod system;
