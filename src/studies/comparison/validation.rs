//! Published values of the cases, the same row of each run side by side.

use crate::case::{self, StudyPoint};
use crate::reference::{self, Outcome, ValidationRow};
use crate::run::Run;

/// A published statement and what each run gives for it.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedRow {
    /// What it is, in words.
    pub name: String,
    /// The point of a study it belongs to.
    pub at: Option<StudyPoint>,
    /// The row of each run; absent where the case of a run does not state it, or has not been run for it.
    pub rows: Vec<Option<ValidationRow>>,
}

/// Every row that at least one of the runs has a number or a verdict for.
pub(super) fn compare(runs: &[&Run]) -> Vec<ComparedRow> {
    let of_each: Vec<Vec<ValidationRow>> = runs.iter().map(|run| rows(run)).collect();
    let mut list: Vec<ComparedRow> = Vec::new();
    for row in of_each.iter().flatten() {
        if list
            .iter()
            .any(|known| known.name == row.name && known.at == row.at)
        {
            continue;
        }
        let same = |rows: &Vec<ValidationRow>| {
            let found = rows.iter().find(|r| r.name == row.name && r.at == row.at);
            found.filter(|r| r.outcome != Outcome::NotRun).cloned()
        };
        list.push(ComparedRow {
            name: row.name.clone(),
            at: row.at.clone(),
            rows: of_each.iter().map(same).collect(),
        });
    }
    list.retain(|row| row.rows.iter().any(Option::is_some));
    list
}

/// The rows of a run; none where its case cannot be read.
fn rows(run: &Run) -> Vec<ValidationRow> {
    let case = case::parse_stored(&run.case_text, &run.info.case_file);
    case.map_or_else(|_| Vec::new(), |case| reference::rows_of_run(run, &case))
}
