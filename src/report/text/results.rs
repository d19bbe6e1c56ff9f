//! The summary of a run: value beside value with the two parts of its error.

use super::WIDTH;
use crate::{
    chart::Glyphs,
    document::Report,
    nodes,
    number::{order, range, si, with_error},
    response,
    table::{Align, Cell, Table},
};
use seacable_model::case::Case;
use seacable_runs::run::{Quantity, Run, Subject};

/// Rows of the table of nodes in a report, about.
const NODES: usize = 40;

/// The summary table on 80 columns: value with its error, time error and mesh error.
#[must_use]
pub fn summary(run: &Run) -> String {
    let mut page = Report::default();
    add_summary(&mut page, run);
    page.to_text(WIDTH, Glyphs::Braille)
}

/// Adds the summary table.
pub(super) fn add_summary(page: &mut Report, run: &Run) {
    if run.summary.is_empty() {
        return page.paragraph("The run holds no results.");
    }
    let rows = grouped(&run.summary, run.history.time.len() <= 1);
    let estimated = run.summary.iter().any(|q| q.error_estimate().is_some());
    let table = Table::of_records("", &rows)
        .text("quantity", |row| row.name.as_str())
        .cell("value", Align::Decimal, |row| row.cell(value))
        .when(estimated, |table| {
            table
                .cell("time error", Align::Right, |row| {
                    row.cell(|q| match q.unsettled {
                        Some(_) => Cell::none(),
                        None => error(q.time_error, &q.unit()),
                    })
                })
                .cell("mesh error", Align::Right, |row| {
                    row.cell(|q| match q.unsettled {
                        Some(_) => Cell::plain("not settled"),
                        None => error(q.mesh_error, &q.unit()),
                    })
                })
        })
        .build();
    let note = (!estimated).then_some("Numerical errors were not estimated.");
    page.close_table(table.noted(note));
}

/// Peaks and valleys of the response, and the waves on the sections.
pub(super) fn answer(page: &mut Report, run: &Run, case: &Case) {
    if run.profile().rms.is_empty() {
        return;
    }
    let peaks = response::peaks(run.profile());
    page.section("Peaks and valleys of the response", peaks);
    let waves = response::waves(case, run.profile());
    if !waves.rows.is_empty() {
        page.section("Waves on the line", waves);
    }
}

/// The line node by node at the end of the run.
pub(super) fn nodes(page: &mut Report, run: &Run) {
    if !run.profile().nodes.is_empty() {
        let nodes = nodes::sampled(run.profile(), NODES);
        page.section("The line node by node", nodes);
    }
}

/// A row of the summary: a single number, or the heading of those of one channel.
struct SummaryRow<'a> {
    name: String,
    quantity: Option<&'a Quantity>,
}

impl SummaryRow<'_> {
    /// A cell of a number; an empty one in a heading.
    fn cell(&self, of: impl Fn(&Quantity) -> Cell) -> Cell {
        self.quantity.map_or_else(|| Cell::plain(""), of)
    }
}

/// Quantities by channel, in the order in which the channels come: below the heading `tension_n[wire|payload]` the rows
/// `.max` and `.mean(0..200)`, which together are the names in `summary.csv`. At rest a channel has one value, which is all of these.
fn grouped(quantities: &[Quantity], at_rest: bool) -> Vec<SummaryRow<'_>> {
    let mut groups: Vec<(String, Vec<SummaryRow<'_>>)> = Vec::new();
    for quantity in quantities {
        let (head, name) = match quantity.id.parts() {
            (subject @ (Subject::Channel(_) | Subject::ModeFrequency(..)), rest) => {
                (subject.to_string(), rest)
            }
            _ => (String::new(), quantity.name()),
        };
        let row = SummaryRow {
            name,
            quantity: Some(quantity),
        };
        match groups.iter_mut().find(|(known, _)| *known == head) {
            Some((_, group)) => group.push(row),
            None => groups.push((head, vec![row])),
        }
    }
    groups
        .into_iter()
        .flat_map(|(name, rows)| under_heading(name, rows, at_rest))
        .collect()
}

/// The rows of a channel below its name; at rest the name with its one value.
fn under_heading(
    name: String,
    mut rows: Vec<SummaryRow<'_>>,
    at_rest: bool,
) -> Vec<SummaryRow<'_>> {
    let alone = same_value(&rows).filter(|_| at_rest);
    let heading = SummaryRow {
        name,
        quantity: alone,
    };
    if alone.is_some() {
        return vec![heading];
    }
    rows.insert(0, heading);
    rows
}

/// The quantity that all rows of a channel are, where they have one value.
fn same_value<'a>(rows: &[SummaryRow<'a>]) -> Option<&'a Quantity> {
    let mut all = rows.iter().filter_map(|row| row.quantity);
    let first = all.next()?;
    let of_channel = matches!(first.id.parts().0, Subject::Channel(_));
    let same = |other: &Quantity| {
        other.value.to_bits() == first.value.to_bits() && other.unit() == first.unit()
    };
    (of_channel && all.all(same)).then_some(first)
}

fn value(quantity: &Quantity) -> Cell {
    if let Some([least, greatest]) = quantity.unsettled {
        return Cell::plain(range(least, greatest, &quantity.unit()));
    }
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
        None => Cell::none(),
    }
}
