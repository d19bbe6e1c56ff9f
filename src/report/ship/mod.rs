//! A ship at a single-point mooring in charts, tables and a text report.

pub mod coupled;
pub mod motion;
pub mod plan;
pub mod rope;
pub mod statics;
pub mod text;
