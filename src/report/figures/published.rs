//! Published curves laid over what a run gives.

use seacable_display::chart::{Axis, Chart, Series};
use seacable_runs::reference::ValidationRow;

/// A chart for every published curve among the rows of a validation table: the curve at the times of the run, over the run.
#[must_use]
pub fn published_curves(rows: &[ValidationRow]) -> Vec<Chart> {
    rows.iter().filter_map(chart).collect()
}

fn chart(row: &ValidationRow) -> Option<Chart> {
    let overlay = row.overlay.as_ref()?;
    let mut series = vec![Series::new("published", 0, overlay.published.clone())];
    if !overlay.computed.is_empty() {
        series.insert(0, Series::new("computed", 1, overlay.computed.clone()));
    }
    let y = Axis::new(&overlay.channel.to_string(), overlay.unit);
    Some(Chart::new(&row.name, Axis::new("time", "s"), y, series))
}
