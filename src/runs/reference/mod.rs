//! Published data, and the comparison of runs with it.
//!
//! A case states what its source printed: values with tolerances ([`Published`])
//! and statements of trend ([`Trend`]). [`plan()`] says which variants of the case
//! have to be computed for them, [`rows()`] compares the runs with them, [`count_outcomes()`] counts the outcomes.
//!
//! Two errors are kept apart: the *difference* of a row is what model and source disagree by, the
//! *error* is what the computation itself may be off by. A row whose error is not small beside its
//! tolerance says so.
//!
//! Line cases and systems state numbers and trends by the names of their results, along studies ([`PublishedStatements`]); the rows of line cases come from
//! runs ([`rows()`]). A kind of file that is computed without a run compares its numbers with published ones by [`compare()`] and
//! [`compare_trend()`]; tables, tallies and words are the same.

mod curve;
mod edited;
mod note;
mod outcome_counts;
pub mod papers;
mod plan;
mod runs_at;
mod stated;
pub mod table;
mod trend;
mod value;
mod variant;

pub use self::table::table;
pub use edited::judge_plain as set_edited_aside;
pub use outcome_counts::{OutcomeCounts, count_outcomes};
pub use plan::plan;
pub use runs_at::NOT_RUN;
pub use stated::{ComparedRun, PublishedStatements, ResultsAt, ended};
pub use trend::{TrendStatement, compare_trend};
pub use variant::{StudyVariant, rows_of_run, variant};

use crate::case::{Case, EditedKey, Published, StudyPoint, Trend};
pub use crate::published::{
    CalibrationBasis, Outcome, PublishedNumber, PublishedTrend, RowKind, TrendLine, TrendPoint,
    ValidationRow, compare,
};
use crate::run::Run;
use runs_at::RunsAt;

/// What a line case states, by the names of its results.
struct StatementsOfCase<'a> {
    case: &'a Case,
    numbers: Vec<PublishedNumber>,
    trends: Vec<PublishedTrend>,
}

impl<'a> StatementsOfCase<'a> {
    fn new(case: &'a Case) -> Self {
        Self {
            case,
            numbers: case.published.iter().map(Published::number).collect(),
            trends: case.trend.iter().map(Trend::of_quantity).collect(),
        }
    }

    fn stated(&self) -> PublishedStatements<'_> {
        PublishedStatements {
            studies: &self.case.study,
            numbers: &self.numbers,
            trends: &self.trends,
            curves: &self.case.published_curve,
            reason: self.case.case.tolerance_reason.as_deref(),
        }
    }
}

/// Compares runs with everything the case states: first the values, then the trends, then the curves, in
/// the order of the file.
///
/// `lookup` gives the run of a variant ([`plan()`]), `None` being the case without a study; a row whose run
/// it does not give reads NOT RUN.
#[must_use]
pub fn rows<'r>(
    case: &Case,
    lookup: &dyn Fn(Option<&StudyPoint>) -> Option<&'r Run>,
) -> Vec<ValidationRow> {
    StatementsOfCase::new(case).stated().rows(&RunsAt(lookup))
}

/// The same of a case with edited inputs: the rows whose published values are not for it read EDITED, with the reason.
#[must_use]
pub fn rows_of_edited<'r>(
    case: &Case,
    edited: &[EditedKey],
    lookup: &dyn Fn(Option<&StudyPoint>) -> Option<&'r Run>,
) -> Vec<ValidationRow> {
    let mut rows = rows(case, lookup);
    let stated = StatementsOfCase::new(case);
    stated.stated().set_edited_aside(&mut rows, edited);
    rows
}

#[cfg(test)]
mod tests;
