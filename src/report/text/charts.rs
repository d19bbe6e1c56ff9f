//! The charts of a run in characters.

use super::layout::{Page, WIDTH};
use crate::{
    case::Case,
    reference::ValidationRow,
    report::{
        chart::{Chart, Glyphs, draw, extent},
        figures::{
            PlottedRun, ResponseMapKind, curvature_profile, deviation_in_time, elevation,
            line_from_above, line_from_ahead, line_shape, mean_load_in_time, moment_profile,
            payload_position, published_curves, response_map, rms_profile, speed,
            stiffness_in_time, stiffness_profile, tension_profile, tensions, tilt, trajectory,
            wave_amplitudes, wavelengths,
        },
    },
    run::Run,
};

/// Rows of a chart.
const HEIGHT: usize = 20;
/// Rows of a map, whose stripes need them.
const MAP_HEIGHT: usize = 30;

/// Every chart that has something to show; of the rows of its case, the curves that the run was held against.
pub(super) fn all(page: &mut Page, run: &Run, case: &Case, rows: &[ValidationRow], glyphs: Glyphs) {
    let sources = [PlottedRun::whole(run, "")];
    let mut charts = Vec::new();
    if run.history.time.len() > 1 {
        charts.extend([
            tensions(&sources),
            payload_position(&sources),
            speed(&sources),
            tilt(&sources),
            elevation(&sources),
            trajectory(&sources, None),
            mean_load_in_time(&sources),
            deviation_in_time(&sources),
            stiffness_in_time(&sources),
        ]);
    }
    if let Some(last) = run.shapes.last() {
        charts.push(line_shape(&sources, last.time));
        if out_of_plane(run) {
            charts.push(line_from_above(&sources, last.time));
            charts.push(line_from_ahead(&sources, last.time));
        }
    }
    charts.push(tension_profile(&sources));
    charts.push(curvature_profile(&sources));
    charts.push(moment_profile(&sources));
    charts.push(stiffness_profile(&sources));
    if let Some(from) = case.output.response_from_s {
        charts.push(rms_profile(&sources));
        charts.push(wave_amplitudes(&sources));
        charts.push(wavelengths(&sources));
        let maps = [
            ResponseMapKind::Steady,
            ResponseMapKind::Normalised,
            ResponseMapKind::Start,
        ];
        charts.extend(maps.map(|of| response_map(&sources, Some(from), of)));
    }
    let curves = published_curves(rows);
    charts.extend(curves.into_iter().filter(|chart| chart.series.len() > 1));
    charts.retain(shows_something);
    if charts.is_empty() {
        return;
    }
    page.heading("Charts");
    for (i, chart) in charts.iter().enumerate() {
        if i > 0 {
            page.line("");
        }
        let height = chart.map.as_ref().map_or(HEIGHT, |_| MAP_HEIGHT);
        page.block(&draw(chart, WIDTH, height, glyphs).to_text());
    }
}

/// Whether the line leaves the plane y = const by more than it is worth to look at.
fn out_of_plane(run: &Run) -> bool {
    let nodes = || run.shapes.iter().flat_map(|shape| &shape.nodes);
    let span = |axis: usize| {
        let reach = extent(nodes().map(|p| p[axis]));
        reach.map_or(0.0, |(low, high)| high - low)
    };
    span(1) > 1e-3 * (span(0) + span(2))
}

fn shows_something(chart: &Chart) -> bool {
    if chart.map.is_some() {
        return true;
    }
    let finite = |(x, y): &&(f64, f64)| x.is_finite() && y.is_finite();
    chart
        .series
        .iter()
        .any(|series| series.points.iter().filter(finite).count() > 1)
}
