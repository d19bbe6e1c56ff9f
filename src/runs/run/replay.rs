//! The rows of an earlier run up to its checkpoint, read back from its directory. They must be of the same channels in the same order.

use std::path::Path;

use super::store::{HistoryReader, ShapeReader, StoreError};
use super::{LineShape, ResumedRun};
use crate::case::ChannelId;

/// Receives a row of the record: time \[s\], values of the channels, and the shape at that time where there is one.
type RowReceiver<'a> = dyn FnMut(f64, &[f64], Option<LineShape>) + 'a;

/// Reads the first rows of the history of these channels in a run directory, which reach to a time \[s\].
///
/// # Errors
/// There are fewer, or they are of other channels.
pub fn replay_rows(
    dir: &Path,
    channels: &[ChannelId],
    (count, until): (u64, f64),
    receive: &mut dyn FnMut(f64, &[f64]),
) -> Result<(), StoreError> {
    let mut rows = HistoryReader::of(dir, channels)?;
    for _ in 0..count {
        let Some((time, values)) = rows.next() else {
            return Err(rows.short_of(dir, until));
        };
        receive(time, values);
    }
    Ok(())
}

/// Reads the record of a run of these channels up to its checkpoint.
///
/// # Errors
/// The record does not reach so far, or is of other channels.
pub(super) fn replay(
    from: &ResumedRun,
    channels: &[ChannelId],
    receive: &mut RowReceiver<'_>,
) -> Result<(), StoreError> {
    let mut rows = HistoryReader::of(&from.dir, channels)?;
    let mut shapes = ShapeReader::open(&from.dir);
    let mut shape = shapes.next();
    let mut replayed = 0;
    while replayed < from.checkpoint.rows {
        let Some((time, values)) = rows.next() else {
            return Err(rows.short_of(&from.dir, from.checkpoint.time()));
        };
        let here = shape.take_if(|shape| shape.time <= time);
        receive(time, values, here);
        replayed += 1;
        if shape.is_none() {
            shape = shapes.next();
        }
    }
    Ok(())
}
