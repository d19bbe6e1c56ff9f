//! The scene in space: the path of the payload, the line at an instant, tension along it.

use super::{Source, body, named, slots, values};
use crate::report::chart::{Axis, Chart, Limit, LimitLine, Range, Series, extent, fit};
use crate::report::number;
use crate::run::LineShape;

/// Path of the payload, z against x \[m\], to equal scale; with the place of the payload at an
/// instant \[s\] marked when one is given.
#[must_use]
pub fn trajectory(sources: &[Source], instant: Option<f64>) -> Chart {
    let body = body(sources).unwrap_or("payload");
    let mut series = Vec::new();
    for (source, slot) in sources.iter().zip(slots(sources, 2)) {
        let (Some(x), Some(z)) = (values(source, "x_m", body), values(source, "z_m", body)) else {
            continue;
        };
        let path: Vec<(f64, f64)> = x.iter().copied().zip(z.iter().copied()).collect();
        let at = instant.and_then(|time| nearest(&source.history.time, time));
        let here = at.and_then(|at| Some((source.history.time.get(at)?, *path.get(at)?)));
        series.push(Series {
            dimmed: source.dimmed,
            ..Series::new(&named(sources, source, body), slot, path)
        });
        if let Some((time, place)) = here {
            let label = format!("at {}", number::si(*time, "s"));
            series.push(Series {
                dimmed: source.dimmed,
                ..Series::new(&named(sources, source, &label), slot + 1, vec![place])
            });
        }
    }
    in_space(&format!("Path of the {body}"), series)
}

/// The line at the stored instant nearest to a time \[s\], z against x \[m\], to equal scale. The
/// axes show all stored shapes, so that they stand still while time goes on.
#[must_use]
pub fn line_shape(sources: &[Source], time: f64) -> Chart {
    let mut series = Vec::new();
    for (source, slot) in sources.iter().zip(slots(sources, 1)) {
        let (label, nodes) = match shape_at(source.shapes, time) {
            Some(shape) => (
                format!("line at {}", number::si(shape.time, "s")),
                &shape.nodes,
            ),
            None => match source.profile {
                Some(profile) => ("line at the end".to_owned(), &profile.nodes),
                None => continue,
            },
        };
        series.push(Series {
            dimmed: source.dimmed,
            ..Series::new(&named(sources, source, &label), slot, xz(nodes).collect())
        });
    }
    let mut chart = in_space("Shape of the line", series);
    let (x, z) = reach(sources);
    chart.x.range = x.map(|x| fit(Some(x)));
    chart.y.range = z.map(|z| fit(Some(z)));
    chart
}

/// Tension along the line at the end \[N\] over unstretched arc length from end A \[m\], with its
/// smallest and greatest values over time.
#[must_use]
pub fn tension_profile(sources: &[Source]) -> Chart {
    let mut series = Vec::new();
    for (source, slot) in sources.iter().zip(slots(sources, 3)) {
        let Some(profile) = source.profile else {
            continue;
        };
        let lines = [
            ("at the end", &profile.tension),
            ("smallest", &profile.tension_min),
            ("greatest", &profile.tension_max),
        ];
        for (number, (name, tension)) in lines.into_iter().enumerate() {
            let points = profile.arc.iter().copied().zip(tension.iter().copied());
            series.push(Series {
                dimmed: source.dimmed,
                ..Series::new(
                    &named(sources, source, name),
                    slot + number,
                    points.collect(),
                )
            });
        }
    }
    let length = sources
        .iter()
        .filter_map(|s| s.profile?.arc.last().copied());
    Chart {
        title: "Tension along the line".to_owned(),
        x: Axis {
            range: extent(length.chain([0.0])).filter(|range| range.1 > range.0),
            ..Axis::new("arc length from end A", "m")
        },
        y: Axis::new("tension", "N"),
        series,
        legend: true,
        ..Chart::default()
    }
}

/// A chart of the vertical plane, still water marked.
fn in_space(title: &str, series: Vec<Series>) -> Chart {
    Chart {
        title: title.to_owned(),
        x: Axis::new("x", "m"),
        y: Axis::new("z", "m"),
        series,
        limits: vec![Limit {
            label: "still water".to_owned(),
            line: LimitLine::Horizontal(0.0),
        }],
        equal_scale: true,
        legend: true,
        ..Chart::default()
    }
}

fn xz(nodes: &[[f64; 3]]) -> impl Iterator<Item = (f64, f64)> {
    nodes.iter().map(|[x, _, z]| (*x, *z))
}

/// From where to where the line goes in x and z, in all shapes of all runs.
fn reach(sources: &[Source]) -> (Option<Range>, Option<Range>) {
    let all = || {
        sources.iter().flat_map(|source| {
            let end = source.profile.into_iter().flat_map(|p| xz(&p.nodes));
            source.shapes.iter().flat_map(|s| xz(&s.nodes)).chain(end)
        })
    };
    (extent(all().map(|p| p.0)), extent(all().map(|p| p.1)))
}

fn shape_at(shapes: &[LineShape], time: f64) -> Option<&LineShape> {
    let far = |shape: &LineShape| (shape.time - time).abs();
    shapes.iter().min_by(|a, b| far(a).total_cmp(&far(b)))
}

/// Number of the time nearest to another.
fn nearest(times: &[f64], time: f64) -> Option<usize> {
    let far = |i: &usize| (times[*i] - time).abs();
    (0..times.len()).min_by(|a, b| far(a).total_cmp(&far(b)))
}
