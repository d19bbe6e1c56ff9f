//! The summary of a run: value beside value with the two parts of its error.

use super::layout::{Page, WIDTH};
use crate::{
    case::Case,
    report::{
        limits as limits_table, nodes as nodes_table,
        number::{order, si, with_error},
        response,
        table::{Cell, CellInk, Column, Table},
    },
    run::{Quantity, Run, Subject, limits::check},
};

/// Rows of the table of nodes in a report, about.
const NODES: usize = 40;

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

/// The sections against their breaking load and least bending radius, on 80 columns; nothing where the case states
/// neither.
#[must_use]
pub fn limits(run: &Run, case: &Case) -> Option<String> {
    let table = limits_table::table(&check(case, &run.profile))?;
    Some(table.to_text(WIDTH))
}

/// Peaks and valleys of the response, and the waves on the sections.
pub(super) fn answer(page: &mut Page, run: &Run, case: &Case) {
    if run.profile.rms.is_empty() {
        return;
    }
    page.heading("Peaks and valleys of the response");
    page.block(&response::peaks(&run.profile).to_text(WIDTH));
    let waves = response::waves(case, &run.profile);
    if !waves.rows.is_empty() {
        page.heading("Waves on the line");
        page.block(&waves.to_text(WIDTH));
    }
}

/// The line node by node at the end of the run.
pub(super) fn nodes(page: &mut Page, run: &Run) {
    if !run.profile.nodes.is_empty() {
        page.heading("The line node by node");
        page.block(&nodes_table::thinned(&run.profile, NODES).to_text(WIDTH));
    }
}

fn with_errors(quantities: &[Quantity]) -> Table {
    let rows = grouped(quantities)
        .into_iter()
        .flat_map(|(channel, of_channel)| {
            let head = vec![Cell::plain(channel)];
            let cells = of_channel.into_iter().map(|(statistic, q)| {
                vec![
                    Cell::plain(statistic),
                    value(q),
                    error(q.time_error, &q.unit()),
                    error(q.mesh_error, &q.unit()),
                ]
            });
            std::iter::once(head).chain(cells).collect::<Vec<_>>()
        });
    Table {
        columns: vec![
            Column::left("quantity"),
            Column::decimal("value"),
            Column::right("time error"),
            Column::right("mesh error"),
        ],
        rows: rows.collect(),
        ..Table::default()
    }
}

/// Quantities by channel, in the order in which the channels come: `tension_n[wire|payload]` with
/// `.max`, `.mean(0..200)`, which together are the name in `summary.csv`.
fn grouped(quantities: &[Quantity]) -> Vec<(String, Vec<(String, &Quantity)>)> {
    let mut groups: Vec<(String, Vec<(String, &Quantity)>)> = Vec::new();
    for quantity in quantities {
        let (head, row) = match quantity.id.parts() {
            (subject @ (Subject::Channel(_) | Subject::ModeFrequency(..)), rest) => {
                (subject.to_string(), rest)
            }
            _ => (String::new(), quantity.name()),
        };
        match groups.iter_mut().find(|(known, _)| *known == head) {
            Some((_, group)) => group.push((row, quantity)),
            None => groups.push((head, vec![(row, quantity)])),
        }
    }
    groups
}

fn value(quantity: &Quantity) -> Cell {
    let error = quantity.error_estimate().filter(|error| *error > 0.0);
    Cell::plain(match error {
        Some(_) => with_error(quantity.value, error, &quantity.unit()),
        None => si(quantity.value, &quantity.unit()),
    })
}

/// An estimate is good for two digits.
fn error(error: Option<f64>, unit: &str) -> Cell {
    match error {
        Some(error) if error > 0.0 => {
            let digit = 10_f64.powi(order(error) - 1);
            Cell::plain(si((error / digit).round() * digit, unit))
        }
        Some(error) => Cell::plain(si(error, unit)),
        None => Cell::new("-", CellInk::Dim),
    }
}

fn bare(quantities: &[Quantity]) -> Table {
    let rows = grouped(quantities)
        .into_iter()
        .flat_map(|(channel, of_channel)| {
            let cells = of_channel.into_iter().map(|(statistic, q)| {
                vec![Cell::plain(statistic), Cell::plain(si(q.value, &q.unit()))]
            });
            std::iter::once(vec![Cell::plain(channel)])
                .chain(cells)
                .collect::<Vec<_>>()
        });
    Table {
        columns: vec![Column::left("quantity"), Column::decimal("value")],
        rows: rows.collect(),
        notes: vec!["Numerical errors were not estimated.".to_owned()],
        ..Table::default()
    }
}
