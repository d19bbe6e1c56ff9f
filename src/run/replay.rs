//! The rows of an earlier run up to its checkpoint, read back from its directory.

use super::store::{HistoryReader, ShapeReader, StoreError};
use super::{LineShape, Resume};

/// Receives a row of the record: time \[s\], values of the channels, and the shape at that time where there is one.
type RowReceiver<'a> = dyn FnMut(f64, &[f64], Option<LineShape>) + 'a;

/// Reads the record of a run up to its checkpoint.
///
/// # Errors
/// The record does not reach so far.
pub(super) fn replay(from: &Resume, receive: &mut RowReceiver<'_>) -> Result<(), StoreError> {
    let slop = 1e-9 * from.checkpoint.whole_step_s;
    let until = from.checkpoint.place.time + slop;
    let mut rows = HistoryReader::open(&from.dir);
    let mut shapes = ShapeReader::open(&from.dir);
    let mut shape = shapes.next();
    let mut reached = f64::NEG_INFINITY;
    while let Some((time, values)) = rows.next() {
        if time > until {
            break;
        }
        let here = shape.take_if(|shape| shape.time <= time);
        receive(time, values, here);
        reached = time;
        if shape.is_none() {
            shape = shapes.next();
        }
    }
    if reached < until - 2.0 * slop {
        return Err(rows.short_of(&from.dir, until));
    }
    Ok(())
}
