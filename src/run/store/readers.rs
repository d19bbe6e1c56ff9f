//! The record of a run, row by row: what it takes in memory does not grow with the run.

use std::path::Path;

use super::{
    HISTORY, SHAPES, StoreError,
    number::parse,
    shapes::{SHAPE_COLUMNS, numbers},
    table::Stream,
};
use crate::case::ChannelId;
use crate::run::LineShape;

/// The rows of `history.csv`.
#[derive(Debug)]
pub(in crate::run) struct Rows {
    table: Stream,
    /// The channels, and the column of each.
    ids: Vec<ChannelId>,
    columns: Vec<usize>,
    /// Columns that are no channel this version knows.
    unknown: Vec<String>,
    row: Vec<f64>,
}

impl Rows {
    /// Of the run in this directory. What is wrong with the file ends it early, see [`Rows::trouble`].
    pub(in crate::run) fn open(dir: &Path) -> Self {
        let mut table = Stream::open(dir, HISTORY);
        if table.columns().first().is_some_and(|c| c != "time_s") {
            table.give_up(format!(
                "{HISTORY} does not begin with the column time_s; it was left out."
            ));
        }
        let (mut ids, mut columns, mut unknown) = (Vec::new(), Vec::new(), Vec::new());
        for (column, name) in table.columns().iter().enumerate().skip(1) {
            match name.parse() {
                Ok(id) => {
                    ids.push(id);
                    columns.push(column);
                }
                Err(_) => unknown.push(name.clone()),
            }
        }
        Self {
            table,
            ids,
            columns,
            unknown,
            row: Vec::new(),
        }
    }

    /// The channels, in the order of the values of a row.
    pub(super) fn ids(&self) -> &[ChannelId] {
        &self.ids
    }

    /// The next row: its time \[s\] and a value a channel.
    pub(in crate::run) fn next(&mut self) -> Option<(f64, &[f64])> {
        let (line, fields) = self.table.next()?;
        self.row.clear();
        let columns = std::iter::once(&0).chain(&self.columns);
        let texts = columns.map_while(|column| fields.get(*column));
        self.row.extend(texts.map_while(parse));
        if self.row.len() <= self.columns.len() {
            self.table.give_up(not_a_number(HISTORY, line));
            return None;
        }
        let (time, values) = self.row.split_first()?;
        Some((*time, values))
    }

    /// What is wrong with the file, once it is read.
    pub(super) fn trouble(self) -> Option<String> {
        let unknown = (!self.unknown.is_empty()).then(|| {
            let names = self.unknown.join(", ");
            format!("{HISTORY} has columns that this version does not know, which were left out: {names}.")
        });
        self.table.trouble().or(unknown)
    }

    /// That the rows do not reach so far \[s\], and why.
    pub(in crate::run) fn short_of(self, dir: &Path, until: f64) -> StoreError {
        let why = self.trouble().unwrap_or_default();
        StoreError::Damaged {
            file: dir.join(HISTORY),
            reason: format!("it ends before {until} s, where the run is to go on. {why}"),
        }
    }
}

/// The shapes of `shapes.csv`.
#[derive(Debug)]
pub(in crate::run) struct Shapes {
    table: Stream,
    coming: Option<LineShape>,
    /// Nodes of the first shape, once it is read.
    full: usize,
}

impl Shapes {
    /// Of the run in this directory. What is wrong with the file ends it early, see [`Shapes::trouble`].
    pub(in crate::run) fn open(dir: &Path) -> Self {
        let mut table = Stream::open(dir, SHAPES);
        table.expect(&SHAPE_COLUMNS);
        Self {
            table,
            coming: None,
            full: 0,
        }
    }

    /// The next shape: a new one begins at node 0. A last shape with fewer nodes than the first is torn and left out.
    pub(in crate::run) fn next(&mut self) -> Option<LineShape> {
        while let Some((line, fields)) = self.table.next() {
            let Some([time, node, x, y, z, tension]) = numbers(fields.iter()) else {
                self.table.give_up(not_a_number(SHAPES, line));
                break;
            };
            let begun = (node < 0.5).then(|| LineShape {
                time,
                ..LineShape::default()
            });
            let whole = begun.and_then(|begun| self.coming.replace(begun));
            if let Some(shape) = &mut self.coming {
                shape.nodes.push([x, y, z]);
                shape.tension.push(tension);
            }
            if let Some(whole) = whole {
                self.full = self
                    .full
                    .max(usize::from(self.full == 0) * whole.nodes.len());
                return Some(whole);
            }
        }
        let last = self.coming.take()?;
        if last.nodes.len() < self.full {
            self.table.give_up(format!(
                "{SHAPES} ends in the middle of a shape; that shape was left out."
            ));
            return None;
        }
        Some(last)
    }

    /// What is wrong with the file, once it is read.
    pub(super) fn trouble(self) -> Option<String> {
        self.table.trouble()
    }
}

/// That a line holds something else than numbers.
pub(super) fn not_a_number(name: &str, line: u64) -> String {
    format!("{name}, line {line} holds something that is no number; read up to there.")
}
