//! A drawn chart: a grid of characters that say what they are.

use unicode_width::UnicodeWidthChar;

use super::{AxisRange, AxisScale};
use crate::visible;

/// What a character of a picture is part of; the screen chooses colours by it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum PicturePart {
    /// Nothing.
    #[default]
    Blank,
    /// Axis lines and ticks.
    Axis,
    /// Numbers and names at the axes.
    Label,
    /// The title.
    Title,
    /// A series, by its slot.
    Series(usize),
    /// An older result, by its slot.
    Dimmed(usize),
    /// A place of a map: from -2, far below zero, to 2, far above it.
    Shade(i8),
    /// The cursor line.
    Cursor,
    /// A reference line and its name.
    Limit,
    /// Names in the legend.
    Legend,
}

/// Fills the second cell of a character that is two cells wide; never printed.
pub const CONTINUATION: char = '\0';

/// One character of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PictureCell {
    /// The character, or [`CONTINUATION`].
    pub ch: char,
    /// What it is part of.
    pub ink: PicturePart,
}

/// Where the plot lies in its picture and what it shows, so that a cursor or a zoom can be mapped.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PlotFrame {
    /// First column of the plot, inside the axis.
    pub left: usize,
    /// First row of the plot.
    pub top: usize,
    /// Columns of the plot.
    pub width: usize,
    /// Rows of the plot.
    pub height: usize,
    /// Dots across and up in a cell.
    pub dots: (usize, usize),
    /// What the plot shows from left to right.
    pub x: AxisRange,
    /// What the plot shows from bottom to top.
    pub y: AxisRange,
    /// How x is spread.
    pub x_scale: AxisScale,
    /// How y is spread.
    pub y_scale: AxisScale,
}

impl PlotFrame {
    /// Dots across and up in the whole plot.
    #[must_use]
    pub fn dot_count(&self) -> (usize, usize) {
        (self.width * self.dots.0, self.height * self.dots.1)
    }

    /// The x at the middle of a plot column (0 at the axis).
    #[must_use]
    pub fn x_of_column(&self, column: usize) -> f64 {
        let (n, _) = self.dot_count();
        let dot = (column as f64 + 0.5) * self.dots.0 as f64 - 0.5;
        let (from, to) = self.x_scale.places(self.x);
        self.x_scale
            .value(from + (to - from) * dot / (n.max(2) - 1) as f64)
    }

    /// The plot column where an x is drawn; absent when it is out of sight.
    #[must_use]
    pub fn column_of(&self, x: f64) -> Option<usize> {
        let (n, _) = self.dot_count();
        cell_of(x, self.x, self.x_scale, n, self.dots.0)
    }

    /// The plot row, counted from the top, where a y is drawn; absent when it is out of sight.
    #[must_use]
    pub fn row_of(&self, y: f64) -> Option<usize> {
        let (_, n) = self.dot_count();
        Some(self.height - 1 - cell_of(y, self.y, self.y_scale, n, self.dots.1)?)
    }
}

/// The cell in which a value falls, out of `n` dots with `per` dots a cell.
fn cell_of(value: f64, range: AxisRange, scale: AxisScale, n: usize, per: usize) -> Option<usize> {
    let dot = dot_of(value, range, scale, n);
    let inside = n > 0 && dot.is_finite() && (-0.5..=n as f64 - 0.5).contains(&dot);
    inside.then(|| (dot.round().max(0.0) as usize).min(n - 1) / per)
}

/// Where a value falls on `n` dots: the range's ends are the middles of the first and the last dot.
fn dot_of(value: f64, range: AxisRange, scale: AxisScale, n: usize) -> f64 {
    DotAxis::new(range, scale, n).dot(value)
}

/// The dots of an axis, for many values.
pub(super) struct DotAxis {
    /// A function by its address: the compiler would compute logarithms for linear axes as well, and drop them.
    place: fn(f64) -> f64,
    from: f64,
    span: f64,
    gaps: f64,
}

impl DotAxis {
    /// An axis of `n` dots.
    pub(super) fn new(range: AxisRange, scale: AxisScale, n: usize) -> Self {
        let (from, to) = scale.places(range);
        Self {
            place: match scale {
                AxisScale::Linear => std::convert::identity,
                AxisScale::Log => f64::log10,
            },
            from,
            span: to - from,
            gaps: n.saturating_sub(1) as f64,
        }
    }

    /// Where a value falls, in dots.
    pub(super) fn dot(&self, value: f64) -> f64 {
        ((self.place)(value) - self.from) / self.span * self.gaps
    }
}

/// A chart drawn in characters.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Characters, row by row from the top.
    pub cells: Vec<PictureCell>,
    /// Where the plot lies and what it shows.
    pub frame: PlotFrame,
}

impl Picture {
    /// An empty picture.
    #[must_use]
    pub fn blank(width: usize, height: usize) -> Self {
        let empty = PictureCell {
            ch: ' ',
            ink: PicturePart::Blank,
        };
        Self {
            width,
            height,
            cells: vec![empty; width * height],
            frame: PlotFrame::default(),
        }
    }

    /// The character at a place; absent outside.
    #[must_use]
    pub fn get(&self, column: usize, row: usize) -> Option<PictureCell> {
        let inside = column < self.width && row < self.height;
        inside.then(|| self.cells[row * self.width + column])
    }

    /// The picture as lines of text, without trailing blanks, each ended by a newline.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        for row in self.cells.chunks(self.width.max(1)) {
            let line: String = row
                .iter()
                .map(|cell| cell.ch)
                .filter(|ch| *ch != CONTINUATION)
                .collect();
            text.push_str(line.trim_end());
            text.push('\n');
        }
        text
    }

    /// Puts one character; outside the picture nothing happens.
    pub(super) fn put(&mut self, column: usize, row: usize, ch: char, ink: PicturePart) {
        if column < self.width && row < self.height {
            self.cells[row * self.width + column] = PictureCell { ch, ink };
        }
    }

    /// Writes text from a column on, at most to the picture's edge; returns the column after it.
    pub fn write(&mut self, column: usize, row: usize, text: &str, ink: PicturePart) -> usize {
        let mut at = column;
        for ch in visible::line(text).chars() {
            let wide = ch.width().unwrap_or(0);
            if wide == 0 {
                continue;
            }
            if at + wide > self.width {
                break;
            }
            self.put(at, row, ch, ink);
            for second in 1..wide {
                self.put(at + second, row, CONTINUATION, ink);
            }
            at += wide;
        }
        at
    }
}
