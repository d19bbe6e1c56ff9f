//! Tables and charts in characters and SVG, of anything.

pub mod chart;
pub(crate) mod markup;
pub mod plain;
pub mod table;
pub(crate) mod wrap;
