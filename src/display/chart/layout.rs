//! Which rows and columns of a picture are for what; the smaller it is, the less is drawn around the
//! plot: first the name of the x axis goes, then the title, the legend, and the axes last.

use super::Chart;
use super::legend;

/// Rows of a picture, from the top.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct PictureRows {
    /// The title's row.
    pub(super) title: Option<usize>,
    /// First row of the y axis' name and the legend, and how many.
    pub(super) head: (usize, usize),
    /// First row of the plot.
    pub(super) top: usize,
    /// Rows of the plot.
    pub(super) height: usize,
    /// Row of the x axis; its numbers are in the row below.
    pub(super) axis: Option<usize>,
    /// Row of the name of the x axis.
    pub(super) name: Option<usize>,
}

impl PictureRows {
    /// Shares out the rows of a picture. `legend_rows` is how many the legend would like.
    pub(super) fn share(chart: &Chart, height: usize, legend_rows: usize) -> Self {
        let mut rows = Self::default();
        let axes = height >= 5;
        let named = height >= 10 && !chart.x.label.is_empty();
        let bottom = if axes { 2 } else { 0 } + usize::from(named);
        let mut top = 0;
        if height >= 8 && !chart.title.is_empty() {
            rows.title = Some(0);
            top = 1;
        }
        if height >= 6 {
            // The legend may take a row for every four of the picture.
            let wanted = legend_rows.max(usize::from(!chart.y.label.is_empty()));
            rows.head = (top, wanted.min((height / 4).max(1)));
            top += rows.head.1;
        }
        rows.top = top;
        rows.height = height.saturating_sub(top + bottom);
        rows.axis = axes.then_some(top + rows.height);
        rows.name = named.then_some(top + rows.height + 2);
        rows
    }
}

/// Columns to the left of the plot: room for the numbers, and the axis itself.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct PictureColumns {
    /// Columns of the numbers.
    pub(super) numbers: usize,
    /// Column of the axis.
    pub(super) axis: Option<usize>,
    /// First column of the plot.
    pub(super) left: usize,
    /// Columns of the plot.
    pub(super) width: usize,
}

impl PictureColumns {
    /// Shares out the columns, given how wide the numbers at the y axis are, and the names to the right of the plot.
    pub(super) fn share(width: usize, numbers: usize, right: usize) -> Self {
        let axes = width >= 5;
        // Numbers are shown whole or not at all, and leave the plot more than half.
        let numbers = if axes && 2 * (numbers + 1) <= width {
            numbers
        } else {
            0
        };
        let left = numbers + usize::from(axes);
        Self {
            numbers,
            axis: axes.then_some(numbers),
            left,
            width: (width - left).saturating_sub(right),
        }
    }
}

/// Rows the legend would like, for a picture of this width.
pub(super) fn legend_rows(chart: &Chart, width: usize, indent: usize) -> usize {
    if chart.legend {
        legend::flow(chart, width, indent, usize::MAX).rows()
    } else {
        0
    }
}
