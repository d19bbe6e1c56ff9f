//! Writes a run to disk while it is computed.

use std::{
    fs::File,
    io::{BufWriter, Write},
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

use super::{
    CHANNELS, CHECKPOINT, HISTORY, RunLocation, SHAPES, StoreError, complete, create,
    lock::DirectoryLock,
    number,
    shapes::{SHAPE_COLUMNS, write_shape},
    table::CsvWriter,
};
use crate::case::ChannelId;
use crate::files::create_stream;
use crate::run::{Checkpoint, Frame, LineShape, Run, RunInfo, event::Event};

/// How long rows may wait in memory.
const FLUSH: Duration = Duration::from_secs(1);

/// Writes a run while it is computed: [`Writer::begin`], [`Writer::event`] for all that the job says (or
/// [`Writer::channels`] and [`Writer::frame`]), and [`Writer::finish`].
///
/// Dropped without `finish`, it leaves a run marked partial.
#[derive(Debug)]
pub struct Writer {
    dir: PathBuf,
    id: String,
    streams: Option<Streams>,
    flushed: Instant,
    /// The lock on the directory, held while the run is written.
    _held: Option<DirectoryLock>,
}

#[derive(Debug)]
struct Streams {
    history: BufWriter<File>,
    shapes: BufWriter<File>,
}

impl Writer {
    /// Makes the run directory with the exact case and `run.toml` in state partial.
    ///
    /// The name of the run becomes that of the directory, see [`Writer::id`].
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
            streams: None,
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

    /// Writes an event of a job; the end is for [`Writer::finish`].
    ///
    /// # Errors
    /// The system refuses, for example because the disk is full.
    pub fn event(&mut self, event: &Event) -> Result<(), StoreError> {
        match event {
            Event::Started { channels } => self.channels(channels),
            Event::Frame(frame) => self.frame(frame),
            Event::Checkpoint(checkpoint) => self.checkpoint(checkpoint),
            Event::Estimating => self.flush(),
            Event::Finished(_) => Ok(()),
        }
    }

    /// Names the channels that the frames will fill.
    ///
    /// # Errors
    /// The system refuses.
    pub fn channels(&mut self, channels: &[ChannelId]) -> Result<(), StoreError> {
        create::replace(&self.dir, CHANNELS, &complete::channel_units(channels)?)?;
        let names = channels.iter().map(ToString::to_string);
        let columns = std::iter::once("time_s".to_owned()).chain(names);
        let history = self.stream(HISTORY, CsvWriter::new(columns)?)?;
        let shapes = self.stream(SHAPES, CsvWriter::new(SHAPE_COLUMNS)?)?;
        self.streams = Some(Streams { history, shapes });
        Ok(())
    }

    /// Adds an output instant.
    ///
    /// # Errors
    /// The system refuses.
    pub fn frame(&mut self, frame: &Frame) -> Result<(), StoreError> {
        let mut row = CsvWriter::headless();
        row.row(
            std::iter::once(&frame.time)
                .chain(&frame.values)
                .copied()
                .map(number::text),
        )?;
        let row = row.bytes()?;
        let shape = frame.shape.as_ref().map(shape_rows).transpose()?;
        if let Some(streams) = &mut self.streams {
            let put = StoreError::io("Writing", self.dir.join(HISTORY));
            streams.history.write_all(&row).map_err(put)?;
            let put = StoreError::io("Writing", self.dir.join(SHAPES));
            streams
                .shapes
                .write_all(&shape.unwrap_or_default())
                .map_err(put)?;
        }
        if self.flushed.elapsed() >= FLUSH {
            self.flush()?;
        }
        Ok(())
    }

    /// Writes a checkpoint once everything recorded before is on disk.
    fn checkpoint(&mut self, checkpoint: &Checkpoint) -> Result<(), StoreError> {
        self.flush()?;
        let text = toml::to_string(checkpoint).map_err(|error| StoreError::Damaged {
            file: self.dir.join(CHECKPOINT),
            reason: error.to_string(),
        })?;
        create::replace(&self.dir, CHECKPOINT, text.as_bytes())
    }

    /// Writes everything received so far to disk.
    ///
    /// # Errors
    /// The system refuses.
    pub fn flush(&mut self) -> Result<(), StoreError> {
        self.flushed = Instant::now();
        if let Some(streams) = &mut self.streams {
            streams
                .history
                .flush()
                .map_err(StoreError::io("Writing", self.dir.join(HISTORY)))?;
            streams
                .shapes
                .flush()
                .map_err(StoreError::io("Writing", self.dir.join(SHAPES)))?;
        }
        Ok(())
    }

    /// Writes the complete run, `run.toml` with its final state last. Returns the run directory.
    ///
    /// # Errors
    /// The system refuses; the directory then still reads as a partial run.
    pub fn finish(mut self, run: &Run) -> Result<PathBuf, StoreError> {
        self.flush()?;
        let streamed = self.streams.take();
        if let Some(streams) = &streamed {
            for (name, stream) in [(HISTORY, &streams.history), (SHAPES, &streams.shapes)] {
                let file = stream.get_ref();
                file.sync_all()
                    .map_err(StoreError::io("Writing", self.dir.join(name)))?;
            }
        }
        complete::all(&self.dir, &self.id, run, streamed.is_some())?;
        Ok(self.dir)
    }

    /// A file that grows while the run is computed.
    fn stream(&self, name: &str, head: CsvWriter) -> Result<BufWriter<File>, StoreError> {
        let path = self.dir.join(name);
        let file = create_stream(&path).map_err(StoreError::io("Writing", path.clone()))?;
        let mut stream = BufWriter::with_capacity(1 << 16, file);
        let put = StoreError::io("Writing", path);
        stream
            .write_all(&head.bytes()?)
            .and_then(|()| stream.flush())
            .map_err(put)?;
        Ok(stream)
    }
}

fn shape_rows(shape: &LineShape) -> Result<Vec<u8>, StoreError> {
    let mut csv = CsvWriter::headless();
    write_shape(&mut csv, shape)?;
    csv.bytes()
}

/// Writes a run that is already complete. Returns its directory.
///
/// # Errors
/// The directory holds files already, or the system refuses.
pub fn save(place: &RunLocation, run: &Run) -> Result<PathBuf, StoreError> {
    Writer::begin(place, run.info.clone(), &run.case_text)?.finish(run)
}
