//! Stored runs compared, as a report of tables and charts, and as CSV.

mod charts;
mod csv;
mod results;
mod shapes;
mod tables;

pub use charts::{add_difference_curves, difference_chart};
pub use csv::csv;
pub(crate) use results::result_text;
pub use results::results_table;
pub use shapes::add_shapes;
pub use tables::{channels_table, cost_table, inputs_table, settings_table, validation_table};

use super::document::Report;
use super::table::Table;
use seacable_runs::run::Run;
use seacable_studies::comparison::{Comparison, letter};

/// Columns from which the table of results has a column for the verdict.
const WIDE: usize = 110;

/// Runs compared: what they are, the tables for pages of so many columns, then shapes at a common time and difference curves.
#[must_use]
pub fn report(comparison: &Comparison, runs: &[&Run], width: usize) -> Report {
    let mut page = tables(comparison, width);
    add_shapes(&mut page, runs);
    add_difference_curves(&mut page, runs);
    page
}

/// Adds a comparison to the report of its last run.
pub fn add(page: &mut Report, comparison: &Comparison, runs: &[&Run], width: usize) {
    page.gap();
    page.title("Comparison");
    page.append(report(comparison, runs, width));
}

/// What the runs are, and the tables of their comparison for pages of so many columns.
#[must_use]
pub fn tables(comparison: &Comparison, width: usize) -> Report {
    let mut page = Report::default();
    for (index, run) in comparison.runs.iter().enumerate() {
        page.item(&format!("{}  ", letter(index)), &about(run));
    }
    body(&mut page, comparison, width);
    page
}

/// What a run is: its name, case, overrides.
fn about(run: &seacable_runs::run::RunInfo) -> String {
    let set = match run.overrides.is_empty() {
        true => String::new(),
        false => format!(" with {}", run.overrides.join(", ")),
    };
    format!("{}: {}{set}; {}", run.id, run.case_file, run.title)
}

/// All tables of a comparison, each under its heading.
fn body(page: &mut Report, comparison: &Comparison, width: usize) {
    for note in &comparison.notes {
        page.gap();
        page.item("* ", note);
    }
    let section = |page: &mut Report, heading: &str, table: Table, without: &str| {
        if !table.rows.is_empty() {
            page.section(heading, table);
        } else if !without.is_empty() {
            page.heading(heading);
            page.paragraph(without);
        }
    };
    let inputs = inputs_table(comparison);
    section(page, "Inputs that differ", inputs, "None.");
    let settings = settings_table(comparison);
    section(page, "Settings that differ", settings, "None.");
    let results = results_table(comparison, width < WIDE);
    section(page, "Results", results, "No run has results.");
    page.gap();
    page.paragraph(&tally(comparison));
    let channels = channels_table(comparison);
    section(page, "Channels", channels, "");
    let rows = validation_table(comparison);
    section(page, "Published values", rows, "");
    page.section("Work and cost", cost_table(comparison));
}

/// How many results differ.
fn tally(comparison: &Comparison) -> String {
    let counts = comparison.tally();
    let total: usize = counts.iter().map(|(_, count)| count).sum();
    let each: Vec<String> = counts
        .iter()
        .map(|(agreement, count)| format!("{count} {}", agreement.words()))
        .collect();
    if total == 0 {
        return "No two runs have a result in common.".to_owned();
    }
    format!(
        "Of {total} comparisons with A: {}. Results differ where their error bars do not overlap; the error of a difference is that \
         of both results together.",
        each.join(", ")
    )
}
