//! Rows as the table that screen, report and command line show.

use super::{Outcome, ValidationRow, note::note};
use crate::{
    case::{Direction, Provenance},
    report::{
        number::{Scale, digits, order, rounded},
        table::{Cell, CellInk, Column, Table},
    },
};

/// The validation table: quantity, outcome, published and computed value, its estimated numerical
/// error, difference, tolerance, provenance of the inputs. Row `n` of the table is row `n` of `rows` and
/// carries the number `[n+1]`; the note of that number gives the source of the
/// value, its basis and the reason of its outcome.
#[must_use]
pub fn table(rows: &[ValidationRow]) -> Table {
    Table {
        title: String::new(),
        columns: vec![
            Column::left("quantity"),
            Column::left("outcome"),
            Column::right("published"),
            Column::right("computed"),
            Column::right("error"),
            Column::right("difference"),
            Column::right("tolerance"),
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

fn cells(i: usize, row: &ValidationRow) -> Vec<Cell> {
    let name = Cell::plain(format!("[{}] {}", i + 1, row.name));
    let outcome = Cell::new(row.outcome.word(), ink(row.outcome));
    if let Some(line) = &row.trend {
        return vec![
            name,
            outcome,
            Cell::plain(expected(line.expect)),
            done(row.outcome),
        ];
    }
    let number = |value: Option<f64>, word: &dyn Fn(f64) -> String| match value {
        Some(value) => Cell::plain(word(value)),
        None => Cell::new("-", CellInk::Dim),
    };
    let unit = row.unit.as_str();
    let step = row.tolerance.unwrap_or(0.0) / 100.0;
    let error = match row.outcome {
        Outcome::NotRun => number(None, &|_| String::new()),
        _ if row.error.is_none() => Cell::new("unknown", CellInk::Warn),
        _ => number(row.error, &|error| significant(error, 2, unit)),
    };
    vec![
        name,
        outcome,
        number(row.published, &|value| significant(value, PRINTED, unit)),
        number(row.computed, &|value| to_step(value, step, unit)),
        error,
        number(row.difference, &|value| to_step(value, step, unit)),
        number(row.tolerance, &|value| significant(value, 3, unit)),
        inputs(row),
    ]
}

/// Published values are shown as they are printed.
const PRINTED: i32 = 12;

/// A number to so many digits, without trailing zeros.
fn significant(value: f64, count: i32, unit: &str) -> String {
    let scale = Scale::of(value, unit);
    with_unit(
        &digits(rounded_to(value / scale.factor, count), count),
        scale,
        unit,
    )
}

/// The digits beyond the count become zeros: 98.2 to 1 digit is 100.
fn rounded_to(value: f64, count: i32) -> f64 {
    if value.abs() > 0.0 {
        let step = 10_f64.powi(order(value) + 1 - count);
        (value / step).round() * step
    } else {
        value
    }
}

/// A number to the decimals that steps of this size need: a hundredth of the tolerance is not worth a
/// digit.
fn to_step(value: f64, step: f64, unit: &str) -> String {
    if value.abs() < 0.5 * step {
        return with_unit("0", Scale::of(0.0, unit), unit);
    }
    let scale = Scale::of(value, unit);
    let decimals = if step > 0.0 {
        -order(step / scale.factor)
    } else {
        6
    };
    with_unit(&rounded(value / scale.factor, decimals.max(0)), scale, unit)
}

fn with_unit(number: &str, scale: Scale, unit: &str) -> String {
    match (scale.exponent, unit) {
        (0, "" | "-") => number.to_owned(),
        (0, _) => format!("{number} {}", scale.unit(unit)),
        (power, "" | "-") => format!("{number}e{power}"),
        (power, _) => format!("{number}e{power} {unit}"),
    }
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

fn inputs(row: &ValidationRow) -> Cell {
    if row.fitted {
        return Cell::new("fitted", CellInk::Warn);
    }
    match row.inputs {
        None => Cell::plain(""),
        Some(standing @ (Provenance::Calibrated | Provenance::Assumed)) => {
            Cell::new(standing_word(standing), CellInk::Warn)
        }
        Some(standing) => Cell::plain(standing_word(standing)),
    }
}

/// The word of a case file for the provenance of an input.
#[must_use]
pub const fn standing_word(standing: Provenance) -> &'static str {
    match standing {
        Provenance::Published => "published",
        Provenance::Derived => "derived",
        Provenance::Calibrated => "calibrated",
        Provenance::Assumed => "assumed",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_carry_the_digits_that_matter() {
        assert_eq!(significant(1410.43, PRINTED, "m"), "1410.43 m");
        assert_eq!(significant(7.63e5, PRINTED, "N"), "763 kN");
        assert_eq!(significant(98.15, 1, "N"), "100 N");
        assert_eq!(significant(0.0, 2, "N"), "0 N");
        assert_eq!(significant(2.0, 3, "-"), "2");
        assert_eq!(to_step(1404.546, 0.015, "m"), "1404.55 m");
        assert_eq!(to_step(-145.6, 788.0, "N"), "0 N");
        assert_eq!(to_step(-2819.0, 788.0, "N"), "-2.8 kN");
        assert_eq!(to_step(1.960_8e6, 591.0, "N"), "1.9608 MN");
        assert_eq!(to_step(3e-7, 0.0, "m"), "300.000000e-9 m");
    }
}
