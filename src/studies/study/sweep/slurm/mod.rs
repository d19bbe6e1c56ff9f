//! A sweep as a job array of Slurm, on a cluster whose machines share a folder: the text of the script, what is asked of Slurm's commands
//! and what they answer, and what the folder of the sweep keeps of it. Nothing here waits; who watches does.
//!
//! A task of the array computes a [`Part`](super::SweepPart). An array that is submitted again has the same script and only the tasks that have
//! load cases missing; those stored are passed over.

mod command;
mod division;
mod option;
mod queue;
mod record;
mod script;

pub use command::CommandFailed;
pub use division::{Division, array_list};
pub use option::{Unfit, check_of_file, check_option};
pub use queue::{Queue, submit};
pub use record::{SlurmFile, SlurmRecord, Submission};
pub use script::{Script, job_name};

/// The script in the folder of a sweep.
pub const SCRIPT: &str = "array.sh";
/// The record in the folder of a sweep.
pub const RECORD: &str = "slurm.toml";
