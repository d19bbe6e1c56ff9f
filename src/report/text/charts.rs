//! The charts of a run in characters.

use super::layout::{Page, WIDTH};
use crate::{
    report::{
        chart::{Chart, Glyphs, draw},
        figures::{Source, line_shape, payload_position, tension_profile, tensions, trajectory},
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
            trajectory(&sources, None),
        ]);
    }
    if let Some(last) = run.shapes.last() {
        charts.push(line_shape(&sources, last.time));
    }
    charts.push(tension_profile(&sources));
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

fn shows_something(chart: &Chart) -> bool {
    let finite = |(x, y): &&(f64, f64)| x.is_finite() && y.is_finite();
    chart
        .series
        .iter()
        .any(|series| series.points.iter().filter(finite).count() > 1)
}
