//! An index of the runs below a directory: a database from which lists, tables and filters of ten thousand runs are made
//! without opening their files.
//!
//! The directories of the runs are what counts; the database is only read from them, and may be lost at any time. It lies in
//! the user's cache folder, one for each host and each directory of runs, so that no lock ever goes over a network. Where it
//! cannot be written, it is kept in memory; where it is damaged, it is made anew.
//!
//! [`RunIndex::sync`] brings it in step with the directories: those whose `run.toml` or directory has another time or size
//! than when they were read are read again. Any number of programs may do so at once.
//!
//! Of the inputs of a run only those are kept that differ from the first run of its case file that was read
//! (`baseline`): what differs among runs is then a short list.

mod baseline;
mod database;
mod folder;
mod query;
mod sync;

#[cfg(test)]
mod tests;

use crate::visible;
use std::path::{Path, PathBuf};

use rusqlite::Connection;

use super::RunState;
use super::store::RunNotes;
use crate::case::TextDigest;

pub use query::{InputColumn, MeasuredResult, ResultColumn, RunColumns, RunRows};
pub use sync::SyncProgress;

/// Why the index gives no answer.
#[derive(Debug, thiserror::Error)]
pub enum IndexError {
    /// The directory of the runs cannot be listed.
    #[error("{} cannot be listed: {error}", visible::path(dir))]
    Folder {
        /// The directory.
        dir: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// The database fails, also when made anew.
    #[error("the index of the runs fails: {0}")]
    Database(#[from] rusqlite::Error),
}

/// A run as the index knows it.
#[derive(Debug, Clone, PartialEq)]
pub struct IndexedRun {
    /// Its number in the index; another one after the index was made anew.
    pub id: i64,
    /// Name of its directory.
    pub name: String,
    /// File name of its case.
    pub case_file: String,
    /// Its state.
    pub state: RunState,
    /// Why it failed, or why it cannot be read.
    pub failure: Option<String>,
    /// True where `run.toml` cannot be understood; all else is then empty.
    pub damaged: bool,
    /// When it began, RFC 3339 in UTC.
    pub started: String,
    /// Its method.
    pub method: String,
    /// Simulated time asked for \[s\].
    pub duration_s: f64,
    /// Accepted time steps.
    pub steps: u64,
    /// CPU time of the run itself \[s\].
    pub cpu_s: f64,
    /// Keys set on top of the case file, as `key=value`.
    pub overrides: Vec<String>,
    /// The digest of its case.
    pub text: TextDigest,
    /// What the user says of it.
    pub notes: RunNotes,
}

/// The index of the runs below one directory.
#[derive(Debug)]
pub struct RunIndex {
    root: PathBuf,
    /// Where the database is; absent where it is in memory.
    file: Option<PathBuf>,
    database: Connection,
}

impl RunIndex {
    /// Opens the index of the runs below a directory, which need not exist yet, with its database in this folder.
    ///
    /// # Errors
    /// Not even a database in memory can be had.
    pub fn open(root: &Path, cache: Option<&Path>) -> Result<Self, IndexError> {
        let file = cache.map(|cache| cache.join(database::file_name(root)));
        let (database, file) = database::open(file)?;
        Ok(Self {
            root: root.to_owned(),
            file,
            database,
        })
    }

    /// The directory of the runs.
    #[must_use]
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Makes the database anew where an error says that it is damaged, and returns whether it did.
    ///
    /// # Errors
    /// The error, where that is not why; or not even a database in memory can be had.
    pub fn mend(&mut self, error: IndexError) -> Result<(), IndexError> {
        if !database::is_damaged(&error) {
            return Err(error);
        }
        self.database = Connection::open_in_memory()?;
        database::remove(self.file.as_deref());
        let (database, file) = database::open(self.file.take())?;
        (self.database, self.file) = (database, file);
        Ok(())
    }
}
