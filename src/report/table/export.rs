//! Tables for spreadsheets.

use std::io::Write;

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

#[cfg(test)]
mod tests {
    use crate::report::table::{Cell, Column, Table};

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
}
