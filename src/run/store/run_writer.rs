//! Writes a run to disk while it is computed.

use std::{
    fs::File,
    io::{self, BufWriter, Write},
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

use super::{
    CHANNELS, CHECKPOINT, HISTORY, RunLocation, SHAPES, StoreError, complete, create,
    history_csv::{history_header, history_row},
    lock::DirectoryLock,
    shapes_csv::{SHAPE_COLUMNS, shape_rows},
    table::CsvWriter,
};
use crate::case::ChannelId;
use crate::files::create_stream;
use crate::run::{Checkpoint, OutputFrame, Run, RunInfo, event::JobEvent};

/// How long rows may wait in memory.
const FLUSH: Duration = Duration::from_secs(1);

/// Writes a run while it is computed: [`RunWriter::begin`], [`RunWriter::event`] for all that the job says (or
/// [`RunWriter::channels`] and [`RunWriter::frame`]), and [`RunWriter::finish`].
///
/// Dropped without `finish`, it leaves a run marked partial.
#[derive(Debug)]
pub struct RunWriter {
    dir: PathBuf,
    id: String,
    /// History and shapes, once the channels are known.
    streams: Vec<GrowingFile>,
    flushed: Instant,
    /// The lock on the directory, held while the run is written.
    _held: Option<DirectoryLock>,
}

/// A file that grows while the run is computed.
#[derive(Debug)]
struct GrowingFile {
    path: PathBuf,
    file: BufWriter<File>,
}

impl GrowingFile {
    /// A new file with the names of its columns.
    fn create(path: PathBuf, head: CsvWriter) -> Result<Self, StoreError> {
        let file = create_stream(&path).map_err(StoreError::io("Writing", &path))?;
        let file = BufWriter::with_capacity(1 << 16, file);
        let mut stream = Self { path, file };
        stream.write(&head.bytes()?)?;
        stream.flush()?;
        Ok(stream)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), StoreError> {
        let written = self.file.write_all(bytes);
        self.check(written)
    }

    fn flush(&mut self) -> Result<(), StoreError> {
        let flushed = self.file.flush();
        self.check(flushed)
    }

    fn sync(&self) -> Result<(), StoreError> {
        self.check(self.file.get_ref().sync_all())
    }

    fn check(&self, result: io::Result<()>) -> Result<(), StoreError> {
        result.map_err(|error| StoreError::io("Writing", &self.path)(error))
    }
}

impl RunWriter {
    /// Makes the run directory with the exact case and `run.toml` in state partial.
    ///
    /// The name of the run becomes that of the directory, see [`RunWriter::id`].
    ///
    /// # Errors
    /// The directory holds files already, or the system refuses.
    pub fn begin(
        place: &RunLocation,
        mut info: RunInfo,
        case_text: &str,
    ) -> Result<Self, StoreError> {
        let (dir, held) = create::create(place, &mut info, case_text)?;
        Ok(Self {
            dir,
            id: info.id,
            streams: Vec::new(),
            flushed: Instant::now(),
            _held: held,
        })
    }

    /// The run directory.
    #[must_use]
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// The run's name: that of its directory.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// Writes an event of a job; the end is for [`RunWriter::finish`].
    ///
    /// # Errors
    /// The system refuses, for example because the disk is full.
    pub fn event(&mut self, event: &JobEvent) -> Result<(), StoreError> {
        match event {
            JobEvent::Started { channels } => self.channels(channels),
            JobEvent::Frame(frame) => self.frame(frame),
            JobEvent::Checkpoint(checkpoint) => self.checkpoint(checkpoint),
            JobEvent::SystemCheckpoint(text) => self.checkpoint_text(text),
            JobEvent::Estimating => self.flush(),
            JobEvent::Searching(_) | JobEvent::Finished(_) => Ok(()),
        }
    }

    /// Names the channels that the frames will fill.
    ///
    /// # Errors
    /// The system refuses.
    pub fn channels(&mut self, channels: &[ChannelId]) -> Result<(), StoreError> {
        create::replace(&self.dir, CHANNELS, &complete::channel_units(channels)?)?;
        let header = history_header(channels.iter())?;
        let history = GrowingFile::create(self.dir.join(HISTORY), header)?;
        let shapes = GrowingFile::create(self.dir.join(SHAPES), CsvWriter::new(SHAPE_COLUMNS)?)?;
        self.streams = vec![history, shapes];
        Ok(())
    }

    /// Adds an output instant.
    ///
    /// # Errors
    /// The system refuses.
    pub fn frame(&mut self, frame: &OutputFrame) -> Result<(), StoreError> {
        if let [history, shapes] = &mut self.streams[..] {
            history.write(history_row(frame).as_bytes())?;
            if let Some(shape) = &frame.shape {
                shapes.write(shape_rows(shape).as_bytes())?;
            }
        }
        if self.flushed.elapsed() >= FLUSH {
            self.flush()?;
        }
        Ok(())
    }

    /// Writes a checkpoint once everything recorded before is on disk.
    fn checkpoint(&mut self, checkpoint: &Checkpoint) -> Result<(), StoreError> {
        let text = toml::to_string(checkpoint).map_err(|error| StoreError::Damaged {
            file: self.dir.join(CHECKPOINT),
            reason: error.to_string(),
        })?;
        self.checkpoint_text(&text)
    }

    fn checkpoint_text(&mut self, text: &str) -> Result<(), StoreError> {
        self.flush()?;
        create::replace(&self.dir, CHECKPOINT, text.as_bytes())
    }

    /// Writes everything received so far to disk.
    ///
    /// # Errors
    /// The system refuses.
    pub fn flush(&mut self) -> Result<(), StoreError> {
        self.flushed = Instant::now();
        self.streams.iter_mut().try_for_each(GrowingFile::flush)
    }

    /// Writes the complete run, `run.toml` with its final state last. Returns the run directory.
    ///
    /// # Errors
    /// The system refuses; the directory then still reads as a partial run.
    pub fn finish(mut self, run: &Run) -> Result<PathBuf, StoreError> {
        self.flush()?;
        self.streams.iter().try_for_each(GrowingFile::sync)?;
        let streamed = !self.streams.is_empty();
        complete::all(&self.dir, &self.id, run, streamed)?;
        Ok(self.dir)
    }
}

/// Writes a run that is already complete. Returns its directory.
///
/// # Errors
/// The directory holds files already, or the system refuses.
pub fn save(place: &RunLocation, run: &Run) -> Result<PathBuf, StoreError> {
    RunWriter::begin(place, run.info.clone(), &run.case_text)?.finish(run)
}
