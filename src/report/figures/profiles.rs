//! What changes along the line: tension, curvature, bending moment, stiffness, over unstretched arc length.

use super::{PlottedRun, named, of_lines, series, slots};
use seacable_display::chart::{Axis, Chart, extent};
use seacable_runs::run::Profile;

/// Names of the curves of an envelope.
const END_AND_ENVELOPE: [&str; 3] = ["at the end", "smallest", "greatest"];
const END_AND_GREATEST: [&str; 2] = ["at the end", "greatest"];

/// Tension along the line at the end \[N\] over unstretched arc length from end A \[m\], with its
/// smallest and greatest values over time where they differ from it.
#[must_use]
pub fn tension_profile(sources: &[PlottedRun]) -> Chart {
    let y = Axis::new("tension", "N");
    envelope(
        sources,
        "Tension along the line",
        y,
        &END_AND_ENVELOPE,
        |p| (&p.arc, vec![&p.tension, &p.tension_min, &p.tension_max]),
    )
}

/// Curvature along the line at the end \[1/m\], with its greatest values over time where they differ from it.
#[must_use]
pub fn curvature_profile(sources: &[PlottedRun]) -> Chart {
    let y = Axis::new("curvature", "1/m");
    envelope(
        sources,
        "Curvature along the line",
        y,
        &END_AND_GREATEST,
        |p| (&p.arc, vec![&p.curvature, &p.curvature_max]),
    )
}

/// Bending moment along the line at the end \[N m\], with its greatest values over time where they differ from it.
#[must_use]
pub fn moment_profile(sources: &[PlottedRun]) -> Chart {
    let y = Axis::new("bending moment", "N m");
    envelope(
        sources,
        "Bending moment along the line",
        y,
        &END_AND_GREATEST,
        |p| (&p.arc, vec![&p.moment, &p.moment_max]),
    )
}

/// Stiffness k = EA by breaking load along the fibre ropes at the end, with its smallest and greatest values over time
/// where they differ from it.
#[must_use]
pub fn stiffness_profile(sources: &[PlottedRun]) -> Chart {
    let y = Axis::new("EA by breaking load", "");
    envelope(
        sources,
        "Dynamic stiffness along the line",
        y,
        &END_AND_ENVELOPE,
        |p| {
            let ropes = &p.ropes;
            let values = vec![&ropes.stiffness, &ropes.stiffness_min, &ropes.stiffness_max];
            (&ropes.arc, values)
        },
    )
}

/// Values at the end and their extremes over time; at rest the values alone, named after the run.
fn envelope<'p>(
    sources: &[PlottedRun<'p>],
    title: &str,
    y: Axis,
    names: &[&'static str],
    curves: impl Fn(&'p Profile) -> (&'p Vec<f64>, Vec<&'p Vec<f64>>),
) -> Chart {
    let has_several = sources.iter().any(|source| source.profiles.len() > 1);
    let most = if has_several { 1 } else { 3 };
    over_arc(sources, title, y, most, |source, profile| {
        let (arc, curves) = curves(profile);
        if has_several && !source.at_rest() {
            // Of several lines the greatest values are compared.
            let greatest = curves.last().map(|values| points(arc, values));
            return greatest
                .map(|points| ("greatest", points))
                .into_iter()
                .collect();
        }
        let shown = if source.at_rest() { 1 } else { names.len() };
        let named = names.iter().zip(curves).take(shown);
        let name = |name: &'static str| match (source.at_rest(), sources.len()) {
            (false, _) => name,
            (true, 1) => "at rest",
            (true, _) => "",
        };
        named
            .map(|(curve, values)| (name(curve), points(arc, values)))
            .collect()
    })
}

/// Values at the nodes over arc length.
pub(super) fn points(arc: &[f64], values: &[f64]) -> Vec<(f64, f64)> {
    arc.iter().copied().zip(values.iter().copied()).collect()
}

/// Curves of every profile, at most `most` of each, over the arc length of the longest line.
pub(super) fn over_arc<'p>(
    sources: &[PlottedRun<'p>],
    title: &str,
    y: Axis,
    most: usize,
    curves: impl Fn(&PlottedRun, &'p Profile) -> Vec<(&'static str, Vec<(f64, f64)>)>,
) -> Chart {
    let mut all = Vec::new();
    let lines = sources.iter().map(|source| source.profiles.len());
    let lines = lines.max().unwrap_or_default().max(1);
    for (source, slot) in sources.iter().zip(slots(sources, most * lines)) {
        for (line, profile) in source.profiles.iter().enumerate() {
            let numbered = (slot + most * line..).zip(curves(source, profile));
            for (slot, (name, points)) in numbered.filter(|(_, (_, points))| !points.is_empty()) {
                let name = match profile.line.as_str() {
                    "" => name.to_owned(),
                    line if name.is_empty() => line.to_owned(),
                    line => format!("{line}, {name}"),
                };
                all.push(series(source, slot, &named(sources, source, &name), points));
            }
        }
    }
    let profiles = sources.iter().flat_map(|source| source.profiles);
    let length = profiles.filter_map(|profile| profile.arc.last().copied());
    let range = extent(length.chain([0.0])).filter(|range| range.1 > range.0);
    let arc = Axis::new("arc length from end A", "m").over(range);
    Chart::new(of_lines(title, sources), arc, y, all)
}
