//! The program itself: command line, signals, terminal, stored runs.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[cfg(target_os = "linux")]
#[path = "../common/jobs.rs"]
mod jobs;
#[cfg(target_os = "linux")]
#[path = "../common/many_lines.rs"]
mod many_lines;
#[cfg(target_os = "linux")]
#[path = "../common/pty.rs"]
mod pty;
#[path = "../common/reseal.rs"]
mod reseal;
#[path = "../common/sample.rs"]
mod sample;
#[path = "../common/small.rs"]
mod small;

mod chance;
mod clearance_checks;
mod cli;
mod compare;
mod damage;
mod documents;
mod effects;
mod faults;
mod full_disk;
mod hostile_files;
mod hostile_screen;
mod hostile_text;
#[cfg(target_os = "linux")]
mod job_stories;
mod json;
mod kills;
mod kills_editor;
mod limits;
mod manners;
mod output_files;
mod read_once;
mod reports;
mod signals;
mod standard_output;
mod start_from_run;
mod statistics;
mod store;
mod stored_versions;
mod stories;
mod study_bars;
mod study_speed;
mod sweep;
mod sweep_checks;
mod sweep_finer;
mod sweep_quick;
mod sweep_scale;
mod sweep_screen;
mod sweep_slurm;
mod system_runs;
mod terminal;
mod vary;
