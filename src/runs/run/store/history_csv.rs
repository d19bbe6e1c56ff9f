//! `history.csv`: the time and a column a channel, a row an output time; written and read row by row, so that what a run
//! takes in memory does not grow with its length.

use std::path::Path;

use super::{
    HISTORY, StoreError,
    number::{ROOM, append, parse, text, text_or_empty},
    table::{CsvReader, CsvWriter, not_a_number},
};
use crate::case::ChannelId;
use crate::run::{History, OutputFrame};

/// The first column.
const TIME: &str = "time_s";

/// The line of column names, for these channels.
pub(super) fn history_header<'a>(
    channels: impl Iterator<Item = &'a ChannelId>,
) -> Result<CsvWriter, StoreError> {
    CsvWriter::new(std::iter::once(TIME.to_owned()).chain(channels.map(ToString::to_string)))
}

/// The row of an output time. Numbers need no quotes.
pub(super) fn history_row(frame: &OutputFrame) -> String {
    let mut row = String::with_capacity(ROOM * (1 + frame.values.len()));
    append(&mut row, frame.time);
    for value in &frame.values {
        row.push(',');
        append(&mut row, *value);
    }
    row.push('\n');
    row
}

/// The whole file of a history that is held in memory.
///
/// # Errors
/// [`StoreError`] where a name cannot be written.
pub fn write_history(history: &History) -> Result<Vec<u8>, StoreError> {
    let mut csv = history_header(history.channels.iter().map(|channel| &channel.id))?;
    for (i, time) in history.time.iter().enumerate() {
        let channels = history.channels.iter();
        let values = channels.map(|channel| text_or_empty(channel.values.get(i).copied()));
        csv.row(std::iter::once(text(*time)).chain(values))?;
    }
    csv.bytes()
}

/// The rows of `history.csv`.
#[derive(Debug)]
pub(in crate::run) struct HistoryReader {
    csv: CsvReader,
    ids: Vec<ChannelId>,
    /// Columns of the time and of the channels.
    columns: Vec<usize>,
    row: Vec<f64>,
}

impl HistoryReader {
    /// Of the run in this directory. What is wrong with the file ends it early, see [`HistoryReader::problem`].
    pub(crate) fn open(dir: &Path) -> Self {
        let mut csv = CsvReader::open(dir, HISTORY);
        let mut columns = csv.require(&[TIME]);
        let channel = |name: &str| name.parse::<ChannelId>();
        csv.note_unknown(|name| name == TIME || channel(name).is_ok());
        let mut ids = Vec::new();
        for (column, name) in csv.columns().iter().enumerate() {
            if let Ok(id) = channel(name) {
                ids.push(id);
                columns.push(column);
            }
        }
        Self {
            csv,
            ids,
            columns,
            row: Vec::new(),
        }
    }

    /// The same, which must be of these channels in this order.
    pub(in crate::run) fn of_channels(
        dir: &Path,
        channels: &[ChannelId],
    ) -> Result<Self, StoreError> {
        let reader = Self::open(dir);
        // What cannot be read at all is told when a row is asked for.
        if reader.ids == channels || reader.csv.columns().is_empty() {
            return Ok(reader);
        }
        let found = reader.ids.len();
        let differs = reader.ids.iter().zip(channels).position(|(a, b)| a != b);
        let reason = match (differs, channels.get(found), reader.ids.get(channels.len())) {
            (Some(at), ..) => {
                let [there, here] = [&reader.ids[at], &channels[at]];
                format!("it has the column `{there}` where this case has `{here}`")
            }
            (None, Some(missing), _) => format!("it lacks the column `{missing}` of this case"),
            (None, None, more) => {
                let more = more.map(ToString::to_string).unwrap_or_default();
                format!("it has the column `{more}`, which this case has not")
            }
        };
        Err(StoreError::Damaged {
            file: dir.join(HISTORY),
            reason,
        })
    }

    /// The channels, in the order of the values of a row.
    pub(super) fn ids(&self) -> &[ChannelId] {
        &self.ids
    }

    /// The next row: its time \[s\] and a value a channel.
    pub(in crate::run) fn next(&mut self) -> Option<(f64, &[f64])> {
        let (line, fields) = self.csv.next()?;
        self.row.clear();
        let texts = self.columns.iter().map_while(|column| fields.get(*column));
        self.row.extend(texts.map_while(parse));
        if self.row.len() < self.columns.len() {
            self.csv.give_up(not_a_number(HISTORY, line));
            return None;
        }
        let (time, values) = self.row.split_first()?;
        Some((*time, values))
    }

    /// What is wrong with the file, once it is read.
    pub(super) fn problem(self) -> Option<String> {
        self.csv.problem()
    }

    /// That the rows do not reach so far \[s\], and why.
    pub(in crate::run) fn short_of(self, dir: &Path, until: f64) -> StoreError {
        let why = self.problem().unwrap_or_default();
        StoreError::Damaged {
            file: dir.join(HISTORY),
            reason: format!("it ends before {until} s, from where the run is to be resumed. {why}"),
        }
    }
}
