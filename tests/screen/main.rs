//! What the screen and the reports show, without a terminal.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../common/sample.rs"]
mod sample;

mod charts;
mod comparison;
mod tables;
mod text_report;
mod workbench;
