//! What the screen and the reports show, without a terminal.

#[path = "../common/sample.rs"]
mod sample;

mod charts;
mod tables;
mod text_report;
mod workbench;
