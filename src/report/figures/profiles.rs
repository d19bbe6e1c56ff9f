//! What changes along the line: tension, curvature, bending moment, over unstretched arc length.

use super::{PlottedRun, named, slots};
use crate::report::chart::{Axis, Chart, Series, extent};
use crate::run::Profile;

/// A curve of a profile: its name, and its values at the nodes.
type Curve<'a> = (&'static str, &'a [f64]);

/// Tension along the line at the end \[N\] over unstretched arc length from end A \[m\], with its
/// smallest and greatest values over time where they differ from it.
#[must_use]
pub fn tension_profile(sources: &[PlottedRun]) -> Chart {
    along(
        sources,
        "Tension along the line",
        Axis::new("tension", "N"),
        |p| {
            [
                ("at the end", &p.tension),
                ("smallest", &p.tension_min),
                ("greatest", &p.tension_max),
            ]
            .map(|(name, values)| (name, values.as_slice()))
            .into()
        },
    )
}

/// Curvature along the line at the end \[1/m\], with its greatest values over time where they differ from it.
#[must_use]
pub fn curvature_profile(sources: &[PlottedRun]) -> Chart {
    along(
        sources,
        "Curvature along the line",
        Axis::new("curvature", "1/m"),
        |p| vec![("at the end", &p.curvature), ("greatest", &p.curvature_max)],
    )
}

/// Bending moment along the line at the end \[N m\], with its greatest values over time where they differ from it.
#[must_use]
pub fn moment_profile(sources: &[PlottedRun]) -> Chart {
    along(
        sources,
        "Bending moment along the line",
        Axis::new("bending moment", "N m"),
        |p| vec![("at the end", &p.moment), ("greatest", &p.moment_max)],
    )
}

/// The curves of every profile over arc length.
fn along(
    sources: &[PlottedRun],
    title: &str,
    y: Axis,
    curves: impl Fn(&Profile) -> Vec<Curve<'_>>,
) -> Chart {
    let mut series = Vec::new();
    for (source, slot) in sources.iter().zip(slots(sources, 3)) {
        let Some(profile) = source.profile else {
            continue;
        };
        let at_rest = source.at_rest();
        let shown = if at_rest { 1 } else { 3 };
        let all = curves(profile).into_iter().enumerate();
        for (number, (name, values)) in all.take(shown).filter(|(_, c)| !c.1.is_empty()) {
            let name = match (at_rest, sources.len()) {
                (false, _) => name,
                (true, 1) => "at rest",
                (true, _) => "",
            };
            let points = profile.arc.iter().copied().zip(values.iter().copied());
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
    over_arc(sources, title, y, series)
}

/// These series over the arc length of the longest line.
pub(super) fn over_arc(sources: &[PlottedRun], title: &str, y: Axis, series: Vec<Series>) -> Chart {
    let length = sources
        .iter()
        .filter_map(|s| s.profile?.arc.last().copied());
    Chart {
        title: title.to_owned(),
        x: Axis {
            range: extent(length.chain([0.0])).filter(|range| range.1 > range.0),
            ..Axis::new("arc length from end A", "m")
        },
        y,
        series,
        legend: true,
        ..Chart::default()
    }
}
