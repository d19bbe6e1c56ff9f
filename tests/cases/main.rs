//! Case files of every kind: reading, checking, editing, and what the shipped ones compute.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../common/lines.rs"]
mod lines;

mod bad_cases;
mod curves;
mod edit;
mod every_kind;
mod fields;
mod hard_cases;
mod heaved_chains;
mod json_schema;
mod line_tables;
mod papers;
mod random_text;
mod reports;
mod ropeway;
mod ropeway_motion;
mod section;
mod ship;
mod ship_at_sea;
mod shipped;
mod validation;
mod work_counts;
