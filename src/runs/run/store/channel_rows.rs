//! The rows of a stored history, of the channels asked for.

use std::path::Path;

use super::{HISTORY, StoreError, history_csv::HistoryReader};
use crate::case::ChannelId;

/// Channels of a history, all rows.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelRows {
    /// Times \[s\].
    pub time: Vec<f64>,
    /// The channels.
    pub ids: Vec<ChannelId>,
    /// Values at the times, a list a channel.
    pub values: Vec<Vec<f64>>,
}

/// Reads those channels of a stored history that are wanted, from a time on \[s\], row by row: memory holds them alone.
///
/// # Errors
/// A row that cannot be understood.
pub fn channel_rows(
    dir: &Path,
    from: f64,
    wanted: impl Fn(&ChannelId) -> bool,
) -> Result<ChannelRows, StoreError> {
    let mut reader = HistoryReader::open(dir);
    let columns: Vec<usize> = (0..reader.ids().len())
        .filter(|column| wanted(&reader.ids()[*column]))
        .collect();
    let mut rows = ChannelRows {
        time: Vec::new(),
        ids: columns
            .iter()
            .map(|column| reader.ids()[*column].clone())
            .collect(),
        values: vec![Vec::new(); columns.len()],
    };
    while let Some((time, values)) = reader.next() {
        if time < from {
            continue;
        }
        rows.time.push(time);
        for (list, column) in rows.values.iter_mut().zip(&columns) {
            list.push(values[*column]);
        }
    }
    match reader.problem() {
        None => Ok(rows),
        Some(reason) => Err(StoreError::Damaged {
            file: dir.join(HISTORY),
            reason,
        }),
    }
}
