//! From a chart to a picture: ranges, room, axes, lines, then what lies over them.

use std::borrow::Cow;

use unicode_width::UnicodeWidthStr;

use super::canvas::{DotCanvas, DotPath};
use super::ends;
use super::layout::{self, PictureColumns, PictureRows};
use super::legend;
use super::marks;
use super::picture::{Picture, PicturePart, PlotFrame};
use super::range::{AxisRange, equalise, extent, fit, fit_above_noise, sane};
use super::scale::{AxisScale, log_range};
use super::ticks::{self, Tick};
use super::{Axis, Chart, Glyphs, GridMap, LimitLine, Series};
use crate::plain;

/// Draws a chart into so many columns and rows. Any size will do: what has no room is left out
/// whole, nothing is cut, and nothing overlaps.
#[must_use]
pub fn draw(chart: &Chart, width: usize, height: usize, glyphs: Glyphs) -> Picture {
    let chart = &*in_glyphs(chart, glyphs);
    let mut picture = Picture::blank(width, height);
    if width == 0 || height == 0 {
        return picture;
    }
    let plan = ChartPlan::make(chart, width, height, glyphs);
    picture.frame = plan.frame;
    draw_head(chart, &plan, glyphs, &mut picture);
    draw_axes(chart, &plan, glyphs, &mut picture);
    draw_plot(chart, &plan, glyphs, &mut picture);
    picture
}

/// Where the plot of a chart would lie and what it would show, without drawing it: what a cursor, a
/// zoom or a pan has to know.
#[must_use]
pub fn frame(chart: &Chart, width: usize, height: usize, glyphs: Glyphs) -> PlotFrame {
    if width == 0 || height == 0 {
        return PlotFrame::default();
    }
    ChartPlan::make(&in_glyphs(chart, glyphs), width, height, glyphs).frame
}

/// The chart with all its words in ASCII, when that is what is wanted.
fn in_glyphs(chart: &Chart, glyphs: Glyphs) -> Cow<'_, Chart> {
    if glyphs == Glyphs::Braille {
        return Cow::Borrowed(chart);
    }
    let mut plain = chart.clone();
    let words = [&mut plain.title, &mut plain.x.label, &mut plain.x.unit];
    let words = words
        .into_iter()
        .chain([&mut plain.y.label, &mut plain.y.unit]);
    let words = words.chain(plain.series.iter_mut().map(|series| &mut series.label));
    for word in words.chain(plain.limits.iter_mut().map(|limit| &mut limit.label)) {
        if let Cow::Owned(ascii) = plain::ascii(word) {
            *word = ascii;
        }
    }
    Cow::Owned(plain)
}

/// What goes where.
struct ChartPlan {
    rows: PictureRows,
    columns: PictureColumns,
    frame: PlotFrame,
    /// Ticks of the y axis; empty when there is no room for their numbers.
    up: Vec<Tick>,
    /// Name and unit of the y axis, as short as needed.
    name: String,
    /// The series are named at their ends.
    ends: bool,
}

impl ChartPlan {
    /// Room for the numbers at the y axis depends on the range, which at equal scale depends on the
    /// room; so the room grows until the numbers fit, which takes two or three turns.
    fn make(chart: &Chart, width: usize, height: usize, glyphs: Glyphs) -> Self {
        let mut numbers = 0;
        let mut plan = Self::with_numbers(chart, width, height, glyphs, numbers);
        for _ in 0..4 {
            let needed = widest(&plan.up);
            if needed <= numbers {
                break;
            }
            numbers = needed;
            plan = Self::with_numbers(chart, width, height, glyphs, numbers);
        }
        if widest(&plan.up) > plan.columns.numbers {
            plan.up.iter_mut().for_each(|tick| tick.label.clear());
        }
        plan
    }

    fn with_numbers(
        chart: &Chart,
        width: usize,
        height: usize,
        glyphs: Glyphs,
        numbers: usize,
    ) -> Self {
        let ends = ends::columns(chart, width, height);
        let columns = PictureColumns::share(width, numbers, ends);
        let ((x, x_scale), (y, y_scale)) = ranges(chart);
        let unit = ticks::scale(y, &chart.y.unit).unit(&chart.y.unit);
        let name = axis_name(&chart.y.label, &unit, y_scale, width);
        let indent = head_indent(&name);
        let legend = match ends {
            0 => layout::legend_rows(chart, width, indent),
            _ => 0,
        };
        let rows = PictureRows::share(chart, height, legend);
        let dots = glyphs.dots();
        let mut frame = PlotFrame {
            left: columns.left,
            top: rows.top,
            width: columns.width,
            height: rows.height,
            dots,
            x,
            y,
            x_scale,
            y_scale,
        };
        if chart.equal_scale {
            (frame.x, frame.y) = equalise(x, y, paper(&frame));
        }
        let up = ticks::along(y_scale, frame.y, &chart.y.unit, frame.height, |ticks| {
            roomy_up(ticks, &frame)
        });
        // At equal scale the range may have grown into another prefix.
        let unit = ticks::scale(frame.y, &chart.y.unit).unit(&chart.y.unit);
        Self {
            name: axis_name(&chart.y.label, &unit, y_scale, width),
            rows,
            columns,
            frame,
            up,
            ends: ends > 0,
        }
    }
}

/// Length of both axes on paper, in widths of a cell; a cell is twice as tall as it is wide.
fn paper(frame: &PlotFrame) -> (f64, f64) {
    let (nx, ny) = frame.dot_count();
    let dot = (1.0 / frame.dots.0 as f64, 2.0 / frame.dots.1 as f64);
    let gaps = |n: usize| n.saturating_sub(1).max(1) as f64;
    (gaps(nx) * dot.0, gaps(ny) * dot.1)
}

/// What an axis shows, and how.
pub(super) type AxisDisplay = (AxisRange, AxisScale);

/// What both axes show: as asked for, or all visible data.
pub(super) fn ranges(chart: &Chart) -> (AxisDisplay, AxisDisplay) {
    let shown = || chart.series.iter().filter(|series| series.visible);
    let grid = |of: fn(&GridMap) -> &[f64]| chart.map.iter().flat_map(of).copied();
    let xs = shown().flat_map(|s| s.points.iter().map(|p| p.0));
    let xs = xs.chain(grid(|map| &map.x));
    let x = log(chart, &chart.x, xs.clone()).unwrap_or_else(|| {
        let range = chart.x.range;
        let range = range.map_or_else(|| fit(extent(xs)), sane);
        (range, AxisScale::Linear)
    });
    // A zoomed x axis does not change the y axis: the eye compares heights.
    let ys = shown().flat_map(|s| s.points.iter().map(|p| p.1));
    let bands = chart.limits.iter().flat_map(|limit| match limit.line {
        LimitLine::Band { y, .. } => vec![y.0, y.1],
        _ => Vec::new(),
    });
    let ys = ys.chain(bands).chain(grid(|map| &map.y));
    let y = log(chart, &chart.y, ys.clone()).unwrap_or_else(|| {
        let range = chart.y.range;
        let range = range.map_or_else(|| fit_above_noise(extent(ys), &chart.y.unit), sane);
        (range, AxisScale::Linear)
    });
    (x, y)
}

/// What a logarithmic axis shows; nothing where the axis is linear.
fn log(chart: &Chart, axis: &Axis, values: impl Iterator<Item = f64>) -> Option<AxisDisplay> {
    let wanted = axis.scale == AxisScale::Log && !chart.equal_scale;
    let range = wanted.then(|| log_range(axis.range, values)).flatten()?;
    Some((range, AxisScale::Log))
}

/// Name and unit of an axis if there is room, else the unit alone, else nothing.
pub(super) fn axis_name(label: &str, unit: &str, scale: AxisScale, room: usize) -> String {
    let unit = if unit.is_empty() {
        String::new()
    } else {
        format!("[{unit}]")
    };
    let log = if scale == AxisScale::Log { ", log" } else { "" };
    let whole = format!("{label}{log} {unit}").trim().to_owned();
    [whole, unit]
        .into_iter()
        .find(|text| text.width() <= room)
        .unwrap_or_default()
}

/// Column at which the legend begins beside the name of the y axis.
fn head_indent(name: &str) -> usize {
    if name.is_empty() { 0 } else { name.width() + 3 }
}

fn widest(ticks: &[Tick]) -> usize {
    ticks
        .iter()
        .map(|tick| tick.label.width())
        .max()
        .unwrap_or(0)
}

/// Numbers at the y axis need a free row between them, two in tall plots, none in tiny ones.
fn roomy_up(ticks: &[Tick], frame: &PlotFrame) -> bool {
    let apart = match frame.height {
        0..5 => 1,
        5..10 => 2,
        _ => 3,
    };
    let rows: Vec<usize> = ticks.iter().filter_map(|t| frame.row_of(t.value)).collect();
    rows.windows(2).all(|pair| pair[0] >= pair[1] + apart)
}

/// Where the numbers of the x axis begin: centred below their ticks, moved inside the picture.
fn places_along(ticks: &[Tick], frame: &PlotFrame, width: usize) -> Vec<(usize, usize)> {
    let place = |tick: &Tick| {
        let wide = tick.label.width();
        let middle = frame.left + frame.column_of(tick.value)?;
        Some((
            middle
                .saturating_sub(wide / 2)
                .min(width.saturating_sub(wide)),
            wide,
        ))
    };
    ticks.iter().filter_map(place).collect()
}

fn roomy_along(ticks: &[Tick], frame: &PlotFrame, width: usize) -> bool {
    let places = places_along(ticks, frame, width);
    let apart = places
        .windows(2)
        .all(|pair| pair[0].0 + pair[0].1 + 2 <= pair[1].0);
    apart && places.iter().all(|(_, wide)| *wide <= width)
}

/// Title, name of the y axis, legend.
fn draw_head(chart: &Chart, plan: &ChartPlan, glyphs: Glyphs, on: &mut Picture) {
    let width = on.width;
    if let Some(row) = plan.rows.title {
        let title = shorten(&chart.title, width, glyphs);
        on.write((width - title.width()) / 2, row, &title, PicturePart::Title);
    }
    let (top, rows) = plan.rows.head;
    if rows == 0 {
        return;
    }
    on.write(0, top, &plan.name, PicturePart::Label);
    if let Some(map) = &chart.map {
        map.scale(head_indent(&plan.name), top, glyphs, on);
    } else if plan.ends {
        let hidden = ends::hidden(chart);
        on.write(head_indent(&plan.name), top, &hidden, PicturePart::Legend);
    } else if chart.legend {
        let flow = legend::flow(chart, width, head_indent(&plan.name), rows);
        legend::draw(chart, &flow, top, glyphs, on);
    }
}

/// The text if it fits, else its beginning with dots that say that more follows.
fn shorten(text: &str, room: usize, glyphs: Glyphs) -> String {
    if text.width() <= room {
        return text.to_owned();
    }
    let dots = if glyphs == Glyphs::Ascii {
        "..."
    } else {
        "…"
    };
    let mut short = text.to_owned();
    while !short.is_empty() && short.width() + dots.width() > room {
        short.pop();
    }
    if short.is_empty() {
        short
    } else {
        format!("{}{dots}", short.trim_end())
    }
}

/// Both axes with ticks and numbers, and the name of the x axis.
fn draw_axes(chart: &Chart, plan: &ChartPlan, glyphs: Glyphs, on: &mut Picture) {
    let [vertical, horizontal, corner, tick_up, tick_along] = match glyphs {
        Glyphs::Ascii => ['|', '-', '+', '+', '+'],
        Glyphs::Braille => ['│', '─', '└', '┤', '┬'],
    };
    let frame = plan.frame;
    if let Some(column) = plan.columns.axis {
        for row in 0..frame.height {
            on.put(column, frame.top + row, vertical, PicturePart::Axis);
        }
        for tick in &plan.up {
            if let Some(row) = frame.row_of(tick.value) {
                on.put(column, frame.top + row, tick_up, PicturePart::Axis);
                let start = plan.columns.numbers.saturating_sub(tick.label.width());
                on.write(start, frame.top + row, &tick.label, PicturePart::Label);
            }
        }
    }
    let Some(row) = plan.rows.axis else { return };
    if let Some(column) = plan.columns.axis {
        on.put(column, row, corner, PicturePart::Axis);
    }
    for column in frame.left..frame.left + frame.width {
        on.put(column, row, horizontal, PicturePart::Axis);
    }
    let width = on.width;
    let along = ticks::along(frame.x_scale, frame.x, &chart.x.unit, width, |t| {
        roomy_along(t, &frame, width)
    });
    for (tick, (start, _)) in along.iter().zip(places_along(&along, &frame, width)) {
        if let Some(column) = frame.column_of(tick.value) {
            on.put(frame.left + column, row, tick_along, PicturePart::Axis);
        }
        on.write(start, row + 1, &tick.label, PicturePart::Label);
    }
    if let Some(row) = plan.rows.name {
        let unit = ticks::scale(frame.x, &chart.x.unit).unit(&chart.x.unit);
        let name = axis_name(&chart.x.label, &unit, frame.x_scale, frame.width);
        let start = frame.left + (frame.width - name.width()) / 2;
        on.write(start, row, &name, PicturePart::Label);
    }
}

/// Everything inside the axes: reference lines below, series, markers, then cursor and names where
/// cells are free.
fn draw_plot(chart: &Chart, plan: &ChartPlan, glyphs: Glyphs, on: &mut Picture) {
    let frame = plan.frame;
    let canvas = draw_series(chart, frame, glyphs);
    if let Some(map) = &chart.map {
        map.draw(frame, glyphs, on);
    }
    marks::limits(chart, frame, glyphs, on);
    marks::cursor(chart, frame, plan.rows.axis, glyphs, on);
    for row in 0..frame.height {
        for column in 0..frame.width {
            if let Some((ch, ink)) = canvas.get(column, row) {
                on.put(frame.left + column, frame.top + row, ch, ink);
            }
        }
    }
    marks::names(chart, frame, glyphs, on);
    if plan.ends {
        ends::draw(chart, frame, on);
    }
}

/// Dimmed series first, so that they lie below; markers last.
fn draw_series(chart: &Chart, frame: PlotFrame, glyphs: Glyphs) -> DotCanvas {
    let mut canvas = DotCanvas::new(frame, glyphs);
    let of_kind = |dimmed: bool| {
        let shown = move |s: &&Series| s.visible && s.dimmed == dimmed;
        chart.series.iter().filter(shown)
    };
    let order: Vec<&Series> = of_kind(true).chain(of_kind(false)).collect();
    let paths: Vec<DotPath> = order.iter().map(|series| canvas.line(series)).collect();
    for (turn, (series, path)) in order.iter().zip(&paths).enumerate() {
        canvas.markers(series, path, turn, order.len());
    }
    canvas
}
