//! Rows as the table that screen, report and command line show.

use super::{Outcome, RowKind, ValidationRow, note::note};
use crate::{
    case::{Direction, Provenance},
    number::{Scale, digits, order, rounded},
    table::{Align, Cell, CellStyle, Table},
};

/// The validation table: quantity, outcome, published and computed value, its estimated numerical
/// error, difference, tolerance, kind. Row `n` of the table is row `n` of `rows` and
/// carries the number `[n+1]`; the note of that number gives the source of the
/// value, its basis and the reason of its outcome.
#[must_use]
pub fn table(rows: &[ValidationRow]) -> Table {
    let numbered: Vec<(usize, &ValidationRow)> = (1..).zip(rows).collect();
    let notes = numbered.iter();
    let notes = notes.map(|(number, row)| format!("[{number}] {}", note(row)));
    Table::of_records("", &numbered)
        .text("quantity", |(number, row)| {
            format!("[{number}] {}", row.name)
        })
        .cell("outcome", Align::Left, |(_, row)| {
            Cell::new(row.outcome.word(), ink(row.outcome))
        })
        .cell("published", Align::Right, |(_, row)| match &row.trend {
            Some(line) => Cell::plain(expected(line.expect)),
            None => number(row, row.published, |v| significant(v, PRINTED, &row.unit)),
        })
        .cell("computed", Align::Right, |(_, row)| computed(row))
        .cell("error", Align::Right, |(_, row)| error(row))
        .cell("difference", Align::Right, |(_, row)| {
            number(row, row.difference, |v| to_step(v, row))
        })
        .cell("tolerance", Align::Right, |(_, row)| {
            number(row, row.tolerance, |v| significant(v, 3, &row.unit))
        })
        .cell("kind", Align::Left, |(_, row)| kind(row))
        .build()
        .noted(notes)
}

/// The computed number to the decimals that its tolerance needs; of a trend, whether it does as stated.
pub fn computed(row: &ValidationRow) -> Cell {
    match &row.trend {
        Some(_) => done(row.outcome),
        None => number(row, row.computed, |v| to_step(v, row)),
    }
}

/// The difference in percent of the published value; a dash where that is 0 or nothing was computed.
pub fn percent(row: &ValidationRow) -> Cell {
    let share = row
        .difference
        .zip(row.published)
        .filter(|(_, published)| *published != 0.0);
    let Some(percent) = share.map(|(difference, published)| 100.0 * difference / published.abs())
    else {
        return number(row, None, |_| String::new());
    };
    let decimals = match percent.abs() {
        0.0..0.1 => 3,
        0.1..10.0 => 2,
        10.0..100.0 => 1,
        _ => 0,
    };
    Cell::plain(format!("{percent:+.decimals$}"))
}

/// A number of a value; nothing for a trend.
fn number(row: &ValidationRow, value: Option<f64>, word: impl Fn(f64) -> String) -> Cell {
    match value {
        Some(value) => Cell::plain(word(value)),
        None if row.trend.is_some() => Cell::default(),
        None => Cell::none(),
    }
}

fn error(row: &ValidationRow) -> Cell {
    if row.outcome == Outcome::NotRun || row.computed.is_none() {
        return number(row, None, |_| String::new());
    }
    match row.error {
        None => Cell::new("unknown", CellStyle::Warn),
        error => number(row, error, |error| significant(error, 2, &row.unit)),
    }
}

/// Published values are shown as they are printed.
const PRINTED: i32 = 12;

/// A number to so many digits, without trailing zeros.
fn significant(value: f64, count: i32, unit: &str) -> String {
    let scale = Scale::of_magnitude(value, unit);
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

/// A number to the decimals that a hundredth of the tolerance needs.
fn to_step(value: f64, row: &ValidationRow) -> String {
    decimals_of_step(value, row.tolerance.unwrap_or(0.0) / 100.0, &row.unit)
}

fn decimals_of_step(value: f64, step: f64, unit: &str) -> String {
    if value.abs() < 0.5 * step {
        return with_unit("0", Scale::of_magnitude(0.0, unit), unit);
    }
    let scale = Scale::of_magnitude(value, unit);
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
        Outcome::Edited | Outcome::NotRun => Cell::none(),
    }
}

fn ink(outcome: Outcome) -> CellStyle {
    match outcome {
        Outcome::Pass => CellStyle::Good,
        Outcome::Fail => CellStyle::Bad,
        Outcome::Differs | Outcome::Edited => CellStyle::Warn,
        Outcome::NotRun => CellStyle::Dim,
    }
}

/// The kind of a row, with a star where an input behind it is not printed.
pub fn kind(row: &ValidationRow) -> Cell {
    let star = match row.inputs {
        Some(Provenance::Calibrated | Provenance::Assumed) => "*",
        _ => "",
    };
    let ink = match row.kind {
        RowKind::Fitted | RowKind::Echoed => CellStyle::Warn,
        _ => CellStyle::Plain,
    };
    Cell::new(format!("{}{star}", row.kind.word()), ink)
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
        assert_eq!(decimals_of_step(1404.546, 0.015, "m"), "1404.55 m");
        assert_eq!(decimals_of_step(-145.6, 788.0, "N"), "0 N");
        assert_eq!(decimals_of_step(-2819.0, 788.0, "N"), "-2.8 kN");
        assert_eq!(decimals_of_step(1.960_8e6, 591.0, "N"), "1.9608 MN");
        assert_eq!(decimals_of_step(3e-7, 0.0, "m"), "300.000000e-9 m");
    }
}
