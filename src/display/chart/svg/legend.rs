//! Which curve is which: names at the right ends of the curves where these have such ends and there is room, else samples above the plot.

use super::curves;
use super::ink::{self, TEXT};
use super::page::{Anchor, SvgPage, WIDTH, shortened, width};
use super::plan::{ROW, SvgPlan, share};
use crate::chart::draw::AxisDisplay;
use crate::chart::{Chart, Series};

/// Length of a sample of a curve, and the room before its name.
const SAMPLE: f64 = 40.0;
const GAP: f64 = 6.0;

/// Room between entries above the plot.
const APART: f64 = 22.0;

/// The widest names beside a plot, and the greatest part of its height that they take.
const WIDEST: f64 = 0.3 * WIDTH;
const FULL: f64 = 0.6;

/// A curve has a right end where its last point is at least so far along the plot.
const END: f64 = 0.9;

/// Where the curves are named.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Legend {
    /// Nowhere: there is nothing to tell apart.
    None,
    /// At their right ends, in so much room.
    Ends(f64),
    /// Above the plot, in so many rows.
    Above(usize),
}

impl Legend {
    /// Height above the plot.
    pub(super) fn height(&self) -> f64 {
        match self {
            Self::Above(rows) => ROW * *rows as f64,
            _ => 0.0,
        }
    }

    /// Room to the right of the plot.
    pub(super) fn right(&self) -> f64 {
        match self {
            Self::Ends(room) => *room,
            _ => 0.0,
        }
    }
}

/// Where the curves of a chart are named in a picture of this height.
pub(super) fn place(chart: &Chart, shown: (AxisDisplay, AxisDisplay), height: f64) -> Legend {
    let named = || named(chart);
    if !(chart.legend || chart.ends) || named().next().is_none() || chart.map.is_some() {
        return Legend::None;
    }
    let widest = named().map(|s| width(&s.label, TEXT)).fold(0.0, f64::max);
    let room = ROW * named().count() as f64 <= FULL * height;
    let ends = named().all(|series| has_end(series, shown));
    if !chart.equal_scale && widest <= WIDEST && room && ends {
        return Legend::Ends(widest + 0.5 * SAMPLE + 3.0 * GAP);
    }
    Legend::Above(flow(chart).last().map_or(0, |(_, row, _)| row + 1))
}

/// The curves that have names.
fn named(chart: &Chart) -> impl Iterator<Item = &Series> {
    let seen = |series: &&Series| series.visible && !series.label.is_empty();
    chart.series.iter().filter(seen)
}

/// Whether a curve ends at the right of the plot.
fn has_end(series: &Series, (x, y): (AxisDisplay, AxisDisplay)) -> bool {
    let last = last_point(series, x, y);
    last.is_some_and(|last| (END..=1.0 + 1e-9).contains(&share(x, last.0)))
}

/// The last point of a curve within the plot's range of x.
fn last_point(series: &Series, x: AxisDisplay, y: AxisDisplay) -> Option<(f64, f64)> {
    let inside = |p: &&(f64, f64)| x.1.shows(p.0) && y.1.shows(p.1) && p.0 <= x.0.1;
    series.points.iter().rev().find(inside).copied()
}

/// Curves with row and left edge of their entries above the plot.
fn flow(chart: &Chart) -> Vec<(&Series, usize, f64)> {
    let (mut row, mut left) = (0, 0.0);
    let mut all = Vec::new();
    for series in named(chart) {
        let wide = SAMPLE + GAP + width(&series.label, TEXT).min(WIDTH - SAMPLE - GAP);
        if left > 0.0 && left + wide > WIDTH {
            (row, left) = (row + 1, 0.0);
        }
        all.push((series, row, left));
        left += wide + APART;
    }
    all
}

/// Draws the names.
pub(super) fn draw(chart: &Chart, plan: &SvgPlan, page: &mut SvgPage) {
    match plan.legend {
        Legend::None => {}
        Legend::Ends(room) => at_ends(chart, plan, room, page),
        Legend::Above(rows) => {
            let first = plan.top - 8.0 - ROW * (rows as f64 + 0.5);
            for (series, row, left) in flow(chart) {
                let y = first + ROW * row as f64;
                sample(series, (left, y), SAMPLE, page);
                let name = shortened(&series.label, WIDTH - SAMPLE - GAP, TEXT);
                let at = (left + SAMPLE + GAP, y + 0.35 * TEXT);
                page.words(at, Anchor::Start, &name);
            }
        }
    }
}

/// A short piece of a curve with its marker.
fn sample(series: &Series, (left, y): curves::PicturePoint, length: f64, page: &mut SvgPage) {
    let (colour, dash) = (ink::colour(series), ink::dash(series));
    page.path(
        &curves::path(&[(left, y), (left + length, y)]),
        colour,
        1.6,
        dash,
    );
    page.marker((left + 0.5 * length, y), series.slot, colour);
}

/// Each name beside the end of its curve, none over another.
fn at_ends(chart: &Chart, plan: &SvgPlan, room: f64, page: &mut SvgPage) {
    let end = |series: &Series| {
        let last = last_point(series, plan.x, plan.y);
        let y = last.map_or(plan.bottom(), |(_, y)| plan.y_of(y));
        y.clamp(plan.top, plan.bottom())
    };
    let mut names: Vec<(f64, f64, &Series)> = named(chart)
        .map(|series| (end(series), end(series), series))
        .collect();
    names.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut least = plan.top + 0.5 * ROW;
    for (place, _, _) in &mut names {
        *place = least.max(*place);
        least = *place + ROW;
    }
    // Those pushed over the lower edge move up again.
    let mut most = plan.bottom();
    for (place, _, _) in names.iter_mut().rev() {
        *place = most.min(*place);
        most = *place - ROW;
    }
    let left = plan.right() + GAP;
    for (place, end, series) in names {
        let from = (plan.right() + 1.0, end);
        page.line(from, (left + GAP, place), ink::colour(series), "");
        sample(series, (left + GAP, place), 0.5 * SAMPLE, page);
        let at = (left + 2.0 * GAP + 0.5 * SAMPLE, place + 0.35 * TEXT);
        let name = shortened(&series.label, room - 3.0 * GAP - 0.5 * SAMPLE + GAP, TEXT);
        page.words(at, Anchor::Start, &name);
    }
}
