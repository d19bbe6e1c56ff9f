//! Curves: lines with dashes and markers of their own.

use super::ink;
use super::page::{SvgPage, px};
use super::plan::SvgPlan;
use crate::chart::clip::clip;
use crate::chart::decimate::decimate;
use crate::chart::{Chart, Series};

/// A place in the picture.
pub(super) type PicturePoint = (f64, f64);

/// A line of places that hang together.
pub(super) type Polyline = Vec<PicturePoint>;

/// Markers along a curve are at least so far apart.
const SPACING: f64 = 150.0;

/// How far a place may be from the line that replaces it.
const TOLERANCE: f64 = 0.08;

/// Places that a straight line may replace at most.
const MOST: usize = 64;

/// Half the cap of an error bar.
const CAP: f64 = 3.0;

/// Draws the curves, older results below the others, and returns the lines of all.
pub(super) fn draw(chart: &Chart, plan: &SvgPlan, page: &mut SvgPage) -> Vec<Polyline> {
    let of_kind = |dimmed: bool| {
        let shown = move |s: &&Series| s.visible && s.dimmed == dimmed;
        chart.series.iter().filter(shown)
    };
    let order: Vec<&Series> = of_kind(true).chain(of_kind(false)).collect();
    let all: Vec<Vec<Polyline>> = order.iter().map(|s| polylines(s, plan)).collect();
    for (series, lines) in order.iter().zip(&all) {
        match is_bars(series) {
            true => bars(series, lines, page),
            false => curve(series, lines, page),
        }
    }
    for (turn, (series, lines)) in order.iter().zip(&all).enumerate() {
        if !is_bars(series) {
            markers(series, lines, (turn, order.len()), page);
        }
    }
    all.into_iter().flatten().collect()
}

fn curve(series: &Series, lines: &[Polyline], page: &mut SvgPage) {
    let d: String = lines.iter().map(|line| path(line)).collect();
    if !d.is_empty() {
        let width = if series.dimmed { 1.2 } else { 1.6 };
        page.path(&d, ink::colour(series), width, ink::dash(series));
    }
}

/// A line as commands of a path; a single place is a short stroke.
pub(super) fn path(line: &[PicturePoint]) -> String {
    let mut d = String::new();
    for (i, (x, y)) in line.iter().enumerate() {
        d.push(if i == 0 { 'M' } else { 'L' });
        d.push_str(&format!("{} {}", px(*x), px(*y)));
    }
    if line.len() == 1 {
        d.push_str("h0.1");
    }
    d
}

/// Whether a series is error bars: upright lines between two points each.
fn is_bars(series: &Series) -> bool {
    let mut pieces = series
        .points
        .split(|point| !point.1.is_finite())
        .filter(|piece| !piece.is_empty());
    let upright =
        |piece: &[(f64, f64)]| matches!(piece, [low, high] if low.0.to_bits() == high.0.to_bits());
    !series.points.is_empty() && pieces.all(upright)
}

/// Error bars: lines without gaps, with a cap at each end.
fn bars(series: &Series, lines: &[Polyline], page: &mut SvgPage) {
    let mut d = String::new();
    for line in lines {
        d.push_str(&path(line));
        for (x, y) in line {
            d.push_str(&format!("M{} {}h{}", px(x - CAP), px(*y), px(2.0 * CAP)));
        }
    }
    if !d.is_empty() {
        page.path(&d, ink::colour(series), 1.2, "");
    }
}

/// The lines of a series inside the plot.
fn polylines(series: &Series, plan: &SvgPlan) -> Vec<Polyline> {
    let (along, up) = (plan.x.1, plan.y.1);
    let pieces = series
        .points
        .split(|p| !along.shows(p.0) || !up.shows(p.1))
        .filter(|piece| !piece.is_empty());
    pieces.flat_map(|piece| inside(piece, plan)).collect()
}

/// The parts of an unbroken line that are inside the plot.
fn inside(points: &[(f64, f64)], plan: &SvgPlan) -> Vec<Polyline> {
    // Far outside, exact places do not matter, only that arithmetic stays finite.
    let far = |v: f64| v.clamp(-1e9, 1e9);
    let at = |(x, y): &(f64, f64)| {
        (
            far(plan.x_of(*x)) - plan.left,
            far(plan.y_of(*y)) - plan.top,
        )
    };
    let dots = decimate(points.iter().map(at));
    let single = [(dots[0], dots[0])];
    let pairs: Vec<(PicturePoint, PicturePoint)> =
        dots.windows(2).map(|pair| (pair[0], pair[1])).collect();
    let pairs = if pairs.is_empty() {
        &single[..]
    } else {
        &pairs
    };
    let mut lines: Vec<Polyline> = Vec::new();
    for (from, to) in pairs {
        let Some((from, to)) = clip(*from, *to, 0.0, (plan.across, plan.down)) else {
            continue;
        };
        let back = |(x, y): PicturePoint| (x + plan.left, y + plan.top);
        let (from, to) = (back(from), back(to));
        match lines.last_mut() {
            Some(open) if open.last().is_some_and(|last| distance(*last, from) < 1e-6) => {
                open.push(to);
            }
            _ if distance(from, to) > 0.0 => lines.push(vec![from, to]),
            _ => lines.push(vec![from]),
        }
    }
    lines.iter().map(|line| thinned(line)).collect()
}

/// The line without the places that are on the straight between their neighbours.
fn thinned(line: &[PicturePoint]) -> Polyline {
    let mut kept: Polyline = line.first().copied().into_iter().collect();
    let mut begin = 0;
    for end in 1..line.len() {
        let next = line.get(end + 1);
        let straight = next.is_some_and(|next| {
            end - begin < MOST
                && line[begin + 1..=end]
                    .iter()
                    .all(|place| aside(*place, line[begin], *next) < TOLERANCE)
        });
        if !straight {
            kept.push(line[end]);
            begin = end;
        }
    }
    kept
}

/// Distance of a place from the line between two.
fn aside(place: PicturePoint, from: PicturePoint, to: PicturePoint) -> f64 {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx.hypot(dy);
    let (px, py) = (place.0 - from.0, place.1 - from.1);
    if length <= 0.0 {
        return px.hypot(py);
    }
    let along = ((px * dx + py * dy) / (length * length)).clamp(0.0, 1.0);
    (px - along * dx).hypot(py - along * dy)
}

fn distance(a: PicturePoint, b: PicturePoint) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

/// The markers of a curve along it, those of several curves at different places, so that curves that coincide show both.
fn markers(series: &Series, lines: &[Polyline], (turn, of): (usize, usize), page: &mut SvgPage) {
    let offset = SPACING * (turn as f64 + 0.5) / of.max(1) as f64;
    let mut placed: Vec<PicturePoint> = Vec::new();
    let mut passed = 0.0;
    let mut due = offset;
    for pair in lines.iter().flat_map(|line| line.windows(2)) {
        let length = distance(pair[0], pair[1]);
        while due <= passed + length {
            let part = (due - passed) / length;
            let at = |from: f64, to: f64| from + part * (to - from);
            let place = (at(pair[0].0, pair[1].0), at(pair[0].1, pair[1].1));
            // A curve that goes up and down is long, but its markers need room.
            if placed.iter().all(|p| distance(*p, place) >= 0.6 * SPACING) {
                placed.push(place);
                due += SPACING;
            } else {
                due += 0.2 * SPACING;
            }
        }
        passed += length;
    }
    if placed.is_empty() {
        // A short curve gets its marker in the middle.
        let all: Vec<&PicturePoint> = lines.iter().flatten().collect();
        placed.extend(all.get(all.len() / 2).copied());
    }
    for place in placed {
        page.marker(place, series.slot, ink::colour(series));
    }
}
