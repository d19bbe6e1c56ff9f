//! The program itself: command line, signals, terminal, stored runs.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[cfg(target_os = "linux")]
#[path = "../common/pty.rs"]
mod pty;
#[path = "../common/sample.rs"]
mod sample;
#[path = "../common/small.rs"]
mod small;

mod cli;
mod compare;
mod documents;
mod effects;
mod hostile_files;
mod hostile_text;
mod json;
mod limits;
mod output_files;
mod signals;
mod start_from_run;
mod store;
mod stored_versions;
mod stories;
mod study_speed;
mod system_runs;
mod terminal;
mod vary;
