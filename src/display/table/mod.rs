//! Tables as data, shown the same on screen, in reports and on the command line.
//!
//! A table is described by its columns with [`Table::of_records`], or by its rows with [`Table::compare`].

mod columns;
pub mod explanations;
mod export;
mod layout;

use std::borrow::Cow;

use crate::visible;

pub use columns::{Columns, ComparisonTable, NumberFormat};
pub use layout::{ColumnPlace, LineKind, StyledText, TableLayout, TableLine};

/// A table: columns, rows of cells, notes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// One line above; empty for none.
    pub title: String,
    /// The columns.
    pub columns: Vec<Column>,
    /// The rows; a row that is shorter than the columns ends in empty cells.
    pub rows: Vec<Vec<Cell>>,
    /// Sentences below the table.
    pub notes: Vec<String>,
}

/// A column: its heading and alignment.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Its heading; may be wrapped onto several lines.
    pub head: String,
    /// Alignment of its cells.
    pub align: Align,
}

impl Column {
    /// A left-aligned column of words.
    #[must_use]
    pub fn left(head: &str) -> Self {
        Self::new(head, Align::Left)
    }

    /// A right-aligned column.
    #[must_use]
    pub fn right(head: &str) -> Self {
        Self::new(head, Align::Right)
    }

    /// A column of numbers aligned at their decimal points.
    #[must_use]
    pub fn decimal(head: &str) -> Self {
        Self::new(head, Align::Decimal)
    }

    fn new(head: &str, align: Align) -> Self {
        Self {
            head: head.to_owned(),
            align,
        }
    }
}

/// Alignment of the cells of a column. Only [`Align::Left`] cells are ever wrapped.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Align {
    /// At the left: words.
    #[default]
    Left,
    /// At the right.
    Right,
    /// At the decimal point of their first number.
    Decimal,
}

/// A cell: its text and style.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Cell {
    /// The text.
    pub text: String,
    /// Its style; the text must convey the same.
    pub ink: CellStyle,
}

impl Cell {
    /// A cell of this style.
    #[must_use]
    pub fn new(text: impl Into<String>, ink: CellStyle) -> Self {
        Self {
            text: text.into(),
            ink,
        }
    }

    /// A cell of plain style.
    #[must_use]
    pub fn plain(text: impl Into<String>) -> Self {
        Self::new(text, CellStyle::Plain)
    }
}

/// Style of a cell; the screen chooses its colour by it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum CellStyle {
    /// As it is.
    #[default]
    Plain,
    /// As it should be.
    Good,
    /// Not as it should be.
    Bad,
    /// To be looked at.
    Warn,
    /// Of less weight.
    Dim,
}

impl Table {
    /// The cell at a place as it may be shown: empty where the row is short, one line, with its
    /// invisible characters escaped.
    #[must_use]
    pub fn cell(&self, row: usize, column: usize) -> Cell {
        let cell = self.rows.get(row).and_then(|row| row.get(column));
        let mut cell = cell.cloned().unwrap_or_default();
        if let Cow::Owned(text) = visible::line(&cell.text.replace('\n', " ")) {
            cell.text = text;
        }
        cell
    }

    /// The table as lines of text with no more than `width` columns, without trailing blanks, each
    /// ended by a newline. Only a single number or word longer than that makes a line longer.
    #[must_use]
    pub fn to_text(&self, width: usize) -> String {
        let mut text = String::new();
        for line in self.layout(width).lines {
            let words: String = line
                .pieces
                .iter()
                .map(|piece| piece.text.as_str())
                .collect();
            text.push_str(words.trim_end());
            text.push('\n');
        }
        text
    }
}
