//! A published statement of trend checked along a study.

use std::cmp::Ordering;

use super::stated::{PublishedStatements, ResultsAt};
use super::{Outcome, RowKind, TrendLine, TrendPoint, ValidationRow};
use crate::case::{Direction, StudyPoint, StudyValue};
use crate::published::PublishedTrend;
use crate::published::comparison::REACHED;

/// The row of a trend of a file.
pub(super) fn row(
    stated: &PublishedStatements<'_>,
    trend: &PublishedTrend,
    results: &dyn ResultsAt,
) -> ValidationRow {
    let study = stated.study(&trend.study);
    let mut values: Vec<StudyValue> = study.map_or_else(Vec::new, |s| s.values.clone());
    // Words have no order but that of the file.
    values.sort_by(|a, b| match (a.number(), b.number()) {
        (Some(a), Some(b)) => a.total_cmp(&b),
        _ => Ordering::Equal,
    });
    let mut missing = None;
    let mut points = Vec::with_capacity(values.len());
    for value in values {
        let at = StudyPoint {
            study: trend.study.clone(),
            value: value.clone(),
        };
        let (computed, error) = match results.number(Some(&at), &trend.quantity) {
            Ok(number) => (Some(number.value), number.error),
            Err(why) => {
                missing.get_or_insert_with(|| format!("At {value}: {why}"));
                (None, None)
            }
        };
        points.push(TrendPoint {
            value,
            computed,
            error,
        });
    }
    compare_trend(
        TrendStatement {
            name: &trend.name,
            source: &trend.source,
            expect: trend.expect,
            key: study.map_or("", |s| &s.key),
            note: trend.note.as_deref(),
            out_of_reach: trend.out_of_reach.as_deref(),
        },
        results.unit(&trend.quantity),
        points,
        missing,
    )
}

/// A published trend, whatever kind of file states it.
#[derive(Debug, Clone, Copy)]
pub struct TrendStatement<'a> {
    /// The statement, in words.
    pub name: &'a str,
    /// Where it is printed.
    pub source: &'a str,
    /// What the number does as the key's values grow.
    pub expect: Direction,
    /// The key that is varied.
    pub key: &'a str,
    /// What else its file says of it.
    pub note: Option<&'a str>,
    /// Why it is out of reach, where it is.
    pub out_of_reach: Option<&'a str>,
}

/// Compares numbers at growing values of a key with a published trend. `missing` says why a point has no number.
#[must_use]
pub fn compare_trend(
    statement: TrendStatement<'_>,
    unit: String,
    points: Vec<TrendPoint>,
    missing: Option<String>,
) -> ValidationRow {
    let (outcome, reason) = judge(&statement, &points, missing);
    ValidationRow {
        outcome,
        reason,
        kind: RowKind::Trend,
        note: statement.note.map(str::to_owned),
        trend: Some(TrendLine {
            expect: statement.expect,
            key: statement.key.to_owned(),
            points,
        }),
        ..ValidationRow::not_run(statement.name, statement.source, unit)
    }
}

/// A value of the study, the number there, and its estimated error.
type Known<'a> = (&'a StudyValue, f64, Option<f64>);

fn judge(
    statement: &TrendStatement<'_>,
    points: &[TrendPoint],
    missing: Option<String>,
) -> (Outcome, Option<String>) {
    if points.len() < LEAST_POINTS {
        let why = format!(
            "A trend needs {LEAST_POINTS} values or more, and has {}.",
            points.len()
        );
        return (Outcome::NotRun, Some(why));
    }
    let known: Option<Vec<Known>> = points
        .iter()
        .map(|p| p.computed.map(|c| (&p.value, c, p.error)))
        .collect();
    let Some(known) = known else {
        return (Outcome::NotRun, missing);
    };
    let against = known.windows(2).find_map(|pair| match pair {
        [(from, before, _), (to, after, _)] if !goes(statement.expect, *before, *after) => {
            Some(format!("It does not from {from} to {to}."))
        }
        _ => None,
    });
    match (against.or_else(|| doubtful(&known)), statement.out_of_reach) {
        (None, None) => (Outcome::Pass, None),
        (None, Some(_)) => (Outcome::Pass, Some(REACHED.to_owned())),
        (Some(_), Some(reason)) => (Outcome::Differs, Some(reason.to_owned())),
        (Some(where_), None) => (Outcome::Fail, Some(where_)),
    }
}

fn goes(expect: Direction, before: f64, after: f64) -> bool {
    match expect {
        Direction::Rises => after > before,
        Direction::Falls => after < before,
    }
}

/// Fewer values than this show no trend: of two, one is above the other by chance in one case of two.
const LEAST_POINTS: usize = 3;

/// Says where a step of the trend is no larger than what the two numbers may be off by, so that it shows nothing.
fn doubtful(known: &[Known]) -> Option<String> {
    known.windows(2).find_map(|pair| match pair {
        [(from, before, e0), (to, after, e1)] => {
            let error = e0.unwrap_or(0.0) + e1.unwrap_or(0.0);
            let small = (after - before).abs() <= error;
            small.then(|| {
                format!(
                    "The step from {from} to {to} is no larger than the estimated numerical errors."
                )
            })
        }
        _ => None,
    })
}
