//! Ropes whose stiffness is not one number, against what they must do.
#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

#[path = "rope/dynamic.rs"]
mod dynamic;
mod lines;
#[path = "lines/march.rs"]
mod march;
#[path = "rope/mooring.rs"]
mod mooring;
#[path = "lines/rest.rs"]
mod rest;
#[path = "rope/table.rs"]
mod table;
