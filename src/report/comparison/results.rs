//! The results of compared runs: values with their errors, difference, verdict.

use seacable_base::number::{percent, range, si, with_error};
use seacable_display::table::{Align, Cell, CellStyle, Table};
use seacable_runs::run::Quantity;
use seacable_studies::comparison::{Agreement, ComparedResult, Comparison, ResultChange, letter};

/// Every result with its error in each run, its difference from the first run and whether the error bars overlap; a row for each
/// run but the first. A difference has the digits that the errors of both results together support. `narrow` puts the verdict behind
/// the name, for less than some 110 columns.
#[must_use]
pub fn results_table(comparison: &Comparison, narrow: bool) -> Table {
    let runs = comparison.runs.len();
    let results = comparison.results.iter();
    let rows: Vec<(&ComparedResult, usize)> = results
        .flat_map(|result| (1..runs).map(move |run| (result, run)))
        .collect();
    let other = if runs == 2 { "B" } else { "other" };
    Table::of_records("", &rows)
        .text("quantity", |(result, run)| named(result, *run, narrow))
        .when(runs > 2, |table| table.text("run", |(_, run)| letter(*run)))
        .cell("A", Align::Decimal, |(result, run)| match run {
            1 => value(result.values[0].as_ref()),
            _ => Cell::default(),
        })
        .cell(other, Align::Decimal, |(result, run)| {
            value(result.values[*run].as_ref())
        })
        .cell(&format!("{other} - A"), Align::Right, |(result, run)| {
            absolute(result, *run)
        })
        .cell("by A", Align::Right, |(result, run)| relative(result, *run))
        .when(!narrow, |table| {
            table.cell("verdict", Align::Left, |(result, run)| {
                verdict(result, *run)
            })
        })
        .build()
}

/// The name of a result on the first of its rows; where there is no room for a column, with the verdict behind it.
fn named(result: &ComparedResult, run: usize, narrow: bool) -> String {
    let name = match run {
        1 => result.id.to_string(),
        _ => String::new(),
    };
    match result.changes[run].filter(|_| narrow) {
        Some(change) => format!("{name}: {}", change.agreement.words()),
        None => name,
    }
}

/// A result with its error; one without an estimate carries a question mark.
pub(crate) fn result_text(quantity: &Quantity) -> String {
    let unit = quantity.unit();
    match (quantity.unsettled, quantity.error_estimate()) {
        (Some([least, greatest]), _) => range(least, greatest, &unit),
        (None, Some(error)) if error > 0.0 => with_error(quantity.value, Some(error), &unit),
        (None, Some(_)) => format!("{} ± 0", si(quantity.value, &unit)),
        (None, None) => format!("{} ± ?", si(quantity.value, &unit)),
    }
}

fn value(quantity: Option<&Quantity>) -> Cell {
    quantity.map_or_else(
        || Cell::new("missing", CellStyle::Warn),
        |q| Cell::plain(result_text(q)),
    )
}

/// A difference with its error; one without an estimate carries a question mark.
pub(crate) fn change_text(change: &ResultChange, unit: &str) -> String {
    match change.error {
        Some(error) if error > 0.0 => with_error(change.absolute, Some(error), unit),
        Some(_) => si(change.absolute, unit),
        None => format!("{} ± ?", si(change.absolute, unit)),
    }
}

fn absolute(result: &ComparedResult, run: usize) -> Cell {
    let Some(change) = &result.changes[run] else {
        return Cell::none();
    };
    let words = change_text(change, &result.id.unit());
    let value = words.split(" ± ").next().unwrap_or(&words);
    Cell::plain(value)
}

fn relative(result: &ComparedResult, run: usize) -> Cell {
    let share = result.changes[run].and_then(|change| change.relative);
    share.map_or_else(Cell::none, |share| Cell::plain(percent(share)))
}

fn verdict(result: &ComparedResult, run: usize) -> Cell {
    result.changes[run].map_or_else(Cell::none, |change| agreement(change.agreement))
}

/// The words of a verdict in their style.
pub(crate) fn agreement(agreement: Agreement) -> Cell {
    let style = match agreement {
        Agreement::Differ => CellStyle::Bad,
        Agreement::NotSettled | Agreement::NoErrors => CellStyle::Warn,
        Agreement::WithinErrors | Agreement::Equal => CellStyle::Plain,
    };
    Cell::new(agreement.words(), style)
}
