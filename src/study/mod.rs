//! Studies over many lines: hard cases, each computed by every method that applies and held against what must come out;
//! tables of lines at rest; speed against error of one case.

pub mod hard;
mod judge;
pub mod lines;
pub mod speed;
mod table;

pub use judge::{Finding, Outcome, Tally, tally};
