//! Files that were once answered wrongly, refused or ended by a panic, each with its right answer and where that comes from.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../common/many_lines.rs"]
mod many_lines;

mod above_water;
mod audit_remedies;
mod equilibrium;
mod errors_at_rest;
mod friction_on_bed;
mod importers;
mod loads_without_effect;
mod loud;
mod members;
mod start;
mod stiffness_tables;
mod top_heavy;
mod trial;
mod zero_bars;
