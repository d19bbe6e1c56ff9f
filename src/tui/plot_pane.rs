//! What the user does with a chart: cursor, zoom, pan, freeze, marks.
//!
//! [`PlotPane`] is plain state. [`PlotPane::act`] changes it, [`PlotPane::chart`] lays it over a
//! chart made from runs, [`draw_chart`] paints the outcome; only the first changes anything.

mod picture_memo;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use self::picture_memo::PictureMemo;
use super::theme::Theme;
use crate::chart::{
    self, AxisRange, AxisScale, CONTINUATION, Chart, Glyphs, LimitLine, Picture, PlotFrame,
    Readout, ReferenceLine, Series,
};
use crate::number;

/// What can be done with a chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlotVerb {
    /// Cursor right by a stride, or left where negative.
    Cursor(f64, Stride),
    /// Show what lies further right and higher, by parts of what is shown.
    Pan(f64, f64),
    /// Show so many times as much along x, about the cursor; at equal scale along both axes.
    Zoom(f64),
    /// Everything along x and y.
    Fit,
    /// Along y just what the lines do within the x shown.
    FitUp,
    /// Hold the curves still, or let them continue.
    Freeze,
    /// Set a mark at the cursor, or remove the mark there.
    Mark,
    /// Change between a logarithmic and a linear x axis.
    LogAlong,
    /// The same of the y axis.
    LogUp,
}

/// How far the cursor goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stride {
    /// One column of dots.
    Fine,
    /// A tenth of what is shown.
    Coarse,
}

/// Least part of the whole range that a zoom shows.
const CLOSEST: f64 = 1e-6;

/// A chart as the user has it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PlotPane {
    /// What is shown along x; absent: everything.
    x: Option<AxisRange>,
    /// What is shown along y; absent: everything.
    y: Option<AxisRange>,
    cursor: Option<f64>,
    /// Position of the cursor on the y axis of a map.
    cursor_y: Option<f64>,
    /// Marked places on the x axis, in the order in which they were set.
    marks: Vec<f64>,
    /// The chart as it was when it was frozen.
    frozen: Option<Box<Chart>>,
    /// Whether x and y are on logarithmic axes.
    log: (bool, bool),
    memo: PictureMemo,
}

impl PlotPane {
    /// Position of the cursor on the x axis.
    #[must_use]
    pub fn cursor(&self) -> Option<f64> {
        self.cursor
    }

    /// Puts the cursor somewhere, such as its position in another chart.
    pub fn set_cursor(&mut self, x: Option<f64>) {
        self.cursor = x.filter(|x| x.is_finite());
    }

    /// Whether the curves are held still.
    #[must_use]
    pub fn is_frozen(&self) -> bool {
        self.frozen.is_some()
    }

    /// What is shown along x and along y; absent: everything.
    #[must_use]
    pub const fn shown(&self) -> (Option<AxisRange>, Option<AxisRange>) {
        (self.x, self.y)
    }

    /// Shows these ranges; those that are none show everything.
    pub fn show(&mut self, x: Option<AxisRange>, y: Option<AxisRange>) {
        let sane =
            |range: &AxisRange| range.0.is_finite() && range.1.is_finite() && range.0 < range.1;
        self.x = x.filter(sane);
        self.y = y.filter(sane);
    }

    /// Whether all of the chart is shown, and no cursor on it.
    #[must_use]
    pub fn is_fitted(&self) -> bool {
        self.x.is_none() && self.y.is_none() && self.cursor.is_none()
    }

    /// The chart as it is to be drawn: the one given, or the frozen one, with the user's ranges,
    /// cursor and marks.
    #[must_use]
    pub fn chart(&self, base: &Chart) -> Chart {
        let mut chart = self.source(base).clone();
        chart.x.range = self.x.or(chart.x.range);
        chart.y.range = self.y.or(chart.y.range);
        let scale = |log: bool, given: AxisScale| if log { AxisScale::Log } else { given };
        chart.x.scale = scale(self.log.0, chart.x.scale);
        chart.y.scale = scale(self.log.1, chart.y.scale);
        chart.cursor = self.cursor.or(chart.cursor);
        if chart.map.is_some() {
            // Whoever has not chosen a place reads the middle of the line.
            let middle = || chart.y.range.map(middle);
            chart.cursor_y = chart.cursor.and(self.cursor_y.or_else(middle));
        }
        for (i, x) in self.marks.iter().enumerate() {
            let label = format!("{}: {}", i + 1, number::si(*x, &chart.x.unit));
            let mark = ReferenceLine::new(label, LimitLine::Vertical(*x));
            chart.limits.push(mark);
        }
        chart
    }

    /// Paints a chart into an area of the screen, as [`draw_chart`]; one that is as it was last time is not drawn anew.
    pub fn draw(&self, chart: &Chart, area: Rect, buf: &mut Buffer, glyphs: Glyphs, theme: Theme) {
        let area = area.intersection(*buf.area());
        let size = (area.width.into(), area.height.into());
        paint(&self.memo.picture(chart, size, glyphs), area, buf, theme);
    }

    /// What the visible series say at the cursor; nothing without a cursor.
    #[must_use]
    pub fn readout(&self, base: &Chart) -> Vec<Readout> {
        let read = |x| chart::readout(&self.chart(base), x);
        self.cursor.map(read).unwrap_or_default()
    }

    /// Does what the user asked for. `base` is the chart without the user's changes, `frame` where
    /// and what was drawn last ([`chart::frame`] gives it without drawing). With nothing drawn, an
    /// empty frame, whatever would move or scale the view does nothing.
    pub fn act(&mut self, verb: PlotVerb, base: &Chart, frame: PlotFrame) {
        let needs_frame = !matches!(
            verb,
            PlotVerb::Fit | PlotVerb::Freeze | PlotVerb::LogAlong | PlotVerb::LogUp
        );
        if (frame.width == 0 || frame.height == 0) && needs_frame {
            return;
        }
        match verb {
            PlotVerb::Cursor(way, stride) => self.move_cursor(way, stride, base, frame),
            PlotVerb::Pan(across, up) if across == 0.0 && base.map.is_some() => {
                self.move_place(up.signum(), base, frame);
            }
            PlotVerb::Pan(across, up) => self.pan(across, up, base, frame),
            PlotVerb::Zoom(factor) => self.zoom(factor, base, frame),
            PlotVerb::Fit => (self.x, self.y) = (None, None),
            PlotVerb::FitUp => self.fit_up(base, frame),
            PlotVerb::Freeze => {
                self.frozen = match self.frozen {
                    Some(_) => None,
                    None => Some(Box::new(base.clone())),
                };
            }
            PlotVerb::Mark => self.mark(frame),
            PlotVerb::LogAlong => self.log.0 = !self.log.0,
            PlotVerb::LogUp => self.log.1 = !self.log.1,
        }
    }

    fn source<'a>(&'a self, base: &'a Chart) -> &'a Chart {
        self.frozen.as_deref().unwrap_or(base)
    }

    /// The places along both axes between which everything is.
    fn whole(&self, base: &Chart, frame: PlotFrame) -> (AxisRange, AxisRange) {
        let chart = self.source(base);
        let all = |of: fn(&(f64, f64)) -> f64, given: Option<AxisRange>, scale: AxisScale| {
            let values = || chart.series.iter().flat_map(|s| s.points.iter().map(of));
            let log = (scale == AxisScale::Log).then(|| chart::log_range(given, values()));
            let range = log.flatten().or(given);
            scale.places(range.unwrap_or_else(|| chart::fit(chart::extent(values()))))
        };
        (
            all(|p| p.0, chart.x.range, frame.x_scale),
            all(|p| p.1, chart.y.range, frame.y_scale),
        )
    }

    /// The cursor begins in the middle, stays within the chart's whole range, and takes the view
    /// along when it leaves it.
    fn move_cursor(&mut self, way: f64, stride: Stride, base: &Chart, frame: PlotFrame) {
        let axis = frame.x_scale;
        let seen = axis.places(frame.x);
        let span = seen.1 - seen.0;
        let step = match stride {
            Stride::Fine => span / (frame.dot_count().0.max(2) - 1) as f64,
            Stride::Coarse => span / 10.0,
        };
        let whole = self.whole(base, frame).0;
        // What is on screen may reach beyond the data, at equal scale for instance.
        let (low, high) = (whole.0.min(seen.0), whole.1.max(seen.1));
        let at = self.cursor.map(|at| axis.place(at));
        let cursor = match at.filter(|at| at.is_finite()) {
            Some(at) => (at + way * step).clamp(low, high),
            None => middle(seen),
        };
        if cursor < seen.0 || cursor > seen.1 {
            let shift = (cursor - seen.0).min(0.0) + (cursor - seen.1).max(0.0);
            self.x = Some(axis.values((seen.0 + shift, seen.1 + shift)));
        }
        self.cursor = Some(axis.value(cursor));
    }

    /// The place read on a map goes up or down by a fortieth of what is shown; the first time the cursor appears.
    fn move_place(&mut self, way: f64, base: &Chart, frame: PlotFrame) {
        let (low, high) = self.whole(base, frame).1;
        let from = self.cursor_y.unwrap_or_else(|| middle(frame.y));
        let step = (frame.y.1 - frame.y.0) / 40.0;
        self.cursor_y = Some((from + way * step).clamp(low, high));
        self.cursor = self.cursor.or_else(|| Some(middle(frame.x)));
    }

    /// Moves the view by parts of itself; never so far that it leaves the data.
    fn pan(&mut self, across: f64, up: f64, base: &Chart, frame: PlotFrame) {
        let (x, y) = self.whole(base, frame);
        let moved = |axis: AxisScale, range, part, whole| {
            Some(axis.values(shifted(axis.places(range), part, whole)))
        };
        if across.abs() > 0.0 {
            self.x = moved(frame.x_scale, frame.x, across, x);
        }
        if up.abs() > 0.0 {
            self.y = moved(frame.y_scale, frame.y, up, y);
        }
    }

    fn zoom(&mut self, factor: f64, base: &Chart, frame: PlotFrame) {
        let (x, y) = self.whole(base, frame);
        let axis = frame.x_scale;
        let shown = axis.places(frame.x);
        let seen = |at: &f64| (frame.x.0..=frame.x.1).contains(at);
        let cursor = self.cursor.filter(seen).map(|at| axis.place(at));
        let about = cursor.unwrap_or_else(|| middle(shown));
        self.x = scaled(shown, about, factor, x).map(|range| axis.values(range));
        if self.source(base).equal_scale {
            let at_cursor = self.readout(base).into_iter().find_map(|read| read.y);
            let seen = |at: &f64| (frame.y.0..=frame.y.1).contains(at);
            let about = at_cursor.filter(seen).unwrap_or_else(|| middle(frame.y));
            self.y = scaled(frame.y, about, factor, y);
            // One axis alone cannot show everything at equal scale.
            if self.x.is_none() || self.y.is_none() {
                (self.x, self.y) = (None, None);
            }
        }
    }

    fn fit_up(&mut self, base: &Chart, frame: PlotFrame) {
        let chart = self.chart(base);
        let shown = chart.series.iter().filter(|series| series.visible);
        let seen = shown.flat_map(|series| between(series, frame.x));
        let seen: Vec<f64> = seen.collect();
        let log =
            (frame.y_scale == AxisScale::Log).then(|| chart::log_range(None, seen.iter().copied()));
        let fitted = || chart::extent(seen.into_iter()).map(|range| chart::fit(Some(range)));
        self.y = log.unwrap_or_else(fitted);
    }

    fn mark(&mut self, frame: PlotFrame) {
        let Some(at) = self.cursor else { return };
        let axis = frame.x_scale;
        let (from, to) = axis.places(frame.x);
        let column = (to - from) / frame.width.max(1) as f64;
        let before = self.marks.len();
        let far = |mark: f64| (axis.place(mark) - axis.place(at)).abs() > 0.5 * column;
        self.marks.retain(|mark| far(*mark));
        if self.marks.len() == before {
            self.marks.push(at);
        }
    }
}

/// What a series says within a range of x.
fn between(series: &Series, x: AxisRange) -> impl Iterator<Item = f64> {
    let inside = move |p: &&(f64, f64)| (x.0..=x.1).contains(&p.0);
    series.points.iter().filter(inside).map(|p| p.1)
}

fn middle(range: AxisRange) -> f64 {
    0.5 * range.0 + 0.5 * range.1
}

/// A range moved by a part of itself, its middle kept within the whole.
fn shifted(range: AxisRange, part: f64, whole: AxisRange) -> AxisRange {
    let wanted = part * (range.1 - range.0);
    let at = middle(range);
    // A view whose middle already lies outside may come back, not go further.
    let (low, high) = (whole.0.min(at), whole.1.max(at));
    let shift = (at + wanted).clamp(low, high) - at;
    (range.0 + shift, range.1 + shift)
}

/// A range scaled about a place; absent when it would show the whole and more.
fn scaled(range: AxisRange, about: f64, factor: f64, whole: AxisRange) -> Option<AxisRange> {
    let (full, span) = (whole.1 - whole.0, range.1 - range.0);
    let wanted = (span * factor).max(full * CLOSEST);
    if factor > 1.0 && wanted >= full {
        return None;
    }
    let ratio = wanted / span;
    Some((
        about - (about - range.0) * ratio,
        about + (range.1 - about) * ratio,
    ))
}

/// Paints a chart into an area of the screen.
pub fn draw_chart(chart: &Chart, area: Rect, buf: &mut Buffer, glyphs: Glyphs, theme: Theme) {
    let area = area.intersection(*buf.area());
    let picture = chart::draw(chart, area.width.into(), area.height.into(), glyphs);
    paint(&picture, area, buf, theme);
}

fn paint(picture: &Picture, area: Rect, buf: &mut Buffer, theme: Theme) {
    for row in 0..area.height {
        for column in 0..area.width {
            let Some(cell) = picture.get(column.into(), row.into()) else {
                continue;
            };
            let place = &mut buf[(area.x + column, area.y + row)];
            if cell.ch == CONTINUATION {
                // The wide character before it covers this cell.
                place.set_symbol("");
            } else {
                place.set_char(cell.ch);
            }
            place.set_style(theme.chart(cell.ink));
        }
    }
}

#[cfg(test)]
mod tests;
