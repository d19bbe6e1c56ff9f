//! Tables from a description of their columns: heading, format, and how a cell is read from a record.
//!
//! ```
//! use seacable_display::table::{NumberFormat, Table};
//!
//! let joints = [("vessel|chain", 3.94e6, Some(0.41)), ("wire|payload", 1.9e6, None)];
//! let table = Table::of_records("Joints", &joints)
//!     .text("joint", |joint| joint.0)
//!     .number("tension", NumberFormat::Si("N"), |joint| joint.1)
//!     .number("of breaking load", NumberFormat::Percent, |joint| joint.2)
//!     .build();
//! assert_eq!(table.cell(1, 1).text, "1.9 MN");
//! assert_eq!(table.cell(1, 2).text, "-");
//! ```

use super::{Align, Cell, CellStyle, Column, Table};
use crate::number::{digits, percent, rounded, si};

/// How a number is written, with its unit.
#[derive(Debug, Clone, Copy)]
pub enum NumberFormat {
    /// Four significant digits with an engineering prefix where the unit takes one: `1.961 MN`.
    Si(&'static str),
    /// So many significant digits without trailing zeros.
    Digits(i32, &'static str),
    /// So many decimals.
    Decimals(i32, &'static str),
    /// A fraction as a percentage.
    Percent,
    /// By a function.
    With(fn(f64) -> String),
}

impl NumberFormat {
    /// The number as text.
    #[must_use]
    pub fn write(self, value: f64) -> String {
        let (number, unit) = match self {
            Self::Si(unit) => return si(value, unit),
            Self::Percent => return percent(value),
            Self::With(write) => return write(value),
            Self::Digits(count, unit) => (digits(value, count), unit),
            Self::Decimals(count, unit) => (rounded(value, count), unit),
        };
        match unit {
            "" => number,
            unit => format!("{number} {unit}"),
        }
    }

    /// The cell of a number; a dim dash for none.
    #[must_use]
    pub fn cell(self, value: Option<f64>) -> Cell {
        value.map_or_else(Cell::none, |value| Cell::plain(self.write(value)))
    }
}

impl Cell {
    /// The cell of a missing value: a dim dash.
    #[must_use]
    pub fn none() -> Self {
        Self::new("-", CellStyle::Dim)
    }

    /// A cell marked bad where a condition holds, plain elsewhere.
    #[must_use]
    pub fn bad_if(bad: bool, text: impl Into<String>) -> Self {
        Self::new(
            text,
            if bad {
                CellStyle::Bad
            } else {
                CellStyle::Plain
            },
        )
    }
}

/// A table under construction with a record a row.
#[derive(Debug, Clone)]
pub struct Columns<'a, R> {
    records: &'a [R],
    table: Table,
}

/// A table under construction with a record a column and a quantity a row.
#[derive(Debug, Clone)]
pub struct ComparisonTable<R> {
    records: Vec<Option<R>>,
    table: Table,
}

impl Table {
    /// A title alone, in the place of a table that there is no result for, or with notes to follow.
    #[must_use]
    pub fn titled(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            ..Self::default()
        }
    }

    /// A table of records, one a row; the columns follow.
    #[must_use]
    pub fn of_records<R>(title: impl Into<String>, records: &[R]) -> Columns<'_, R> {
        let table = Self {
            rows: vec![Vec::new(); records.len()],
            ..Self::titled(title)
        };
        Columns { records, table }
    }

    /// A table of records, one a column under its heading, with quantities as rows, which follow. `corner` heads the names
    /// of the quantities. A missing record has a dash in every row.
    #[must_use]
    pub fn compare<R: Copy>(
        title: impl Into<String>,
        corner: &str,
        records: &[(&str, Option<R>)],
    ) -> ComparisonTable<R> {
        let mut columns = vec![Column::left(corner)];
        columns.extend(records.iter().map(|(head, _)| Column::decimal(head)));
        ComparisonTable {
            records: records.iter().map(|(_, record)| *record).collect(),
            table: Self {
                columns,
                ..Self::titled(title)
            },
        }
    }

    /// The table with these sentences below.
    #[must_use]
    pub fn noted<S: Into<String>>(mut self, notes: impl IntoIterator<Item = S>) -> Self {
        self.notes.extend(notes.into_iter().map(Into::into));
        self
    }
}

impl<'a, R> Columns<'a, R> {
    /// A column of cells of any kind.
    #[must_use]
    pub fn cell(mut self, head: &str, align: Align, read: impl Fn(&'a R) -> Cell) -> Self {
        self.table.columns.push(Column::new(head, align));
        for (row, record) in self.table.rows.iter_mut().zip(self.records) {
            row.push(read(record));
        }
        self
    }

    /// A column of words.
    #[must_use]
    pub fn text<T: Into<String>>(self, head: &str, read: impl Fn(&'a R) -> T) -> Self {
        self.cell(head, Align::Left, |record| Cell::plain(read(record)))
    }

    /// A column of counts, right-aligned.
    #[must_use]
    pub fn count<T: ToString>(self, head: &str, read: impl Fn(&'a R) -> T) -> Self {
        self.cell(head, Align::Right, |record| {
            Cell::plain(read(record).to_string())
        })
    }

    /// A column of numbers aligned at their decimal points; a dash where there is none.
    #[must_use]
    pub fn number<N: Into<Option<f64>>>(
        self,
        head: &str,
        format: NumberFormat,
        read: impl Fn(&'a R) -> N,
    ) -> Self {
        self.cell(head, Align::Decimal, |record| {
            format.cell(read(record).into())
        })
    }

    /// The columns that a condition adds.
    #[must_use]
    pub fn when(self, condition: bool, columns: impl FnOnce(Self) -> Self) -> Self {
        if condition { columns(self) } else { self }
    }

    /// The table.
    #[must_use]
    pub fn build(self) -> Table {
        self.table
    }
}

impl<R: Copy> ComparisonTable<R> {
    /// A quantity read from each of the records, a dash where there is none.
    #[must_use]
    pub fn number<N: Into<Option<f64>>>(
        mut self,
        name: &str,
        format: NumberFormat,
        read: impl Fn(R) -> N,
    ) -> Self {
        let cells = self.records.iter();
        let cells = cells.map(|record| format.cell(record.and_then(|r| read(r).into())));
        let row = [Cell::plain(name)].into_iter().chain(cells);
        self.table.rows.push(row.collect());
        self
    }

    /// The quantities that a condition adds.
    #[must_use]
    pub fn when(self, condition: bool, quantities: impl FnOnce(Self) -> Self) -> Self {
        if condition { quantities(self) } else { self }
    }

    /// The table.
    #[must_use]
    pub fn build(self) -> Table {
        self.table
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_a_row_with_columns_that_a_condition_adds() {
        let table = |errors: bool| {
            Table::of_records("Modes", &[1.5, 2.0])
                .count("mode", |hz| *hz)
                .number("period", NumberFormat::Digits(3, "s"), |hz| 1.0 / hz)
                .when(errors, |columns| {
                    columns.number("error", NumberFormat::Percent, |hz| {
                        (*hz > 1.8).then_some(0.01)
                    })
                })
                .build()
        };
        assert_eq!(table(false).columns.len(), 2);
        assert_eq!(table(true).rows[0][1].text, "0.667 s");
        assert_eq!(table(true).rows[0][2], Cell::none());
        assert_eq!(table(true).rows[1][2].text, "1.00 %");
    }

    #[test]
    fn a_record_a_column() {
        let table = Table::compare("Rope", "", &[("fast", Some(2e3)), ("kept", None)])
            .number("tension", NumberFormat::Si("N"), |n| n)
            .when(true, |t| {
                t.number("half", NumberFormat::Decimals(2, "N"), |n| n / 2.0)
            })
            .build();
        let texts = |row: usize| [1, 2].map(|column| table.cell(row, column).text);
        assert_eq!(texts(0), ["2 kN", "-"]);
        assert_eq!(texts(1), ["1000.00 N", "-"]);
    }
}
