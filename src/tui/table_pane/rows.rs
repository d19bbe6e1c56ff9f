//! The rows and columns of a table as the user has it: filtered, sorted, without the columns that are hidden.

use std::cmp::Ordering;

use super::TablePane;
use crate::fuzzy::FuzzyFilter;
use crate::table::Table;

impl TablePane {
    /// Numbers of the rows in the order shown.
    pub(super) fn rows(&self, table: &Table) -> Vec<usize> {
        let mut rows = self.passing(table);
        let by = self.sort.as_ref();
        let by = by.and_then(|(head, down)| Some((self.place(table, head)?, *down)));
        if let Some((column, down)) = by {
            let text = |row: usize| table.cell(row, column).text;
            rows.sort_by(|a, b| {
                let order = compare(&text(*a), &text(*b));
                if down { order.reverse() } else { order }
            });
        }
        rows
    }

    /// Numbers of the rows that pass the filter.
    fn passing(&self, table: &Table) -> Vec<usize> {
        if self.filter.is_empty() {
            return (0..table.rows.len()).collect();
        }
        let cells =
            |row: usize| (0..table.columns.len()).map(move |column| table.cell(row, column).text);
        let lines: Vec<Vec<String>> = (0..table.rows.len())
            .map(|row| cells(row).collect())
            .collect();
        FuzzyFilter::new(self.filter.input.value()).places(&lines)
    }

    /// The table as it is shown.
    pub(super) fn as_shown(&self, table: &Table) -> Table {
        let columns = self.shown(table);
        let rows = self.rows(table);
        let cells = |row: &usize| {
            let row = &table.rows[*row];
            let own = columns
                .iter()
                .map(|column| row.get(*column).cloned().unwrap_or_default());
            own.collect()
        };
        let mut shown = Table {
            title: table.title.clone(),
            columns: columns
                .iter()
                .map(|place| table.columns[*place].clone())
                .collect(),
            rows: rows.iter().map(cells).collect(),
            notes: table.notes.clone(),
        };
        if let Some((head, down)) = &self.sort
            && let Some(column) = shown.columns.iter_mut().find(|column| column.head == *head)
        {
            column
                .head
                .push_str(if *down { " (down)" } else { " (up)" });
        }
        shown
    }
}

/// Numbers by their value and before words, words by their letters. A cell is a number when it
/// begins with one; a prefix of its unit counts.
fn compare(a: &str, b: &str) -> Ordering {
    match (number(a), number(b)) {
        (Some(a), Some(b)) => a.total_cmp(&b),
        (Some(_), None) => Ordering::Less,
        (None, Some(_)) => Ordering::Greater,
        (None, None) => a.to_lowercase().cmp(&b.to_lowercase()),
    }
}

/// The value of a cell such as `-1.96 MN ± 0.01`.
fn number(text: &str) -> Option<f64> {
    let mut words = text.split_whitespace();
    let value: f64 = words.next()?.parse().ok()?;
    let factor = match words.next() {
        Some("kN" | "kPa" | "kW" | "kJ") => 1e3,
        Some("MN" | "MPa" | "MW" | "MJ") => 1e6,
        Some("GN" | "GPa" | "GW" | "GJ") => 1e9,
        Some("ms") => 1e-3,
        _ => 1.0,
    };
    Some(value * factor)
}
