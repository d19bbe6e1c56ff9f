//! Jobs: runs and load cases that are computed behind the screen, each a process of its own that outlives the login.
//!
//! | file | holds |
//! |---|---|
//! | `request.rs`, `sweep.rs` | what a job computes, whoever does: a thread of the screen, or a process |
//! | `jobs_dir.rs`, `folder.rs`, `spec.rs`, `status.rs`, `identity.rs` | the folders of jobs: the request of each, what it says of itself, the process that has it |
//! | `launch.rs`, `turn.rs` | processes are started, and wait for a core |
//! | `process.rs`, `board.rs`, `server.rs`, `socket.rs` | the process of a job, and how it is followed |
//! | `protocol.rs`, `client.rs` | what is said over the socket, and the side of the screen |
//! | `list.rs` | jobs as they are listed |
//! | `survival.rs` | whether the system lets jobs outlive the login |
//!
//! A request is kept before a process is started for it, so that none is lost. Whether a job is computed says the lock of its folder
//! alone, which the system releases however the process ends.

use seacable_base::{background, files, grace, limits, places, strays, visible};
use seacable_model::{case, kinds};
use seacable_report as report;
use seacable_runs::run;
use seacable_studies::study;
use seacable_systems::system;

mod board;
pub mod client;
pub mod folder;
pub mod identity;
mod jobs_dir;
pub mod launch;
pub mod list;
pub mod process;
pub mod protocol;
mod server;
mod socket;
pub mod spec;
pub mod status;
pub mod survival;
mod sweep;
mod turn;

pub use crate::system::motion::job_request::JobRequest;
pub use folder::{JobFolder, JobFolderState};
pub use jobs_dir::{JobError, JobsDir, slot_count};
pub use launch::Launcher;
pub use spec::{JobSpec, JobSubmission, JobWork};
pub use status::{JobPhase, JobStatus};
pub use sweep::on_all_cores_but_one;
pub use sweep::{EndedSweep, SweepEvent, SweepRequest, compute_sweep};
