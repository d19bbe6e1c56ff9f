//! The number of rows of a file, looked at before any of them is read.

use super::fault::Fault;
use super::moordyn::sections::{SectionTitle, Sections};
use crate::limits::TABLES;

/// Rows of a table that are no data: names of the columns and units.
const HEADER: usize = 2;

/// A fault for each table that has more rows than a case may have entries.
#[must_use]
pub fn check(sections: &Sections<'_>) -> Vec<Fault> {
    let tables = sections.blocks.iter().filter(|block| {
        !matches!(
            block.section,
            SectionTitle::Options | SectionTitle::Outputs | SectionTitle::Control
        )
    });
    let found = tables.filter_map(|block| {
        let data = block.rows.iter().filter(|row| !row.is_blank());
        let count = data.clone().count().saturating_sub(HEADER);
        let first = data.clone().nth(HEADER + most())?;
        too_many(count).then(|| fault(block.section.title(), count, first.span()))
    });
    found.collect()
}

/// Whether a table has more rows than allowed.
#[must_use]
pub fn too_many(count: usize) -> bool {
    TABLES.is_exceeded_by(count as f64)
}

/// The greatest number of rows.
#[must_use]
pub fn most() -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count: saturates where it is greater than any"
    )]
    let most = TABLES.greatest().max(0.0) as usize;
    most
}

/// The fault of a table with so many rows, at the first that is too much.
#[must_use]
pub fn fault(title: &str, count: usize, at: std::ops::Range<usize>) -> Fault {
    let problem = format!("the table has {count} rows");
    let remedy = TABLES.remedy("a scene has fewer", count as f64);
    Fault::new(at, title, problem, remedy)
}
