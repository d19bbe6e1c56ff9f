//! The record of a run, row by row: what it takes in memory does not grow with the run.

use std::path::Path;

use super::{
    HISTORY, SHAPES, StoreError,
    number::parse,
    shapes::SHAPE_COLUMNS,
    table::{CsvReader, not_a_number},
};
use crate::case::ChannelId;
use crate::run::LineShape;

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
    pub(in crate::run) fn open(dir: &Path) -> Self {
        let mut csv = CsvReader::open(dir, HISTORY);
        let mut columns = csv.require(&["time_s"]);
        let channel = |name: &str| name.parse::<ChannelId>();
        csv.note_unknown(|name| name == "time_s" || channel(name).is_ok());
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
    pub(in crate::run) fn open(dir: &Path) -> Self {
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
