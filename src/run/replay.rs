//! The rows of an earlier run up to its checkpoint, read back from its directory.

use super::store::{HistoryReader, ShapeReader, StoreError};
use super::{LineShape, ResumedRun};

/// Receives a row of the record: time \[s\], values of the channels, and the shape at that time where there is one.
type RowReceiver<'a> = dyn FnMut(f64, &[f64], Option<LineShape>) + 'a;

/// Reads the record of a run up to its checkpoint.
///
/// # Errors
/// The record does not reach so far.
pub(super) fn replay(from: &ResumedRun, receive: &mut RowReceiver<'_>) -> Result<(), StoreError> {
    let mut rows = HistoryReader::open(&from.dir);
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
