//! A ropeway compared with its published values and trends: rows of the validation table.

use super::model::{Ropeway, RopewayTrend};
use super::quantities::{self, unit};
use super::solve::SolvedRopeway;
use crate::case::{StudyValue, kind};
use crate::reference::{PublishedNumber, TrendPoint, TrendStatement, ValidationRow, compare_trend};

/// Rows for every published value and every statement of trend of a ropeway, in the order of its file. `text` is the file's:
/// trends are computed on variants of it.
#[must_use]
pub fn rows(solved: &SolvedRopeway, text: &str) -> Vec<ValidationRow> {
    let results = solved.results(solved.ropeway.cargo.position);
    let row = |printed: &PublishedNumber| {
        let found = match &results {
            Ok(results) => quantities::value(solved, results, &printed.quantity),
            Err(error) => Err(format!("The ropeway has no solution: {error}.")),
        };
        // Closed forms are exact to rounding; the error of the discretised line is not estimated.
        let error = (!printed.quantity.starts_with("line.")).then_some(0.0);
        printed.held(unit(&printed.quantity), found.map(|value| (value, error)))
    };
    let values = solved.ropeway.published.iter().map(row);
    let trends = solved.ropeway.trend.iter().map(|t| trend_row(t, text));
    let common = solved.ropeway.about.tolerance_reason.as_deref();
    let all = values.chain(trends);
    all.map(|row| row.with_common_reason(common)).collect()
}

fn trend_row(trend: &RopewayTrend, text: &str) -> ValidationRow {
    let mut missing = None;
    let points = trend.values.iter().map(|&value| {
        let computed = at(trend, text, value);
        TrendPoint {
            value: StudyValue::Number(value),
            error: None,
            computed: computed
                .map_err(|why| missing.get_or_insert(format!("At {value}: {why}")).len())
                .ok(),
        }
    });
    let points: Vec<TrendPoint> = points.collect();
    let statement = TrendStatement {
        name: &trend.name,
        source: &trend.source,
        expect: trend.expect,
        key: &trend.key,
        note: trend.note.as_deref(),
        out_of_reach: trend.out_of_reach.as_deref(),
    };
    compare_trend(statement, unit(&trend.quantity).to_owned(), points, missing)
}

/// The quantity of a trend with its key set to a value.
fn at(trend: &RopewayTrend, text: &str, value: f64) -> Result<f64, String> {
    let first = |all: Vec<crate::case::Diagnostic>| {
        all.first().map_or_else(String::new, ToString::to_string)
    };
    let edited = kind::set::<Ropeway>(text, &trend.key, &format!("{value:?}")).map_err(first)?;
    let solved = kind::parse::<Ropeway>(&edited, "trend").map_err(first)?;
    let results = solved
        .results(solved.ropeway.cargo.position)
        .map_err(|error| error.to_string())?;
    quantities::value(&solved, &results, &trend.quantity)
}
