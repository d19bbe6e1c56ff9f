//! The summary of a run: value beside value with the two parts of its error.

use super::layout::WIDTH;
use crate::{
    report::{
        number::{si, with_error},
        table::{Cell, CellInk, Column, Table},
    },
    run::{Quantity, Run},
};

/// The summary table on 80 columns: value with its error, time error and mesh error.
#[must_use]
pub fn summary(run: &Run) -> String {
    if run.summary.is_empty() {
        return "The run holds no results.\n".to_owned();
    }
    let estimated = run.summary.iter().any(|q| q.error_estimate().is_some());
    let table = if estimated {
        with_errors(&run.summary)
    } else {
        bare(&run.summary)
    };
    table.to_text(WIDTH)
}

fn with_errors(quantities: &[Quantity]) -> Table {
    let error = |error: Option<f64>, unit: &str| match error {
        Some(error) => Cell::plain(si(error, unit)),
        None => Cell::new("-", CellInk::Dim),
    };
    let rows = quantities.iter().map(|q| {
        vec![
            Cell::plain(&q.name),
            Cell::plain(match q.error_estimate() {
                Some(error) => with_error(q.value, Some(error), &q.unit),
                None => si(q.value, &q.unit),
            }),
            error(q.time_error, &q.unit),
            error(q.mesh_error, &q.unit),
        ]
    });
    Table {
        columns: vec![
            Column::left("quantity"),
            Column::decimal("value"),
            Column::decimal("time error"),
            Column::decimal("mesh error"),
        ],
        rows: rows.collect(),
        ..Table::default()
    }
}

fn bare(quantities: &[Quantity]) -> Table {
    let rows = quantities
        .iter()
        .map(|q| vec![Cell::plain(&q.name), Cell::plain(si(q.value, &q.unit))]);
    Table {
        columns: vec![Column::left("quantity"), Column::decimal("value")],
        rows: rows.collect(),
        notes: vec!["Numerical errors were not estimated.".to_owned()],
        ..Table::default()
    }
}
