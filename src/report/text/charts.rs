//! The charts of a run.

use crate::{document::Report, figures::report_figures};
use seacable_model::case::Case;
use seacable_runs::reference::ValidationRow;
use seacable_runs::run::Run;

/// Rows of a chart.
const HEIGHT: usize = 20;
/// Rows of a map, whose stripes need them.
const MAP_HEIGHT: usize = 30;

/// Every chart that has something to show; of the rows of its case, the published curves.
pub(super) fn all(page: &mut Report, run: &Run, case: &Case, rows: &[ValidationRow]) {
    let charts = report_figures(run, case, rows);
    if charts.is_empty() {
        return;
    }
    page.heading("Charts");
    for (i, chart) in charts.into_iter().enumerate() {
        if i > 0 {
            page.gap();
        }
        let height = chart.map.as_ref().map_or(HEIGHT, |_| MAP_HEIGHT);
        page.close_chart(chart, height);
    }
}
