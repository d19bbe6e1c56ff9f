//! Records a job while it is computed, and says when it cannot be stored any more.

use std::path::{Path, PathBuf};

use super::{RunLocation, RunWriter, StoreError};
use crate::run::{Run, RunInfo, RunState, event::JobEvent};

/// A run that is stored while it is computed, by a caller that stops computing where it cannot be stored.
#[derive(Debug)]
pub struct StoringRecorder {
    writer: RunWriter,
    failure: Option<StoreError>,
}

impl StoringRecorder {
    /// Makes the run directory, see [`RunWriter::begin`].
    ///
    /// # Errors
    /// As [`RunWriter::begin`].
    pub fn begin(place: &RunLocation, info: RunInfo, case_text: &str) -> Result<Self, StoreError> {
        Ok(Self {
            writer: RunWriter::begin(place, info, case_text)?,
            failure: None,
        })
    }

    /// The same for a run that may be a matter of milliseconds, see [`RunWriter::begin_late`].
    ///
    /// # Errors
    /// As [`RunWriter::begin_late`].
    pub fn begin_late(dir: &Path, info: RunInfo, case_text: &str) -> Result<Self, StoreError> {
        Ok(Self {
            writer: RunWriter::begin_late(dir, info, case_text)?,
            failure: None,
        })
    }

    /// The run's name.
    #[must_use]
    pub fn id(&self) -> &str {
        self.writer.id()
    }

    /// The run directory.
    #[must_use]
    pub fn dir(&self) -> &Path {
        self.writer.dir()
    }

    /// Writes an event; whether it is of use to go on. After a failure nothing more is written.
    pub fn event(&mut self, event: &JobEvent) -> bool {
        if self.failure.is_none() {
            self.failure = self.writer.event(event).err();
        }
        self.failure.is_none() && self.writer.full().is_none()
    }

    /// Writes the end of the run, and returns its directory. A run that ended because [`StoringRecorder::event`] said so, and not because it was
    /// `stopped` otherwise, becomes a failed one.
    ///
    /// # Errors
    /// The run could not be stored, or only up to where the disk was full.
    pub fn finish(self, run: &mut Run, stopped: bool) -> Result<PathBuf, StoreError> {
        if let Some(error) = self.failure {
            self.writer.give_up(&run.info, &error);
            return Err(error);
        }
        self.writer.id().clone_into(&mut run.info.id);
        let full = self.writer.full().map(str::to_owned);
        let full = full.filter(|_| run.info.state == RunState::Cancelled && !stopped);
        if let Some(why) = &full {
            run.info.state = RunState::Failed;
            run.info.failure = Some(why.clone());
        }
        let dir = self.writer.finish(run)?;
        match full {
            Some(why) => Err(StoreError::Full { why, dir }),
            None => Ok(dir),
        }
    }
}
