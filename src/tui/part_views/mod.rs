//! What the parts of the screen show that take more than drawing. Nothing here is called on the drawing thread: see
//! [`Part`].

pub mod line;
pub mod ropeway;
pub mod section;
pub mod ship;
pub mod system;

use super::state::DocumentContent;
use super::state::parts::{Part, PartView};
use crate::chart::Chart;
use crate::table::Table;

/// A part of a model.
#[must_use]
pub fn of_model(model: &DocumentContent, part: Part) -> PartView {
    match model {
        DocumentContent::Section(section) => section::view(section, part),
        DocumentContent::Ropeway(ropeway) => ropeway::view(ropeway, part),
        DocumentContent::Ship(ship) => ship::view(ship, part),
        DocumentContent::System(system) => system::view(system, part),
        DocumentContent::Line(_) => PartView::default(),
    }
}

/// A table alone, or below its chart.
fn with_table((chart, table): (Option<Chart>, Table)) -> PartView {
    PartView {
        chart,
        table,
        ..PartView::default()
    }
}

/// A chart alone.
fn with_chart(chart: Chart) -> PartView {
    PartView {
        chart: Some(chart),
        ..PartView::default()
    }
}
