//! Shapes of the line as rows of `shapes.csv`.

use super::{StoreError, number::text, table::CsvWriter};
use crate::run::LineShape;

/// Columns of `shapes.csv`.
pub(super) const SHAPE_COLUMNS: [&str; 6] = ["time_s", "node", "x_m", "y_m", "z_m", "tension_n"];

/// Adds a shape to a table.
pub(super) fn write_shape(csv: &mut CsvWriter, shape: &LineShape) -> Result<(), StoreError> {
    for (node, ([x, y, z], tension)) in shape.nodes.iter().zip(&shape.tension).enumerate() {
        let [time, x, y, z, tension] = [shape.time, *x, *y, *z, *tension].map(text);
        csv.row([time, node.to_string(), x, y, z, tension])?;
    }
    Ok(())
}
