//! Tables for spreadsheets.

use std::io::Write;

use serde_json::Value;

use super::Table;

impl Table {
    /// Writes heads and rows as CSV (RFC 4180); title and notes are left out.
    ///
    /// # Errors
    /// When the writer fails.
    pub fn write_csv(&self, to: impl Write) -> Result<(), csv::Error> {
        let mut writer = csv::Writer::from_writer(to);
        writer.write_record(self.columns.iter().map(|column| &column.head))?;
        for row in 0..self.rows.len() {
            let cells = (0..self.columns.len()).map(|column| self.cell(row, column).text);
            writer.write_record(cells)?;
        }
        writer.flush()?;
        Ok(())
    }
}

impl Table {
    /// The rows as JSON objects by the heads of the columns: cells that are numbers as numbers, empty ones as null.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let value = |text: String| match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Value::from(number),
            _ if text.is_empty() => Value::Null,
            _ => Value::from(text),
        };
        let row = |row: usize| {
            let cells = self.columns.iter().enumerate();
            let cells =
                cells.map(|(column, of)| (of.head.clone(), value(self.cell(row, column).text)));
            Value::Object(cells.collect())
        };
        (0..self.rows.len()).map(row).collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::table::{Cell, Column, Table};

    #[test]
    fn commas_and_quotes_are_quoted_and_short_rows_filled() {
        let table = Table {
            columns: vec![Column::left("what"), Column::right("how much")],
            rows: vec![
                vec![Cell::plain("a, \"b\""), Cell::plain("1.5 m")],
                vec![Cell::plain("c")],
            ],
            ..Table::default()
        };
        let mut out = Vec::new();
        table.write_csv(&mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        assert_eq!(text, "what,how much\n\"a, \"\"b\"\"\",1.5 m\nc,\n");
    }

    #[test]
    fn numbers_are_numbers_in_json_and_empty_cells_null() {
        let table = Table {
            columns: vec![Column::left("what"), Column::right("length [m]")],
            rows: vec![
                vec![Cell::plain("a"), Cell::plain("1.5e-3")],
                vec![Cell::plain("nan")],
            ],
            ..Table::default()
        };
        let wanted = serde_json::json!([
            {"what": "a", "length [m]": 0.0015},
            {"what": "nan", "length [m]": null},
        ]);
        assert_eq!(table.to_json(), wanted);
    }
}
