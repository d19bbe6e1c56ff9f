//! `shapes.csv`: the shapes of the line one after the other, a row a node; written and read shape by shape.

use std::path::Path;

use super::{
    SHAPES,
    number::{ROOM, append, parse, text},
    table::{CsvReader, not_a_number},
};
use crate::run::LineShape;

/// Columns of `shapes.csv`.
pub(super) const SHAPE_COLUMNS: [&str; 6] = ["time_s", "node", "x_m", "y_m", "z_m", "tension_n"];

/// The whole file of shapes that are held in memory.
pub(super) fn write_shapes(shapes: &[LineShape]) -> String {
    let mut file = SHAPE_COLUMNS.join(",") + "\n";
    for shape in shapes {
        file += &shape_rows(shape);
    }
    file
}

/// The rows of a shape. Numbers need no quotes.
pub(super) fn shape_rows(shape: &LineShape) -> String {
    let time = text(shape.time);
    let mut rows = String::with_capacity(5 * ROOM * shape.nodes.len());
    for (node, (place, tension)) in shape.nodes.iter().zip(&shape.tension).enumerate() {
        rows += &time;
        rows.push(',');
        rows += &node.to_string();
        for value in place.iter().chain([tension]) {
            rows.push(',');
            append(&mut rows, *value);
        }
        rows.push('\n');
    }
    rows
}

/// The shapes of `shapes.csv`.
#[derive(Debug)]
pub(in crate::run) struct ShapeReader {
    csv: CsvReader,
    /// Where the columns are, in the order of [`SHAPE_COLUMNS`].
    columns: Vec<usize>,
    /// The shape being read.
    current: Option<LineShape>,
    /// Nodes of the first shape, once it is read.
    nodes: usize,
}

impl ShapeReader {
    /// Of the run in this directory. What is wrong with the file ends it early, see [`ShapeReader::problem`].
    pub(crate) fn open(dir: &Path) -> Self {
        let mut csv = CsvReader::open(dir, SHAPES);
        csv.note_unknown(|name| SHAPE_COLUMNS.contains(&name));
        Self {
            columns: csv.require(&SHAPE_COLUMNS),
            csv,
            current: None,
            nodes: 0,
        }
    }

    /// The next shape: a new one begins at node 0. A last shape with fewer nodes than the first is torn and left out.
    pub(in crate::run) fn next(&mut self) -> Option<LineShape> {
        while let Some((line, fields)) = self.csv.next() {
            let values = self.columns.iter().map(|at| parse(fields.get(*at)?));
            let values: Option<Vec<f64>> = values.collect();
            let Some(&[time, node, x, y, z, tension]) = values.as_deref() else {
                self.csv.give_up(not_a_number(SHAPES, line));
                break;
            };
            let begun = (node < 0.5).then(|| LineShape {
                time,
                ..LineShape::default()
            });
            let whole = begun.and_then(|begun| self.current.replace(begun));
            if let Some(shape) = &mut self.current {
                shape.nodes.push([x, y, z]);
                shape.tension.push(tension);
            }
            if let Some(whole) = whole {
                if self.nodes == 0 {
                    self.nodes = whole.nodes.len();
                }
                return Some(whole);
            }
        }
        let last = self.current.take()?;
        if last.nodes.len() < self.nodes {
            self.csv.give_up(format!(
                "{SHAPES} ends in the middle of a shape; that shape was left out."
            ));
            return None;
        }
        Some(last)
    }

    /// What is wrong with the file, once it is read.
    pub(super) fn problem(self) -> Option<String> {
        self.csv.problem()
    }
}
