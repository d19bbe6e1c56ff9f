//! The rows of an earlier run up to its checkpoint, read back from its directory. They must be of the same channels in the same order.

use std::path::Path;

use super::LineShape;
use super::recorder_state::RecorderState;
use super::store::{HistoryReader, ShapeReader, StoreError};
use crate::case::ChannelId;

/// Receives a row of the record: time \[s\], values of the channels, and the shapes at that time where there are any.
type RowReceiver<'a> = dyn FnMut(f64, &[f64], Vec<LineShape>) + 'a;

/// Reads the record of a run of these channels in a run directory, up to a checkpoint with this state.
///
/// # Errors
/// The record does not reach so far, or is of other channels.
pub(super) fn replay(
    dir: &Path,
    state: &RecorderState,
    channels: &[ChannelId],
    receive: &mut RowReceiver<'_>,
) -> Result<(), StoreError> {
    let mut rows = HistoryReader::of_channels(dir, channels)?;
    let mut shapes = ShapeReader::open(dir);
    let mut shape = shapes.next();
    for _ in 0..state.rows {
        let Some((time, values)) = rows.next() else {
            return Err(rows.short_of(dir, state.time().unwrap_or_default()));
        };
        let mut here = Vec::new();
        while let Some(due) = shape.take_if(|shape| shape.time <= time) {
            here.push(due);
            shape = shapes.next();
        }
        receive(time, values, here);
    }
    Ok(())
}
