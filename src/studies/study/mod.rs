//! Studies over many lines: hard cases, each computed by every method that applies and compared with expected values;
//! tables of lines at rest; speed against error of one case.

pub mod base_run;
pub mod effects;
pub mod hard_cases;
pub mod lines;
pub mod load_case_table;
pub mod physics;
pub mod points;
pub mod record_statistics;
pub mod results;
pub mod seas;
pub mod speed;
pub mod studied;
pub mod study_job;
pub mod sweep;
pub mod timed;
mod tried;
pub mod vary;
mod verdict;
mod verdict_table;
pub mod window;

pub use verdict::{TrialOutcome, TrialTally, TrialVerdict, tally};
