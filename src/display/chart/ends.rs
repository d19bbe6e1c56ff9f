//! The legend at the right ends of the curves, where there is room: the eye needs no samples to find a curve.

use unicode_width::UnicodeWidthStr;

use super::canvas::ink;
use super::picture::{Picture, PicturePart, PlotFrame};
use super::{Chart, Series, marker};

/// Columns before a name: a blank, the marker, a blank.
const BEFORE: usize = 3;

/// The narrowest picture with names at its right.
const NARROWEST: usize = 40;

/// The names leave the plot two thirds of the picture.
const SHARE: usize = 3;

/// Columns that the names take to the right of the plot; none where there is no room for all, or their curves have no right ends.
pub(super) fn columns(chart: &Chart, width: usize, height: usize) -> usize {
    let fits = chart.ends && chart.legend && !chart.equal_scale && chart.map.is_none();
    let shown: Vec<&Series> = visible(chart).collect();
    let widest = shown.iter().map(|series| series.label.width()).max();
    let columns = widest.map_or(0, |widest| widest + BEFORE);
    let room = width >= NARROWEST && SHARE * columns <= width && 2 * shown.len() <= height;
    if fits && room { columns } else { 0 }
}

/// Writes each name beside the end of its curve, none over another.
pub(super) fn draw(chart: &Chart, frame: PlotFrame, on: &mut Picture) {
    let mut names: Vec<(usize, &Series)> = visible(chart)
        .map(|series| (row(series, &frame), series))
        .collect();
    names.sort_by_key(|(row, _)| *row);
    let mut least = 0;
    for (row, _) in &mut names {
        *row = least.max(*row);
        least = *row + 1;
    }
    // Those pushed over the lower edge move up again.
    let mut most = frame.height;
    for (row, _) in names.iter_mut().rev() {
        most = most.saturating_sub(1);
        *row = most.min(*row);
        most = *row;
    }
    let column = frame.left + frame.width + 1;
    for (row, series) in names {
        let row = frame.top + row;
        on.write(column, row, &marker(series.slot).to_string(), ink(series));
        on.write(column + 2, row, &series.label, PicturePart::Legend);
    }
}

/// How many curves are hidden, in words; the ends of the others do not say so.
pub(super) fn hidden(chart: &Chart) -> String {
    match chart.series.len() - visible(chart).count() {
        0 => String::new(),
        count => format!("{count} hidden"),
    }
}

fn visible(chart: &Chart) -> impl Iterator<Item = &Series> {
    chart.series.iter().filter(|series| series.visible)
}

/// The row of the last point of a curve within the plot's range of x, at an edge where it lies beyond.
fn row(series: &Series, frame: &PlotFrame) -> usize {
    let inside =
        |p: &&(f64, f64)| frame.x_scale.shows(p.0) && frame.y_scale.shows(p.1) && p.0 <= frame.x.1;
    let last = series.points.iter().rev().find(inside);
    let bottom = frame.height.saturating_sub(1);
    last.map_or(bottom, |(_, y)| match frame.row_of(*y) {
        Some(row) => row,
        None if *y > frame.y.1 => 0,
        None => bottom,
    })
}
