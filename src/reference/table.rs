//! Rows as the table that screen, report and command line show.

use super::{Outcome, Row, note::note};
use crate::{
    case::{Direction, Standing},
    report::{
        number::si,
        table::{Cell, CellInk, Column, Table},
    },
};

/// The validation table: quantity, outcome, published and computed value, its estimated numerical
/// error, difference, tolerance, standing of the inputs. Row `n` of the table is row `n` of `rows` and
/// carries the number `[n+1]`; the note of that number says where the value is printed, what stands
/// behind it and why it is as it is.
#[must_use]
pub fn table(rows: &[Row]) -> Table {
    Table {
        title: String::new(),
        columns: vec![
            Column::left("quantity"),
            Column::left("outcome"),
            Column::decimal("published"),
            Column::decimal("computed"),
            Column::decimal("error"),
            Column::decimal("difference"),
            Column::decimal("tolerance"),
            Column::left("inputs"),
        ],
        rows: rows
            .iter()
            .enumerate()
            .map(|(i, row)| cells(i, row))
            .collect(),
        notes: rows
            .iter()
            .enumerate()
            .map(|(i, row)| format!("[{}] {}", i + 1, note(row)))
            .collect(),
    }
}

fn cells(i: usize, row: &Row) -> Vec<Cell> {
    let number = |value: Option<f64>, absent: &str| match value {
        Some(value) => Cell::plain(si(value, &row.unit)),
        None => Cell::new(absent, CellInk::Dim),
    };
    let (published, computed, error) = match &row.trend {
        Some(line) => (
            Cell::plain(expected(line.expect)),
            done(row.outcome),
            number(None, ""),
        ),
        None => (
            number(row.published, "-"),
            number(row.computed, "-"),
            number(row.error, "unknown"),
        ),
    };
    vec![
        Cell::plain(format!("[{}] {}", i + 1, row.name)),
        Cell::new(row.outcome.word(), ink(row.outcome)),
        published,
        computed,
        if row.outcome == Outcome::NotRun {
            number(None, "-")
        } else {
            error
        },
        number(row.difference, if row.trend.is_some() { "" } else { "-" }),
        number(row.tolerance, if row.trend.is_some() { "" } else { "-" }),
        inputs(row),
    ]
}

fn expected(direction: Direction) -> &'static str {
    match direction {
        Direction::Rises => "rises",
        Direction::Falls => "falls",
    }
}

fn done(outcome: Outcome) -> Cell {
    match outcome {
        Outcome::Pass => Cell::plain("it does"),
        Outcome::Fail | Outcome::Differs => Cell::plain("it does not"),
        Outcome::NotRun => Cell::new("-", CellInk::Dim),
    }
}

fn ink(outcome: Outcome) -> CellInk {
    match outcome {
        Outcome::Pass => CellInk::Good,
        Outcome::Fail => CellInk::Bad,
        Outcome::Differs => CellInk::Warn,
        Outcome::NotRun => CellInk::Dim,
    }
}

fn inputs(row: &Row) -> Cell {
    if row.fitted {
        return Cell::new("fitted", CellInk::Warn);
    }
    match row.inputs {
        None => Cell::plain(""),
        Some(standing @ (Standing::Calibrated | Standing::Assumed)) => {
            Cell::new(standing_word(standing), CellInk::Warn)
        }
        Some(standing) => Cell::plain(standing_word(standing)),
    }
}

/// The word a case file uses for a standing.
#[must_use]
pub const fn standing_word(standing: Standing) -> &'static str {
    match standing {
        Standing::Published => "published",
        Standing::Derived => "derived",
        Standing::Calibrated => "calibrated",
        Standing::Assumed => "assumed",
    }
}
