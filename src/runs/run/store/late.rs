//! A run of which nothing is on the disk yet, since it may be a matter of milliseconds.
//!
//! Of the load cases of a sweep there are many and each is small: made at its end, a run takes each of its files once, under its name, in a
//! directory that takes its own by one rename. A kill leaves it complete or absent, and the sweep computes it again.

use std::time::{Duration, Instant};

use super::{
    CHECKPOINT, HISTORY, SHAPES, StoreError, complete, create::NewDirectory,
    growing_file::GrowingFile,
};
use crate::run::{Run, RunInfo};

/// How long nothing is on the disk, and how many bytes of rows may wait meanwhile.
const LATEST: Duration = Duration::from_secs(1);
const MOST: usize = 4 << 20;

/// What waits for the run to end or to take longer; its rows wait in their files that are not made.
#[derive(Debug)]
pub(super) struct Late {
    begun: Instant,
    /// As the run begins.
    pub(super) info: RunInfo,
    /// The case as it is computed.
    pub(super) case_text: String,
    /// `channels.csv` without extremes, once the channels are known.
    pub(super) units: Option<Vec<u8>>,
    /// The last checkpoint, sealed.
    pub(super) checkpoint: Option<String>,
}

impl Late {
    /// Of a run that begins.
    pub(super) fn new(info: RunInfo, case_text: &str) -> Self {
        Self {
            begun: Instant::now(),
            info,
            case_text: case_text.to_owned(),
            units: None,
            checkpoint: None,
        }
    }

    /// Whether the run has taken long enough, or so many bytes are too many, to be on the disk.
    pub(super) fn is_due(&self, waiting: usize) -> bool {
        waiting >= MOST || self.begun.elapsed() >= LATEST
    }

    /// Writes the files of the run, which has ended.
    pub(super) fn fill(
        &self,
        new: &mut NewDirectory,
        id: &str,
        run: &Run,
        streams: &[GrowingFile],
    ) -> Result<(), StoreError> {
        for (name, stream) in [HISTORY, SHAPES].into_iter().zip(streams) {
            new.put(name, stream.waiting())?;
        }
        if let Some(text) = &self.checkpoint {
            new.put(CHECKPOINT, text.as_bytes())?;
        }
        let dir = new.place().to_owned();
        let mut put = |name: &str, bytes: &[u8]| new.put(name, bytes);
        complete::all(&dir, id, run, !streams.is_empty(), &mut put)
    }
}
