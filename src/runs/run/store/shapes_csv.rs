//! `shapes.csv`: the shapes of the line one after the other, a row a node; written and read shape by shape.

use std::path::Path;

use super::{
    SHAPES,
    columns::LINE,
    number::{ROOM, append, parse, text},
    table::{CsvReader, not_a_number},
};
use crate::run::LineShape;

/// Columns of `shapes.csv`; that of the lines' names comes first where there are any.
pub(super) const SHAPE_COLUMNS: [&str; 6] = ["time_s", "node", "x_m", "y_m", "z_m", "tension_n"];

/// Those that a line has which bends, and one over a bed: empty of others.
const MORE: [&str; 2] = ["curvature_per_m", "height_m"];

/// The names of the columns for lines of these names.
pub(super) fn columns(lines: &[String]) -> impl Iterator<Item = &'static str> {
    let name = (!lines.is_empty()).then_some(LINE);
    name.into_iter().chain(SHAPE_COLUMNS).chain(MORE)
}

/// The whole file of shapes that are held in memory, of lines of these names.
pub(super) fn write_shapes(shapes: &[LineShape], lines: &[String]) -> String {
    let names: Vec<&str> = columns(lines).collect();
    let mut file = names.join(",") + "\n";
    for shape in shapes {
        file += &shape_rows(shape, lines);
    }
    file
}

/// The rows of a shape of one of these lines. Numbers need no quotes.
pub(super) fn shape_rows(shape: &LineShape, lines: &[String]) -> String {
    let name = lines.get(shape.line).map(|name| quoted(name) + ",");
    let time = name.unwrap_or_default() + &text(shape.time);
    let mut rows = String::with_capacity(7 * ROOM * shape.nodes.len());
    for (node, (place, tension)) in shape.nodes.iter().zip(&shape.tension).enumerate() {
        rows += &time;
        rows.push(',');
        rows += &node.to_string();
        for value in place.iter().chain([tension]) {
            rows.push(',');
            append(&mut rows, *value);
        }
        for list in [&shape.curvature, &shape.height] {
            rows.push(',');
            if let Some(value) = list.get(node) {
                append(&mut rows, *value);
            }
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
    /// Where those of [`MORE`] are.
    more: [Option<usize>; MORE.len()],
    /// Where the names of lines are, and those read so far.
    line: Option<usize>,
    names: Vec<String>,
    /// The shape being read.
    current: Option<LineShape>,
    /// Nodes of the first shape of each line, once it is read.
    nodes: Vec<usize>,
}

impl ShapeReader {
    /// Of the run in this directory. What is wrong with the file ends it early, see [`ShapeReader::problem`].
    pub(crate) fn open(dir: &Path) -> Self {
        let mut csv = CsvReader::open(dir, SHAPES);
        csv.note_unknown(|name| {
            name == LINE || SHAPE_COLUMNS.contains(&name) || MORE.contains(&name)
        });
        Self {
            columns: csv.require(&SHAPE_COLUMNS),
            more: MORE.map(|name| csv.position(name)),
            line: csv.position(LINE),
            names: Vec::new(),
            csv,
            current: None,
            nodes: Vec::new(),
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
            let begun = (node < 0.5).then(|| {
                let name = self.line.and_then(|at| fields.get(at)).unwrap_or_default();
                LineShape {
                    time,
                    line: number_of(&mut self.names, name),
                    ..LineShape::default()
                }
            });
            let whole = begun.and_then(|begun| self.current.replace(begun));
            if let Some(shape) = &mut self.current {
                shape.nodes.push([x, y, z]);
                shape.tension.push(tension);
                let lists = [&mut shape.curvature, &mut shape.height];
                for (list, at) in lists.into_iter().zip(self.more) {
                    list.extend(at.and_then(|at| parse(fields.get(at)?)));
                }
            }
            if let Some(whole) = whole {
                if whole.line == self.nodes.len() {
                    self.nodes.push(whole.nodes.len());
                }
                return Some(whole);
            }
        }
        let last = self.current.take()?;
        // Lines that are paid out have more nodes at one time and fewer at another.
        let whole = self.nodes.get(last.line).copied().unwrap_or_default();
        if last.nodes.len() < whole {
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

/// The number of a line by its name, in the order in which names come.
fn number_of(names: &mut Vec<String>, name: &str) -> usize {
    let known = names.iter().position(|known| known == name);
    known.unwrap_or_else(|| {
        names.push(name.to_owned());
        names.len() - 1
    })
}

/// A name as a field.
fn quoted(name: &str) -> String {
    match name.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", name.replace('"', "\"\"")),
        false => name.to_owned(),
    }
}
