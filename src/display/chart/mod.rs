//! Charts as data (axes, series, marks, cursor) and their drawing in characters.
//!
//! A [`Chart`] says what is shown; [`draw()`] turns it into a [`Picture`], a grid of characters each
//! with an [`PicturePart`] that says what it is. Screen and report draw the same chart; only the screen
//! turns inks into colours, and nothing is shown by colour alone: every series has a marker of its
//! own, shown in the legend and along its line.
//!
//! [`svg::svg`] draws the same chart as a picture of lines and words, for pages that are printed.
//!
//! ```
//! use seacable_display::chart::{Axis, Chart, Glyphs, Series, draw};
//!
//! let chart = Chart {
//!     title: "A ramp".into(),
//!     x: Axis::new("time", "s"),
//!     y: Axis::new("tension", "N"),
//!     series: vec![Series::new("top", 0, vec![(0.0, 0.0), (600.0, 2.0e6)])],
//!     ..Chart::default()
//! };
//! let text = draw(&chart, 60, 12, Glyphs::Ascii).to_text();
//! assert!(text.contains("tension [MN]"));
//! ```

mod canvas;
mod clip;
mod decimate;
mod draw;
mod ends;
mod layout;
mod legend;
mod map;
mod marks;
mod picture;
mod range;
mod readout;
mod scale;
pub mod statistics;
pub mod svg;
mod ticks;

pub use draw::{draw, frame};
pub use map::GridMap;
pub use picture::{CONTINUATION, Picture, PictureCell, PicturePart, PlotFrame};
pub use range::{AxisRange, StickyRange, extent, fit};
pub use readout::{Readout, ReadoutMethod, readout};
pub use scale::{AxisScale, log_range};

/// Everything a chart shows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Chart {
    /// One line above the plot; empty for none.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The lines, drawn in this order: later ones lie on top, dimmed ones always below.
    pub series: Vec<Series>,
    /// Reference lines.
    pub limits: Vec<ReferenceLine>,
    /// A field over both axes, below everything else.
    pub map: Option<GridMap>,
    /// Position of the cursor on the x axis.
    pub cursor: Option<f64>,
    /// Its position on the y axis, on a chart with a map.
    pub cursor_y: Option<f64>,
    /// One metre is as long upwards as sideways; ranges are widened for it, never narrowed.
    pub equal_scale: bool,
    /// Whether the series are named above the plot.
    pub legend: bool,
    /// Whether they are named at their right ends instead, where there is room.
    pub ends: bool,
}

impl Chart {
    /// A chart of series with a legend.
    #[must_use]
    pub fn new(title: impl Into<String>, x: Axis, y: Axis, series: Vec<Series>) -> Self {
        Self {
            title: title.into(),
            x,
            y,
            series,
            legend: true,
            ..Self::default()
        }
    }

    /// Whether there is nothing on it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let empty = |map: &GridMap| map.values.is_empty();
        self.series.iter().all(|s| s.points.is_empty()) && self.map.as_ref().is_none_or(empty)
    }
}

/// An axis: what it measures, and how much of it is shown.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Axis {
    /// What is measured.
    pub label: String,
    /// Its unit; values are in this unit, the labels may show it with a prefix (`MN`).
    pub unit: String,
    /// What is shown, from where to where; absent: all the data, widened to round numbers.
    pub range: Option<AxisRange>,
    /// How values are spread over it; linear all the same where none is positive, and to equal scale.
    pub scale: AxisScale,
}

impl Axis {
    /// An axis that shows all its data.
    #[must_use]
    pub fn new(label: &str, unit: &str) -> Self {
        Self {
            label: label.to_owned(),
            unit: unit.to_owned(),
            ..Self::default()
        }
    }

    /// The same, showing this range; all its data where there is none.
    #[must_use]
    pub fn over(self, range: impl Into<Option<AxisRange>>) -> Self {
        Self {
            range: range.into(),
            ..self
        }
    }
}

/// Points of outlines; one that is not finite separates two.
pub type Outline = Vec<(f64, f64)>;

/// A line through points. A point that is not finite breaks the line.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name, for the legend and the readout.
    pub label: String,
    /// The points, in the order in which the line passes them.
    pub points: Vec<(f64, f64)>,
    /// Which marker and colour; series that mean the same in several charts share one.
    pub slot: usize,
    /// Drawn broken and below the others: an older result.
    pub dimmed: bool,
    /// Whether it is drawn; hidden series stay in the legend, without a marker.
    pub visible: bool,
}

impl Series {
    /// A visible series in full ink.
    #[must_use]
    pub fn new(label: &str, slot: usize, points: Vec<(f64, f64)>) -> Self {
        Self {
            label: label.to_owned(),
            points,
            slot,
            dimmed: false,
            visible: true,
        }
    }
}

/// A reference line across the plot.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceLine {
    /// What it means, written beside it.
    pub label: String,
    /// Where it lies.
    pub line: LimitLine,
}

impl ReferenceLine {
    /// A line of this name.
    #[must_use]
    pub fn new(label: impl Into<String>, line: LimitLine) -> Self {
        let label = label.into();
        Self { label, line }
    }
}

/// Where a reference line lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LimitLine {
    /// Across the plot at this y.
    Horizontal(f64),
    /// From bottom to top at this x.
    Vertical(f64),
    /// Across the plot at this y; where it lies beyond the plot, its name is at the edge nearest to it.
    Bound(f64),
    /// An area from one x to another, and from one y to another.
    Band {
        /// From where to where along x.
        x: (f64, f64),
        /// From where to where along y.
        y: (f64, f64),
    },
}

/// The characters a chart is drawn with.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Glyphs {
    /// Unicode braille, 2x4 dots a cell, and box-drawing axes.
    #[default]
    Braille,
    /// Nothing but ASCII: every cell of a line is the marker of its series.
    Ascii,
}

impl Glyphs {
    /// Dots across and up in a cell.
    #[must_use]
    pub fn dots(self) -> (usize, usize) {
        match self {
            Self::Braille => (2, 4),
            Self::Ascii => (1, 1),
        }
    }
}

/// Markers in the order of slots; they repeat after the last.
const MARKERS: [char; 16] = [
    'o', 'x', '#', '*', '@', '%', '&', '$', 'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h',
];

/// The character of the series of a slot, in both glyph sets.
#[must_use]
pub fn marker(slot: usize) -> char {
    MARKERS[slot % MARKERS.len()]
}
