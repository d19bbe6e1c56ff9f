//! What a file says: keys, checks, edits, cross-sections, line types.

use seacable_base::{files, limits, number, seal, visible, work_log};
use seacable_numerics as numerics;
use seacable_physics as physics;
use seacable_statistics::fatigue;

pub mod case;
pub mod checks;
pub mod kinds;
pub mod line_types;
pub mod published;
pub mod section;
pub mod templates;
