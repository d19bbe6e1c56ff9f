//! Writes a run to disk while it is computed.

use std::{
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

use super::{
    CASE, CHANNELS, CHECKPOINT, HISTORY, RunLocation, SHAPES, StoreError, complete, create,
    growing_file::GrowingFile,
    history_csv::{history_header, history_row},
    late::Late,
    lock::DirectoryLock,
    reserve::Reserve,
    shapes_csv::{self, shape_rows},
    table::CsvWriter,
};
use crate::case::ChannelId;
use crate::files::unsaved::Unsaved;
use crate::run::{OutputFrame, Run, RunInfo, RunState, event::JobEvent};
use crate::seal::{Digest, Seal, sealed};

/// How long rows may wait in memory.
const FLUSH: Duration = Duration::from_secs(1);

/// Writes a run while it is computed: [`RunWriter::begin`], [`RunWriter::event`] for all that the job says (or
/// [`RunWriter::begin_record`] and [`RunWriter::frame`]), and [`RunWriter::finish`].
///
/// Dropped without `finish`, it leaves a run marked partial.
#[derive(Debug)]
pub struct RunWriter {
    dir: PathBuf,
    id: String,
    /// While nothing is on the disk.
    late: Option<Late>,
    /// Names of the lines; none of a line by itself.
    lines: Vec<String>,
    /// History and shapes, once the channels are known.
    streams: Vec<GrowingFile>,
    flushed: Instant,
    /// Digest of the case as it is on disk.
    case: Digest,
    /// The case as it is computed, to be written with the first checkpoint of it.
    case_due: Option<String>,
    /// Room on the disk for the end of the run.
    reserve: Reserve,
    /// What the system said when the disk was full and the reserve was given up.
    full: Option<String>,
    /// Held from the first row on: until its end is written, a run that is stopped has results in memory.
    unsaved: Option<Unsaved>,
    /// The lock on the directory, held while the run is written.
    _held: Option<DirectoryLock>,
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
            reserve: Reserve::in_folder(&dir),
            _held: held,
            ..Self::in_folder(dir, info.id, case_text)
        })
    }

    /// The same for a run that may be a matter of milliseconds: nothing is on the disk until it has taken a second, and a run that ends before is
    /// there with all its files at once, or not at all.
    ///
    /// # Errors
    /// The directory holds files already, or a run cannot go there.
    pub fn begin_late(dir: &Path, mut info: RunInfo, case_text: &str) -> Result<Self, StoreError> {
        create::room_for(dir)?;
        info.id = create::name_of(dir);
        Ok(Self {
            late: Some(Late::new(info.clone(), case_text)),
            ..Self::in_folder(dir.to_owned(), info.id, case_text)
        })
    }

    /// A writer of which nothing is on the disk.
    fn in_folder(dir: PathBuf, id: String, case_text: &str) -> Self {
        Self {
            dir,
            id,
            late: None,
            lines: Vec::new(),
            streams: Vec::new(),
            flushed: Instant::now(),
            case: Digest::of_bytes(case_text.as_bytes()),
            case_due: None,
            reserve: Reserve::none(),
            full: None,
            unsaved: None,
            _held: None,
        }
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

    /// What the system said when the disk was full: what was held in reserve holds a checkpoint and the end of the run, and no more.
    #[must_use]
    pub fn full(&self) -> Option<&str> {
        self.full.as_deref()
    }

    /// Writes an event of a job; the end is for [`RunWriter::finish`].
    ///
    /// # Errors
    /// The system refuses, for example because the disk is full.
    pub fn event(&mut self, event: &JobEvent) -> Result<(), StoreError> {
        let waiting = self.streams.iter().map(|stream| stream.waiting().len());
        let waiting = waiting.sum();
        if let Some(late) = self.late.take_if(|late| late.is_due(waiting)) {
            self.appear(late)?;
        }
        match event {
            JobEvent::Started { channels, lines } => self.begin_record(channels, lines),
            JobEvent::Frame(frame) => self.frame(frame),
            JobEvent::Checkpoint(text) => self.checkpoint(text),
            JobEvent::Estimating => self.flush(),
            JobEvent::Case(text) => {
                self.case_due = Some(text.clone());
                Ok(())
            }
            JobEvent::Searching(_) | JobEvent::Finished(_) => Ok(()),
        }
    }

    /// Names the channels and the lines that the frames will fill.
    ///
    /// # Errors
    /// The system refuses.
    pub fn begin_record(
        &mut self,
        channels: &[ChannelId],
        lines: &[String],
    ) -> Result<(), StoreError> {
        self.lines = lines.to_vec();
        let units = complete::channel_units(channels)?;
        let header = history_header(channels.iter())?;
        let history = GrowingFile::with_head(self.dir.join(HISTORY), header)?;
        let shapes = GrowingFile::with_head(
            self.dir.join(SHAPES),
            CsvWriter::new(shapes_csv::columns(lines))?,
        )?;
        self.streams = vec![history, shapes];
        match &mut self.late {
            Some(late) => {
                late.units = Some(units);
                Ok(())
            }
            None => self.begin_streams(&units),
        }
    }

    fn begin_streams(&mut self, units: &[u8]) -> Result<(), StoreError> {
        self.with_room(|writer| create::replace(&writer.dir, CHANNELS, units))?;
        self.streams.iter_mut().try_for_each(GrowingFile::create)?;
        self.flush()
    }

    /// Brings to the disk what has waited for a run to end in a moment.
    fn appear(&mut self, mut late: Late) -> Result<(), StoreError> {
        let place = RunLocation::Exactly(self.dir.clone());
        let (_, held) = create::create(&place, &mut late.info, &late.case_text)?;
        self._held = held;
        self.reserve = Reserve::in_folder(&self.dir);
        if let Some(units) = late.units {
            self.begin_streams(&units)?;
        }
        late.checkpoint
            .map_or(Ok(()), |text| self.write_checkpoint(&text))
    }

    /// Adds an output instant.
    ///
    /// # Errors
    /// The system refuses.
    pub fn frame(&mut self, frame: &OutputFrame) -> Result<(), StoreError> {
        self.unsaved.get_or_insert_with(Unsaved::begin);
        if let [history, shapes] = &mut self.streams[..] {
            history.push(history_row(frame).as_bytes());
            let nodes = frame.shapes.iter().map(|shape| shape.nodes.len()).sum();
            if nodes > 0 {
                self.reserve.hold_checkpoint_of(nodes);
            }
            for shape in &frame.shapes {
                shapes.push(shape_rows(shape, &self.lines).as_bytes());
            }
        }
        if self.flushed.elapsed() >= FLUSH || self.streams.iter().any(GrowingFile::is_due) {
            self.flush()?;
        }
        Ok(())
    }

    /// Writes a checkpoint once everything recorded before is on disk.
    fn checkpoint(&mut self, text: &str) -> Result<(), StoreError> {
        self.flush()?;
        if let Some(case) = self.case_due.take() {
            self.case = Digest::of_bytes(case.as_bytes());
            match &mut self.late {
                Some(late) => late.case_text = case,
                None => {
                    self.with_room(|writer| create::replace(&writer.dir, CASE, case.as_bytes()))?;
                }
            }
        }
        let part = |file: usize| {
            let stream = self.streams.get(file);
            stream
                .map_or_else(Digest::default, GrowingFile::digest)
                .part()
        };
        let seal = Seal {
            case: self.case.part(),
            history: part(0),
            shapes: part(1),
        };
        let text = sealed(text, seal).map_err(|error| StoreError::Damaged {
            file: self.dir.join(CHECKPOINT),
            reason: error.to_string(),
        })?;
        match &mut self.late {
            Some(late) => {
                late.checkpoint = Some(text);
                Ok(())
            }
            None => self.write_checkpoint(&text),
        }
    }

    fn write_checkpoint(&mut self, text: &str) -> Result<(), StoreError> {
        self.with_room(|writer| create::replace(&writer.dir, CHECKPOINT, text.as_bytes()))?;
        self.reserve.hold(text.len());
        Ok(())
    }

    /// Writes everything received so far to disk.
    ///
    /// # Errors
    /// The system refuses.
    pub fn flush(&mut self) -> Result<(), StoreError> {
        self.flushed = Instant::now();
        self.with_room(|writer| writer.streams.iter_mut().try_for_each(GrowingFile::flush))
    }

    /// Writes the complete run, `run.toml` with its final state last. Returns the run directory.
    ///
    /// # Errors
    /// The system refuses; the directory then reads as a failed run, or still as a partial one, and is absent of a run that was a matter of
    /// milliseconds.
    pub fn finish(mut self, run: &Run) -> Result<PathBuf, StoreError> {
        if let Some(late) = self.late.take() {
            let dir = self.dir.clone();
            create::at_once(&dir, |new| late.fill(new, &self.id, run, &self.streams))?;
            return Ok(dir);
        }
        self.flush()?;
        self.streams.iter().try_for_each(GrowingFile::sync)?;
        let streamed = !self.streams.is_empty();
        let all = |writer: &mut Self| {
            let (dir, id) = (&writer.dir, &writer.id);
            let mut put = |name: &str, bytes: &[u8]| create::replace(dir, name, bytes);
            complete::all(dir, id, run, streamed, &mut put)
        };
        match self.with_room(all) {
            Ok(()) => Ok(self.dir),
            Err(error) => {
                self.give_up(&run.info, &error);
                Err(error)
            }
        }
    }

    /// Marks the run as failed, where it cannot be written as a whole: its record so far and its last checkpoint stay.
    pub fn give_up(mut self, info: &RunInfo, why: &StoreError) {
        let info = RunInfo {
            id: self.id.clone(),
            state: RunState::Failed,
            failure: Some(why.to_string()),
            ..info.clone()
        };
        self.reserve.release();
        // The error that matters is the one already in hand; without room the run stays marked as partial.
        let _ = complete::info(&self.dir, &info);
    }

    /// Does what writes; on a full disk again, with the room that was held in reserve.
    fn with_room<T>(
        &mut self,
        mut write: impl FnMut(&mut Self) -> Result<T, StoreError>,
    ) -> Result<T, StoreError> {
        match write(self) {
            Err(error) if error.is_full_disk() && self.reserve.release() => {
                self.full = Some(error.to_string());
                write(self)
            }
            done => done,
        }
    }
}

/// Writes a run that is already complete. Returns its directory.
///
/// # Errors
/// The directory holds files already, or the system refuses.
pub fn save(place: &RunLocation, run: &Run) -> Result<PathBuf, StoreError> {
    RunWriter::begin(place, run.info.clone(), &run.case_text)?.finish(run)
}
