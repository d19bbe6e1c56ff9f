//! The scene in space: the path of the payload, the line at an instant from the side, above and ahead.

use super::{PlottedRun, body, named, of_lines, series, slots, values};
use seacable_base::number;
use seacable_display::chart::{
    Axis, AxisRange, Chart, LimitLine, ReferenceLine, Series, extent, fit,
};
use seacable_model::case::ChannelQuantity;
use seacable_runs::run::LineShape;

/// Path of the payload, z against x \[m\], to equal scale; with the place of the payload at an
/// instant \[s\] marked when one is given.
#[must_use]
pub fn trajectory(sources: &[PlottedRun], instant: Option<f64>) -> Chart {
    let body = body(sources).unwrap_or("payload");
    let mut all = Vec::new();
    for (source, slot) in sources.iter().zip(slots(sources, 2)) {
        let (Some(x), Some(z)) = (
            values(source, ChannelQuantity::X, body),
            values(source, ChannelQuantity::Z, body),
        ) else {
            continue;
        };
        let path: Vec<(f64, f64)> = x.iter().copied().zip(z.iter().copied()).collect();
        let at = instant.and_then(|time| nearest(&source.history.time, time));
        let here = at.and_then(|at| Some((source.history.time.get(at)?, *path.get(at)?)));
        all.push(series(source, slot, &named(sources, source, body), path));
        if let Some((time, place)) = here {
            let label = format!("at {}", number::si(*time, "s"));
            let label = named(sources, source, &label);
            all.push(series(source, slot + 1, &label, vec![place]));
        }
    }
    in_space(&format!("Path of the {body}"), all)
}

/// From where the line is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ViewDirection {
    /// Along y: z against x.
    Side,
    /// From above: y against x.
    Plan,
    /// Along x: z against y.
    Front,
}

impl ViewDirection {
    /// The coordinates to the right and up.
    fn axes(self) -> (usize, usize) {
        match self {
            Self::Side => (0, 2),
            Self::Plan => (0, 1),
            Self::Front => (1, 2),
        }
    }

    fn title(self) -> &'static str {
        match self {
            Self::Side => "Shape of the line",
            Self::Plan => "The line from above",
            Self::Front => "The line from ahead",
        }
    }

    /// The paths of several lines, with a gap between two of them.
    fn project_all<'n>(self, lines: impl Iterator<Item = &'n [[f64; 3]]>) -> Vec<(f64, f64)> {
        let mut points = Vec::new();
        for nodes in lines {
            if !points.is_empty() {
                points.push((f64::NAN, f64::NAN));
            }
            points.extend(self.project(nodes));
        }
        points
    }

    fn project(self, nodes: &[[f64; 3]]) -> impl Iterator<Item = (f64, f64)> {
        let (right, up) = self.axes();
        nodes.iter().map(move |p| (p[right], p[up]))
    }
}

/// The line at the stored instant nearest to a time \[s\], z against x \[m\], to equal scale. The
/// axes show all stored shapes, so that they stay fixed during a run.
#[must_use]
pub fn line_shape(sources: &[PlottedRun], time: f64) -> Chart {
    view(sources, time, ViewDirection::Side)
}

/// The line from above, y against x \[m\], as [`line_shape`].
#[must_use]
pub fn line_from_above(sources: &[PlottedRun], time: f64) -> Chart {
    view(sources, time, ViewDirection::Plan)
}

/// The line along the x axis, z against y \[m\], as [`line_shape`].
#[must_use]
pub fn line_from_ahead(sources: &[PlottedRun], time: f64) -> Chart {
    view(sources, time, ViewDirection::Front)
}

fn view(sources: &[PlottedRun], time: f64, view: ViewDirection) -> Chart {
    let mut all = Vec::new();
    for (source, slot) in sources.iter().zip(slots(sources, 1)) {
        let shapes = shapes_at(source.shapes, time);
        let at_end = || source.profiles.iter().map(|line| line.nodes.as_slice());
        let (label, points) = match (shapes.first(), source.profiles.is_empty()) {
            (_, false) if source.at_rest() => {
                let alone = sources.len() == 1;
                let label = format!("{} at rest", line_or_lines(source.profiles.len()));
                let label = if alone { label } else { String::new() };
                (label, view.project_all(at_end()))
            }
            (Some(first), _) => (
                format!(
                    "{} at {}",
                    line_or_lines(shapes.len()),
                    number::si(first.time, "s")
                ),
                view.project_all(shapes.iter().map(|shape| shape.nodes.as_slice())),
            ),
            (None, false) => (
                format!("{} at the end", line_or_lines(source.profiles.len())),
                view.project_all(at_end()),
            ),
            (None, true) => continue,
        };
        let label = named(sources, source, &label);
        all.push(series(source, slot, &label, points));
    }
    let mut chart = in_space(&of_lines(view.title(), sources), all);
    if view == ViewDirection::Plan {
        chart.limits.clear();
    }
    let (right, up) = view.axes();
    let letters = ["x", "y", "z"];
    let (across, upward) = reach(sources, view);
    let axis = |i: usize, reach: Option<AxisRange>| {
        Axis::new(letters[i], "m").over(reach.map(|r| fit(Some(r))))
    };
    chart.x = axis(right, across);
    chart.y = axis(up, upward);
    chart
}

/// A chart of the vertical plane, still water marked.
fn in_space(title: &str, series: Vec<Series>) -> Chart {
    Chart {
        limits: vec![ReferenceLine::new(
            "still water",
            LimitLine::Horizontal(0.0),
        )],
        equal_scale: true,
        ..Chart::new(title, Axis::new("x", "m"), Axis::new("z", "m"), series)
    }
}

/// From where to where the line goes across and up, in all shapes of all runs.
fn reach(sources: &[PlottedRun], view: ViewDirection) -> (Option<AxisRange>, Option<AxisRange>) {
    let all = || {
        sources.iter().flat_map(|source| {
            let end = source.profiles.iter().flat_map(|p| view.project(&p.nodes));
            source
                .shapes
                .iter()
                .flat_map(|s| view.project(&s.nodes))
                .chain(end)
        })
    };
    (extent(all().map(|p| p.0)), extent(all().map(|p| p.1)))
}

/// The shapes of all lines at the stored time nearest to another.
fn shapes_at(shapes: &[LineShape], time: f64) -> &[LineShape] {
    let far = |shape: &LineShape| (shape.time - time).abs();
    let mut at_once = shapes.chunk_by(|one, other| one.time == other.time);
    let Some(first) = at_once.next() else {
        return &[];
    };
    at_once.fold(first, |best, next| match far(&next[0]) < far(&best[0]) {
        true => next,
        false => best,
    })
}

fn line_or_lines(count: usize) -> &'static str {
    match count {
        1 => "line",
        _ => "lines",
    }
}

/// Number of the time nearest to another.
fn nearest(times: &[f64], time: f64) -> Option<usize> {
    let far = |i: &usize| (times[*i] - time).abs();
    (0..times.len()).min_by(|a, b| far(a).total_cmp(&far(b)))
}
