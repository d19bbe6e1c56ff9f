//! Stored runs compared, as tables, charts and CSV.

mod charts;
mod csv;
mod results;
mod shapes;
mod tables;

pub use charts::{difference_chart, difference_curves};
pub use csv::csv;
pub(crate) use results::result_text;
pub use results::results_table;
pub use shapes::shapes;
pub use tables::{channels_table, cost_table, inputs_table, settings_table, validation_table};

use super::chart::Glyphs;
use super::table::Table;
use super::text::Page;
use crate::comparison::{Comparison, letter};
use crate::run::Run;

/// Columns from which the table of results has a column for the verdict.
const WIDE: usize = 110;

/// The comparison as text of so many columns.
#[must_use]
pub fn text(comparison: &Comparison, width: usize) -> String {
    let mut page = Page::new(width);
    let runs = comparison.runs.iter().enumerate();
    for (index, run) in runs {
        page.hanging(&format!("{}  ", letter(index)), &about(run));
    }
    body(&mut page, comparison);
    page.finish()
}

/// The charts of compared runs as text: shapes at a common time, then difference curves.
#[must_use]
pub fn charts(runs: &[&Run], width: usize, glyphs: Glyphs) -> String {
    let shapes = shapes(runs, width, glyphs);
    shapes + &difference_curves(runs, width, glyphs)
}

/// What a run is: its name, case, overrides.
fn about(run: &crate::run::RunInfo) -> String {
    let set = match run.overrides.is_empty() {
        true => String::new(),
        false => format!(" with {}", run.overrides.join(", ")),
    };
    format!("{}: {}{set}; {}", run.id, run.case_file, run.title)
}

/// All tables of a comparison, each under its heading.
pub(super) fn body(page: &mut Page, comparison: &Comparison) {
    for note in &comparison.notes {
        page.line("");
        page.hanging("* ", note);
    }
    let section = |page: &mut Page, heading: &str, table: &Table, without: &str| {
        if !table.rows.is_empty() {
            page.section(heading, table);
        } else if !without.is_empty() {
            page.heading(heading);
            page.paragraph(without);
        }
    };
    let inputs = inputs_table(comparison);
    section(page, "Inputs that differ", &inputs, "None.");
    let settings = settings_table(comparison);
    section(page, "Settings that differ", &settings, "None.");
    let results = results_table(comparison, page.width() < WIDE);
    section(page, "Results", &results, "No run has results.");
    page.line("");
    page.paragraph(&tally(comparison));
    let channels = channels_table(comparison);
    section(page, "Channels", &channels, "");
    let rows = validation_table(comparison);
    section(page, "Published values", &rows, "");
    page.section("Work and cost", &cost_table(comparison));
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

/// The report of a comparison under a heading of its own, to follow the report of its second run.
#[must_use]
pub fn report_section(comparison: &Comparison) -> String {
    let mut page = Page::default();
    page.title("Comparison");
    for (index, run) in comparison.runs.iter().enumerate() {
        page.hanging(&format!("{}  ", letter(index)), &about(run));
    }
    body(&mut page, comparison);
    page.finish()
}
