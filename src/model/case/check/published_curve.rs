//! Checks of published curves over time.

use super::{of_study_point, of_window};
use crate::case::model::PublishedCurveKeys;
use crate::case::schema::Key;
use crate::case::{ChannelId, Finding, StudyKeys};

/// Checks of published curves: channels that are known, as `unknown` says, windows that run forward, points that follow each other, and
/// points of the studies of the file.
pub fn of_published_curves(
    list: &[(String, PublishedCurveKeys<'_>)],
    unknown: impl Fn(&Key<'_, ChannelId>) -> Option<Finding>,
    studies: &[(String, StudyKeys<'_>)],
) -> Vec<Finding> {
    let of_row = |(_, row): &(String, PublishedCurveKeys<'_>)| {
        [
            unknown(&row.channel),
            of_window(&row.window_s),
            points(row),
            flat(row),
            row.at.as_ref().and_then(|at| of_study_point(studies, at)),
        ]
    };
    list.iter().flat_map(of_row).flatten().collect()
}

/// A curve has as many values as times, at least two, and its times increase.
fn points(row: &PublishedCurveKeys<'_>) -> Option<Finding> {
    let key = if row.time_s.is_given() {
        &row.time_s
    } else {
        &row.value
    };
    let finding = |problem: &str, remedy: &str| {
        Some(Finding {
            key: row.time_s.path(),
            ..key.if_given(problem, remedy)?
        })
    };
    if row.points_file.is_given() {
        let problem = "the curve has its points twice: here and in `points_file`";
        return finding(problem, "keep one of them");
    }
    let (times, values) = (row.time_s.get()?, row.value.get()?);
    let problem = if times.len() != values.len() {
        format!(
            "there are {} times and {} values",
            times.len(),
            values.len()
        )
    } else if times.len() < 2 {
        "a curve needs at least two points".to_owned()
    } else if !times.is_sorted_by(|a, b| a < b) {
        "the times do not increase".to_owned()
    } else {
        return None;
    };
    finding(
        &problem,
        "give as many values as times, the times increasing",
    )
}

/// The greatest difference is held in percent of the curve's range, which one value alone has none of.
fn flat(row: &PublishedCurveKeys<'_>) -> Option<Finding> {
    let values = row.value.get()?;
    let is_flat = values.windows(2).all(|pair| pair[0] == pair[1]);
    let problem = "is in percent of the range of the curve, whose values are all the same";
    let remedy = "leave it out: `tolerance_percent` holds the curve";
    let given = row.greatest_percent.if_given(problem, remedy);
    given.filter(|_| is_flat)
}
