//! Runs on disk: one directory a run, readable with any editor, spreadsheet or numpy.
//!
//! | file | holds |
//! |---|---|
//! | `case.toml` | the exact input, overrides applied |
//! | `run.toml` | [`RunInfo`](super::RunInfo): state, settings, work, cost, warnings, version |
//! | `summary.csv` | `quantity,value,unit,error_estimate` |
//! | `errors.csv` | `quantity,unit,time_error,mesh_error,least,greatest`: the two parts of the error estimate; the range of a result that is not settled |
//! | `channels.csv` | `channel,unit,max,time_of_max_s,min,time_of_min_s`, over every step of the solver |
//! | `history.csv` | `time_s` and one column a channel, at the output times |
//! | `profile.csv` | the line node by node at the end, and its envelope over time |
//! | `ropes.csv` | dynamic stiffness along the ropes that have it, at the end, and its envelope over time |
//! | `notes.toml` | the name, tags and note that the user gave the run, where there are any |
//! | `checkpoint.toml` | everything that is needed to resume the run |
//! | `shapes.csv` | `time_s,node,x_m,y_m,z_m,tension_n`: stored shapes one after the other |
//!
//! **A kill at any moment leaves either the complete run or one marked `partial`.** The directory
//! appears under its name with `case.toml` and `run.toml` (state `partial`) already in it; history and
//! shapes grow while the run goes on; at the end every file is written beside its name, synced and
//! renamed, and `run.toml` with the final state goes last. A load case of a sweep that ends within a second is on the disk only then: in a
//! hidden directory that takes its name once all its files are synced, so that a kill leaves it complete or absent. While a program computes a run it holds a lock on the
//! directory ([`is_locked`]), so that a partial run under way is distinguished from one that was killed.
//!
//! A checkpoint ends with a seal (`src/base/seal.rs`): it is whole, and belongs to the case, the history and the shapes beside it, or is refused.
//!
//! Numbers are written with the fewest digits that read back to the same bits.

mod channel_rows;
mod columns;
mod complete;
mod create;
mod fatigue_csv;
mod growing_file;
mod history_csv;
mod late;
mod list;
mod lock;
mod notes;
mod number;
mod profile_csv;
mod read;
mod recorder;
mod reserve;
mod run_writer;
mod shapes_csv;
mod table;

use crate::visible;
use std::{io, path::PathBuf};

use crate::files::WriteError;

pub use crate::clock::{now, rfc3339, stamp};
pub use channel_rows::{ChannelRows, channel_rows};
pub use create::{RunLocation, delete};
pub use create::{remove_left_beside, stem};
pub use fatigue_csv::fatigue_spots;
pub(in crate::run) use history_csv::HistoryReader;
pub use history_csv::write_history;
pub use list::{StoredRun, list};
pub use lock::is_locked;
pub use lock::{DirectoryLock, lock_directory};
pub use notes::RunNotes;
pub use read::sealed_checkpoint;
pub use read::{case_text, channel_extremes, read, read_info, read_results, resume};
pub use recorder::StoringRecorder;
pub use run_writer::{RunWriter, save};
pub(in crate::run) use shapes_csv::ShapeReader;

/// The directory under which runs are kept unless the user says otherwise.
pub const DEFAULT_ROOT: &str = "runs";

/// The file of the case.
pub const CASE: &str = "case.toml";
/// The file that says what the run is.
pub const RUN: &str = "run.toml";
pub(crate) const SUMMARY: &str = "summary.csv";
pub(crate) const ERRORS: &str = "errors.csv";
pub(crate) const CHANNELS: &str = "channels.csv";
/// The file of the histories.
pub const HISTORY: &str = "history.csv";
pub(crate) const PROFILE: &str = "profile.csv";
pub(crate) const ROPES: &str = "ropes.csv";
pub(crate) const SHAPES: &str = "shapes.csv";
pub(crate) const CHECKPOINT: &str = "checkpoint.toml";
pub(crate) const FATIGUE: &str = "fatigue.csv";
pub(crate) const NOTES: &str = "notes.toml";

/// All files of a run.
pub const FILES: [&str; 12] = [
    CASE, RUN, SUMMARY, ERRORS, CHANNELS, HISTORY, PROFILE, ROPES, SHAPES, FATIGUE, CHECKPOINT,
    NOTES,
];

/// Why a run cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// The directory is inside another run.
    #[error("{} would be inside the run that its parent directory is. Name another directory.", visible::path(.0))]
    InRun(PathBuf),
    /// Nothing is there.
    #[error("There is no run directory at {}.", visible::path(.0))]
    NotFound(PathBuf),
    /// Something is there, but not a run.
    #[error("{} is not a run directory: it holds no run.toml. A run directory is what `seacable run` writes.", visible::path(.0))]
    NotARun(PathBuf),
    /// `run.toml` cannot be understood, so nothing else can be trusted.
    #[error("{} cannot be read: {reason}", visible::path(file))]
    Damaged {
        /// The file.
        file: PathBuf,
        /// What is wrong, with line and column where known.
        reason: String,
    },
    /// A run that cannot be resumed.
    #[error("{} has no checkpoint.toml to resume from: it is static, or its checkpoint was removed.", visible::path(.0))]
    NoCheckpoint(PathBuf),
    /// The directory chosen for a run already holds something.
    #[error("{} already holds files; a run never overwrites. Name a directory that does not exist yet.", visible::path(.0))]
    Taken(PathBuf),
    /// A file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// The disk was full: the run ended there, and can be resumed.
    #[error(
        "{why}. {} holds the run up to there; `seacable run --resume` goes on from it where there is room.",
        visible::path(dir)
    )]
    Full {
        /// What the system said.
        why: String,
        /// The run directory.
        dir: PathBuf,
    },
    /// The operating system refused.
    #[error("{action} {} failed: {source}", visible::path(path))]
    Io {
        /// What was tried ("Writing").
        action: &'static str,
        /// On what.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
}

impl StoreError {
    /// Whether there was no room on the disk.
    fn is_full_disk(&self) -> bool {
        let (Self::Io { source, .. } | Self::Write(WriteError::Io { source, .. })) = self else {
            return false;
        };
        matches!(
            source.kind(),
            io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded
        )
    }

    /// Wraps what the system said with what was tried on which file.
    fn io(action: &'static str, path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |source| Self::Io {
            action,
            path,
            source,
        }
    }
}
