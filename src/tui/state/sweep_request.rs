//! A sweep that is asked for on the screen, and what the threads behind it say of sweeps.

use std::path::PathBuf;
use std::sync::Arc;

use super::JobNumber;
use super::sweep_verdict::SweepVerdict;
use super::sweeps::SweepRead;
pub use crate::jobs::SweepRequest;
use crate::study::sweep::{SweepEntry, SweepProgress, SweepSnapshot};

/// What the screen asks of sweeps.
#[derive(Debug, Clone)]
pub enum SweepEffect {
    /// List the stored sweeps of a case file.
    List(String),
    /// Read a sweep, or what is new in one that is known.
    Read {
        /// Its folder.
        dir: PathBuf,
        /// What is known of it.
        known: Option<Arc<SweepSnapshot>>,
    },
    /// Work out what its load cases say together.
    Check(Arc<SweepSnapshot>),
    /// Whether a sweep is of these load cases and inputs.
    Compare(Arc<SweepSnapshot>, Box<SweepRequest>),
    /// Compute load cases, as the job of this number: go on where a stored sweep is of exactly these.
    Start(JobNumber, Box<SweepRequest>),
}

/// What is said of sweeps.
#[derive(Debug, Clone)]
pub enum SweepMsg {
    /// The stored sweeps of a case file.
    Listed(String, Vec<SweepEntry>),
    /// A sweep as read, or why it cannot be.
    Read(PathBuf, Result<SweepRead, String>),
    /// What the load cases of the sweep in this folder say together.
    Checked(PathBuf, Arc<SweepVerdict>),
    /// Whether the sweep in this folder is of the load cases and inputs of this text.
    Compared(PathBuf, String, bool),
    /// A job computes the sweep in this folder.
    Begun(JobNumber, PathBuf),
    /// How far it is, after so many seconds.
    Progress(JobNumber, SweepProgress, f64),
    /// It has ended: the sweep as it is then, and whether it was cancelled; or why it failed.
    Ended(JobNumber, Result<(SweepRead, bool), String>),
}
