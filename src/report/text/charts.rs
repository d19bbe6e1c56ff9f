//! The charts of a run in characters.

use super::layout::{Page, WIDTH};
use crate::{
    report::{
        chart::{Chart, Glyphs, draw, extent},
        figures::{
            Source, curvature_profile, deviation_in_time, line_from_above, line_from_ahead,
            line_shape, mean_load_in_time, moment_profile, payload_position, speed,
            stiffness_in_time, stiffness_profile, tension_profile, tensions, tilt, trajectory,
        },
    },
    run::Run,
};

/// Rows of a chart.
const HEIGHT: usize = 20;

/// Every chart that has something to show.
pub(super) fn all(page: &mut Page, run: &Run, glyphs: Glyphs) {
    let sources = [Source::whole(run, "")];
    let mut charts = Vec::new();
    if run.history.time.len() > 1 {
        charts.extend([
            tensions(&sources),
            payload_position(&sources),
            speed(&sources),
            tilt(&sources),
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
    charts.retain(shows_something);
    if charts.is_empty() {
        return;
    }
    page.heading("Charts");
    for (i, chart) in charts.iter().enumerate() {
        if i > 0 {
            page.line("");
        }
        page.block(&draw(chart, WIDTH, HEIGHT, glyphs).to_text());
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
    let finite = |(x, y): &&(f64, f64)| x.is_finite() && y.is_finite();
    chart
        .series
        .iter()
        .any(|series| series.points.iter().filter(finite).count() > 1)
}
