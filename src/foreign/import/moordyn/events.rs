//! The tables FAILURE, SYROPE IC and CONTROL.

use super::holds::{Ends, attachment, missing};
use super::sections::{SectionBlock, SectionTitle};
use super::table::{HeaderColumn, SectionTable, TableRow};
use crate::import::fault::Fault;
use crate::import::index::Index;
use crate::import::mooring::{LineFailure, Mooring, PastTension, Unmodelled};
use crate::import::words::Row;

const FAILURE_COLUMNS: [HeaderColumn; 5] = [
    ("FailID", &["ID", "FailureID", "Failure", "#"]),
    ("Attachment", &["Point", "Node", "PointID"]),
    ("Lines", &["Line(s)", "Line", "LineID(s)", "AffectedLines"]),
    ("FailTime", &["Time"]),
    ("FailTen", &["Tension", "FailTension"]),
];

const PAST_COLUMNS: [HeaderColumn; 3] = [
    ("Line(s)", &["Lines", "Line"]),
    ("Tmax0", &["Tmax"]),
    ("Tmean0", &["Tmean"]),
];

/// Reads what comes off.
pub fn read_failures(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let table = SectionTable::of_block(block, &FAILURE_COLUMNS, 5, faults);
    let to = Ends::of_mooring(mooring);
    let by_id = Index::of_identifiers(mooring.lines.iter().map(|line| line.id.as_str()));
    mooring.failures = table.read(faults, |row| {
        let time = row.not_negative(3)?;
        let tension = row.not_negative(4)?;
        if time.value == 0.0 && tension.value == 0.0 {
            return Err(row.fault(
                3,
                "neither a time nor a tension is given",
                "give one of them above 0",
            ));
        }
        let from = attachment(row, 1, &to)?;
        let lines = lines(row, 2, &by_id)?;
        let ends_there = |line: &usize| mooring.lines[*line].ends.iter().any(|end| end.value == from.value);
        if let Some(other) = lines.iter().find(|line| !ends_there(line)) {
            let id = &mooring.lines[*other].id;
            return Err(row.fault(
                2,
                format!("line {id} does not end at `{}`", row.words[1].text),
                "name the point or the end of a rod that the line comes off, and lines that end there",
            ));
        }
        Ok(LineFailure {
            span: row.row.span(),
            from,
            lines,
            time: Some(time).filter(|time| time.value > 0.0),
            tension: Some(tension).filter(|tension| tension.value > 0.0),
        })
    });
}

/// Reads the past of ropes.
pub fn read_past(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let table = SectionTable::of_block(block, &PAST_COLUMNS, 3, faults);
    let by_id = Index::of_identifiers(mooring.lines.iter().map(|line| line.id.as_str()));
    mooring.past_tensions = table.read(faults, |row| {
        let greatest = row.not_negative(1)?;
        let mean = row.not_negative(2)?;
        if mean.value > greatest.value {
            return Err(row.fault(
                2,
                "the mean tension is above the greatest",
                "the greatest mean tension so far is at least the mean tension now",
            ));
        }
        Ok(PastTension {
            span: row.row.span(),
            lines: lines(row, 0, &by_id)?,
            greatest,
            mean,
        })
    });
}

/// What another program drives is not in the file.
pub fn read_unmodelled(
    block: &SectionBlock<'_>,
    name: &'static str,
    what: &str,
    mooring: &mut Mooring,
) {
    let is_data = |row: &&Row<'_>| {
        let words = row.words();
        words.first().is_some_and(|word| word.number().is_some())
    };
    let rows = block.rows.iter().filter(is_data);
    mooring.unmodelled.extend(rows.map(|row| Unmodelled {
        name,
        span: row.span(),
        key: block.section.title().to_owned(),
        what: what.to_owned(),
    }));
}

/// Lines by their numbers, with commas between: `1,2` or `Line1`.
fn lines(row: &TableRow<'_, '_>, column: usize, by_id: &Index) -> Result<Vec<usize>, Fault> {
    let parts = row.words[column].parts(',');
    let named = parts.iter().filter(|part| !part.text.is_empty());
    let found = named.map(|part| {
        let lower = part.text.to_lowercase();
        let number = lower.strip_prefix("line").unwrap_or(&lower);
        by_id.find(number).ok_or_else(|| Fault {
            span: part.span(),
            ..missing(row, column, SectionTitle::Lines, number)
        })
    });
    found.collect()
}
