//! Studies over many runs: hard cases, each computed by every method that applies and held against what must come out.

pub mod hard;
mod judge;
mod table;

pub use judge::{Finding, Outcome, Tally, tally};
