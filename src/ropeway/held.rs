//! A ropeway held against what its source printed: rows of the validation table.

use super::edit;
use super::model::Trend;
use super::quantities::{quantity, unit};
use super::work::Worked;
use crate::case::StudyValue;
use crate::reference::{PublishedNumber, TrendPoint, TrendStatement, ValidationRow, compare_trend};

/// Rows for every published value and every statement of trend of a ropeway, in the order of its file. `text` is the file's:
/// trends are computed on variants of it.
#[must_use]
pub fn rows(worked: &Worked, text: &str) -> Vec<ValidationRow> {
    let readings = worked.readings(worked.ropeway.cargo.position);
    let value = |printed: &PublishedNumber| {
        let found = match &readings {
            Ok(readings) => quantity(worked, readings, &printed.quantity),
            Err(trouble) => Err(format!("The ropeway has no answer: {trouble}.")),
        };
        // Closed forms are found to rounding; of the discretised line no error is estimated.
        let error = (!printed.quantity.starts_with("line.")).then_some(0.0);
        printed.held(unit(&printed.quantity), found.map(|value| (value, error)))
    };
    let values = worked.ropeway.published.iter().map(value);
    let trends = worked.ropeway.trend.iter().map(|t| trend_row(t, text));
    values.chain(trends).collect()
}

fn trend_row(trend: &Trend, text: &str) -> ValidationRow {
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
        out_of_reach: trend.out_of_reach.as_deref(),
    };
    compare_trend(statement, unit(&trend.quantity).to_owned(), points, missing)
}

/// The quantity of a trend at one value of its key.
fn at(trend: &Trend, text: &str, value: f64) -> Result<f64, String> {
    let told = |all: Vec<crate::case::Diagnostic>| {
        all.first().map_or_else(String::new, ToString::to_string)
    };
    let edited = edit::set(text, &trend.key, &format!("{value:?}")).map_err(told)?;
    let worked = super::parse(&edited, "trend").map_err(told)?;
    let readings = worked
        .readings(worked.ropeway.cargo.position)
        .map_err(|trouble| trouble.to_string())?;
    quantity(&worked, &readings, &trend.quantity)
}
