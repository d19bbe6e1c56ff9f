//! The results of a report as CSV, every digit kept where there are numbers.

use super::{ReportSubject, RunSubject};
use crate::comparison;
use crate::document::{Block, Report};
use seacable_display::table::{Align, Cell, Table};
use seacable_model::case::{Diagnostic, Subject};
use seacable_runs::run::{Quantity, Run};
use seacable_studies::comparison::Comparison;

/// The file of a run's directory that has the record of a channel.
const RECORD: &str = "history.csv";

type Made<'m> = &'m dyn Fn() -> Result<Report, Vec<Diagnostic>>;

impl ReportSubject<'_> {
    /// The results as CSV: of a run a row a result, with another run a row an item and run; of a sweep a row a load case; of other
    /// files a row a cell of their tables.
    pub(super) fn to_csv(&self, report: Made<'_>) -> Result<String, Vec<Diagnostic>> {
        Ok(match self {
            Self::Run(RunSubject {
                run,
                against: Some(other),
                ..
            }) => {
                // Writing to memory does not fail.
                let bytes =
                    comparison::csv(&Comparison::of_runs(&[other, run])).unwrap_or_default();
                String::from_utf8_lossy(&bytes).into_owned()
            }
            Self::Run(subject) => written(&results(subject.run)),
            Self::Sweep(sweep) => written(&sweep.view.csv_table()),
            _ => written(&cells(&report()?)),
        })
    }
}

fn written(table: &Table) -> String {
    let mut text = Vec::new();
    // Writing to memory does not fail.
    let _ = table.write_csv(&mut text);
    String::from_utf8_lossy(&text).into_owned()
}

/// A row a result: value, unit, errors, and the file in which the record stands that it is of.
fn results(run: &Run) -> Table {
    let number =
        |value: Option<f64>| Cell::plain(value.map_or_else(String::new, |v| v.to_string()));
    let in_time = run.history.time.len() > 1;
    let unsettled = |end: usize| move |q: &Quantity| number(q.unsettled.map(|range| range[end]));
    Table::of_records("", &run.summary)
        .text("quantity", Quantity::name)
        .cell("value", Align::Right, |q| number(Some(q.value)))
        .text("unit", Quantity::unit)
        .cell("error", Align::Right, |q| number(q.error_estimate()))
        .cell("time_error", Align::Right, |q| number(q.time_error))
        .cell("mesh_error", Align::Right, |q| number(q.mesh_error))
        .cell("least_if_not_settled", Align::Right, unsettled(0))
        .cell("greatest_if_not_settled", Align::Right, unsettled(1))
        .text("record", |q| match q.id.parts().0 {
            Subject::Channel(_) if in_time => RECORD,
            _ => "",
        })
        .build()
}

/// The cells of all tables of a report, a row a cell.
fn cells(report: &Report) -> Table {
    let mut all: Vec<[String; 4]> = Vec::new();
    let mut heading = String::new();
    for block in report.blocks() {
        match block {
            Block::Heading(words) => heading.clone_from(words),
            Block::Table(table) => {
                let title = if table.title.is_empty() {
                    &heading
                } else {
                    &table.title
                };
                all.extend(of_table(title, table));
            }
            _ => {}
        }
    }
    Table::of_records("", &all)
        .text("table", |row| row[0].clone())
        .text("row", |row| row[1].clone())
        .text("column", |row| row[2].clone())
        .text("value", |row| row[3].clone())
        .build()
}

/// The cells of a table, named by the first cell of their row and the head of their column.
fn of_table<'t>(title: &'t str, table: &'t Table) -> impl Iterator<Item = [String; 4]> + 't {
    (0..table.rows.len()).flat_map(move |row| {
        let name = table.cell(row, 0).text;
        let columns = table.columns.iter().enumerate().skip(1);
        columns.map(move |(column, of)| {
            let value = table.cell(row, column).text;
            [title.to_owned(), name.clone(), of.head.clone(), value]
        })
    })
}
