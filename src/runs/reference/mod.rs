//! Published data, and the comparison of runs with it.
//!
//! A case states what its source printed: values with tolerances ([`Published`](crate::case::Published))
//! and statements of trend ([`Trend`](crate::case::Trend)). [`plan()`] says which variants of the case
//! have to be computed for them, [`rows()`] compares the runs with them, [`count_outcomes()`] counts the outcomes.
//!
//! Two errors are kept apart: the *difference* of a row is what model and source disagree by, the
//! *error* is what the computation itself may be off by. A row whose error is not small beside its
//! tolerance says so.
//!
//! Rows of line cases come from runs ([`rows()`]). A kind of file that is computed without a run compares its
//! numbers with published ones by [`compare()`] and [`compare_trend()`]; tables, tallies and words are the same.

mod curve;
mod edited;
mod note;
mod outcome_counts;
pub mod papers;
mod plan;
pub mod published_history;
pub mod table;
mod trend;
mod value;
mod variant;

pub use self::table::table;
pub use edited::judge_plain as set_edited_aside;
pub use outcome_counts::{OutcomeCounts, count_outcomes};
pub use plan::plan;
pub use published_history::PublishedHistory;
pub use trend::{TrendStatement, compare_trend};
pub use variant::{StudyVariant, rows_of_run, variant};

pub use crate::published::{
    CalibrationBasis, Outcome, PublishedNumber, RowKind, TrendLine, TrendPoint, ValidationRow,
    compare,
};
use crate::{
    case::{Case, EditedKey, StudyPoint},
    run::Run,
};

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
    let values = case
        .published
        .iter()
        .map(|published| value::row(published, &case.published, lookup));
    let trends = case
        .trend
        .iter()
        .map(|trend| trend::row(case, trend, lookup));
    let curves = case.published_curve.iter().enumerate();
    let curves = curves.map(|(number, curve)| curve::row(number, curve, lookup));
    let common = case.case.tolerance_reason.as_deref();
    let all = values.chain(trends).chain(curves);
    all.map(|row| row.with_common_reason(common)).collect()
}

/// The same of a case with edited inputs: the rows whose published values are not for it read EDITED, with the reason.
#[must_use]
pub fn rows_of_edited<'r>(
    case: &Case,
    edited: &[EditedKey],
    lookup: &dyn Fn(Option<&StudyPoint>) -> Option<&'r Run>,
) -> Vec<ValidationRow> {
    let mut rows = rows(case, lookup);
    edited::judge(&mut rows, case, edited);
    rows
}

#[cfg(test)]
mod tests;
