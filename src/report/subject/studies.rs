//! Studies beside a report: hard cases, speed against error. They are included where they were run, and it is said where they were not.

use crate::document::Report;
use seacable_display::table::Table;

/// A table of a study that was run.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyTable {
    /// What it is of, or the file that it was read from.
    pub name: String,
    /// The table.
    pub table: Table,
}

impl StudyTable {
    /// A table that a study wrote as CSV.
    ///
    /// # Errors
    /// It is no CSV, or has no heads, in words.
    pub fn of_csv(name: &str, text: &str) -> Result<Self, String> {
        use seacable_display::table::{Cell, Column};
        let mut reader = csv::ReaderBuilder::new()
            .flexible(true)
            .from_reader(text.as_bytes());
        let heads = reader.headers().map_err(|error| error.to_string())?;
        let columns: Vec<Column> = heads.iter().map(Column::left).collect();
        if columns.iter().all(|column| column.head.trim().is_empty()) {
            return Err("it has no heads of columns".to_owned());
        }
        let rows = reader.records().map(|record| {
            let record = record.map_err(|error| error.to_string())?;
            Ok(record.iter().map(Cell::plain).collect())
        });
        let table = Table {
            columns,
            rows: rows.collect::<Result<_, String>>()?,
            ..Table::default()
        };
        Ok(Self {
            name: name.to_owned(),
            table,
        })
    }
}

const NOT_RUN: &str = "\
No table of hard cases (`seacable study hard-cases`) or of speed against error (`seacable study speed`) is included, because none was run \
for this report. `seacable report --study FILE.csv` includes one that a study wrote.";

/// Adds the tables of studies; says of a kind that has such studies where none were run.
pub(super) fn add(report: &mut Report, studies: &[StudyTable], has_trials: bool) {
    if studies.is_empty() && !has_trials {
        return;
    }
    report.heading("Studies");
    if studies.is_empty() {
        return report.paragraph(NOT_RUN);
    }
    for (number, study) in studies.iter().enumerate() {
        if number > 0 {
            report.gap();
        }
        report.paragraph(&study.name);
        report.table(study.table.clone());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seacable_display::chart::Glyphs;

    #[test]
    fn what_was_not_run_is_said() {
        let mut report = Report::default();
        add(&mut report, &[], false);
        assert!(report.blocks().is_empty());
        add(&mut report, &[], true);
        assert!(report.to_text(80, Glyphs::Ascii).contains("none was run"));
    }

    #[test]
    fn a_table_of_a_study_is_included() {
        let study = StudyTable::of_csv("hard.csv", "trial,passes\nslack,yes\n").unwrap();
        let mut report = Report::default();
        add(&mut report, &[study], true);
        let text = report.to_text(80, Glyphs::Ascii);
        assert!(
            text.contains("hard.csv") && text.contains("slack"),
            "{text}"
        );
        assert!(!text.contains("none was run"));
        assert!(StudyTable::of_csv("empty.csv", "").is_err());
    }
}
