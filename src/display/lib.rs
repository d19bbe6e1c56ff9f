//! Tables and charts in characters and SVG, of anything.

use seacable_base::{number, padding, visible};
use seacable_numerics as numerics;

pub mod chart;
pub mod markup;
pub mod plain;
pub mod table;
pub mod wrap;
