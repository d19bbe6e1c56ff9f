//! The sections of a line against what they must bear, as a table.

use super::number::{percent, rounded, si};
use super::table::{Cell, CellInk, Column, Table};
use crate::run::limits::LimitCheck;

/// The word that stands where a limit is exceeded.
pub const EXCEEDED: &str = "EXCEEDED";

/// One row a section: tension against breaking load, bending radius against the least allowed. Nothing where no
/// material states a limit.
#[must_use]
pub fn table(checks: &[LimitCheck]) -> Option<Table> {
    if checks.is_empty() {
        return None;
    }
    Some(Table {
        columns: vec![
            Column::left("section"),
            Column::decimal("greatest tension"),
            Column::decimal("at arc [m]"),
            Column::decimal("breaking load"),
            Column::decimal("used"),
            Column::decimal("least radius"),
            Column::decimal("at arc [m]"),
            Column::decimal("allowed"),
            Column::decimal("used"),
        ],
        rows: checks.iter().map(row).collect(),
        ..Table::default()
    })
}

fn row(check: &LimitCheck) -> Vec<Cell> {
    let quantity = |value: Option<f64>, unit| match value {
        Some(value) => Cell::plain(si(value, unit)),
        None => Cell::new("-", CellInk::Dim),
    };
    let place = |value: Option<f64>| match value {
        Some(arc) => Cell::plain(rounded(arc, 1)),
        None => Cell::new("-", CellInk::Dim),
    };
    vec![
        Cell::plain(check.section.as_str()),
        quantity(Some(check.tension.0), "N"),
        place(Some(check.tension.1)),
        quantity(check.break_load, "N"),
        used(check.tension_utilisation()),
        quantity(check.radius.map(|r| r.0), "m"),
        place(check.radius.map(|r| r.1)),
        quantity(check.least_radius, "m"),
        used(check.bending_utilisation()),
    ]
}

/// How much of a limit is used; more than all of it is said in words too.
fn used(share: Option<f64>) -> Cell {
    match share {
        None => Cell::new("-", CellInk::Dim),
        Some(share) if share > 1.0 => {
            Cell::new(format!("{} {EXCEEDED}", percent(share)), CellInk::Bad)
        }
        Some(share) => Cell::new(percent(share), CellInk::Good),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(tension: f64) -> LimitCheck {
        LimitCheck {
            section: "upper".to_owned(),
            material: "umbilical".to_owned(),
            tension: (tension, 220.0),
            break_load: Some(1.4e6),
            radius: Some((9.2, 48.0)),
            least_radius: None,
        }
    }

    #[test]
    fn what_is_exceeded_says_so() {
        let table = table(&[check(1.6e4), check(2.8e6)]).unwrap();
        assert_eq!(table.cell(0, 4).ink, CellInk::Good);
        assert_eq!(table.cell(1, 4).text, "200 % EXCEEDED");
        assert_eq!(table.cell(0, 8).text, "-");
        assert_eq!(super::table(&[]), None);
        assert_eq!(check(2.8e6).warnings().len(), 1);
        assert!(check(1.0).warnings().is_empty());
    }
}
