//! A table, and a chart, as a part of the screen.

use crate::state::parts::PartView;
use crate::{chart::Chart, table::Table};

/// A table alone, or below its chart.
pub(super) fn with_table((chart, table): (Option<Chart>, Table)) -> PartView {
    PartView {
        chart,
        table,
        ..PartView::default()
    }
}

/// A chart alone.
pub(super) fn with_chart(chart: Chart) -> PartView {
    PartView {
        chart: Some(chart),
        ..PartView::default()
    }
}
