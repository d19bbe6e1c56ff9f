//! A published statement of trend checked along a study.

use super::{
    Outcome, Point, Row, TrendLine,
    value::{REACHED, find, unit_of},
};
use crate::{
    case::{At, Case, Direction, Trend},
    run::Run,
};

pub(super) fn row<'r>(
    case: &Case,
    trend: &Trend,
    lookup: &dyn Fn(Option<&At>) -> Option<&'r Run>,
) -> Row {
    let study = case.study.iter().find(|s| s.name == trend.study);
    let mut values: Vec<f64> = study.map_or_else(Vec::new, |s| s.values.clone());
    values.sort_by(f64::total_cmp);

    let mut unit = trend.statistic.unit(unit_of(&trend.channel));
    let mut missing = None;
    let mut points = Vec::with_capacity(values.len());
    for value in values {
        let at = At {
            study: trend.study.clone(),
            value,
        };
        let found = lookup(Some(&at))
            .ok_or_else(|| "It has not been run.".to_owned())
            .and_then(|run| find(run, &trend.channel, trend.statistic, trend.window_s));
        let (computed, error) = match found {
            Ok(quantity) => {
                unit.clone_from(&quantity.unit);
                (Some(quantity.value), quantity.error_estimate())
            }
            Err(why) => {
                missing.get_or_insert_with(|| format!("At {value}: {why}"));
                (None, None)
            }
        };
        points.push(Point {
            value,
            computed,
            error,
        });
    }
    let (outcome, reason) = judge(trend, &points, missing);
    Row {
        name: trend.name.clone(),
        at: None,
        source: trend.source.clone(),
        published: None,
        computed: None,
        unit,
        error: None,
        difference: None,
        tolerance: None,
        outcome,
        inputs: None,
        fitted: false,
        basis: None,
        reason,
        trend: Some(TrendLine {
            expect: trend.expect,
            key: study.map_or_else(String::new, |s| s.key.clone()),
            points,
        }),
    }
}

fn judge(trend: &Trend, points: &[Point], missing: Option<String>) -> (Outcome, Option<String>) {
    if points.len() < 2 {
        let why = format!("The study `{}` has fewer than two values.", trend.study);
        return (Outcome::NotRun, Some(why));
    }
    let known: Option<Vec<(f64, f64, Option<f64>)>> = points
        .iter()
        .map(|p| p.computed.map(|c| (p.value, c, p.error)))
        .collect();
    let Some(known) = known else {
        return (Outcome::NotRun, missing);
    };
    let against = known.windows(2).find_map(|pair| match pair {
        [(from, before, _), (to, after, _)] if !goes(trend.expect, *before, *after) => {
            Some(format!("It does not from {from} to {to}."))
        }
        _ => None,
    });
    match (against, &trend.out_of_reach) {
        (None, None) => (Outcome::Pass, doubtful(&known)),
        (None, Some(_)) => (Outcome::Pass, Some(REACHED.to_owned())),
        (Some(_), Some(reason)) => (Outcome::Differs, Some(reason.clone())),
        (Some(where_), None) => (Outcome::Fail, Some(where_)),
    }
}

fn goes(expect: Direction, before: f64, after: f64) -> bool {
    match expect {
        Direction::Rises => after > before,
        Direction::Falls => after < before,
    }
}

/// Says where a step of the trend is no larger than what the two numbers may be off by.
fn doubtful(known: &[(f64, f64, Option<f64>)]) -> Option<String> {
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
