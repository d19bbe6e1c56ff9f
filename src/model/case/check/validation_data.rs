//! Validation data: studies of keys that exist, published values and trends of channels that a run records.

use super::checks::of_checks;
use super::load_cases::of_load_cases;
use super::recorded;
use super::studies::{of_studies, of_study, of_study_point, two_others};
use super::taken::{number as number_of, stretch, suits, window};
use super::unknown_name;
use crate::case::diagnostic::Finding;
use crate::case::model::{CASE, CaseKeys, PublishedCurveKeys, PublishedKeys, TrendKeys};
use crate::case::schema::{Key, KeyValue};
use crate::case::{ChannelId, ChannelQuantity, LineQuantity};

/// Checks of studies, published values and trends.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let mut found = of_studies(&CASE, case.place.node, &case.study);
    found.extend(of_load_cases(&CASE, case.place.node, &case.load_cases));
    found.extend(of_checks(&case.checks));
    let recorded = recorded::names(case);
    let quantities = LineQuantity::ALL.map(|quantity| quantity.name().to_owned());
    let all = recorded
        .as_ref()
        .map(|names| [&names[..], &quantities].concat());
    let (recorded, all) = (recorded.as_deref(), all.as_deref());
    found.extend(
        case.published_curve
            .iter()
            .flat_map(|(_, row)| curve(case, row, recorded)),
    );
    found.extend(
        case.published
            .iter()
            .flat_map(|(_, row)| published(case, row, all)),
    );
    found.extend(case.trend.iter().flat_map(|(_, row)| trend(case, row, all)));
    found
}

/// A key that names none of the channels; nothing where these are not known.
fn channel<T: KeyValue>(
    case: &CaseKeys<'_>,
    key: &Key<'_, T>,
    known: Option<&[String]>,
) -> Option<Finding> {
    let (problem, remedy) = unknown_name(key.text()?, known?, "channel", "case")?;
    let (problem, remedy) = without_bore(case, key.text()?).unwrap_or((problem, remedy));
    Some(key.finding(problem, remedy))
}

/// Problem and remedy where the wall tension of a section without a bore is asked for.
fn without_bore(case: &CaseKeys<'_>, channel: &str) -> Option<(String, String)> {
    let id: ChannelId = channel.parse().ok()?;
    let place = id
        .place
        .strip_suffix(".a")
        .or(id.place.strip_suffix(".b"))?;
    let mut sections = case.line.iter().map(|(_, section)| section);
    let section = sections.find(|section| section.name.get().is_some_and(|name| name == place))?;
    let material = section.material.get()?;
    let mut materials = case.materials.iter();
    let has_bore = materials.any(|(name, keys)| name == material && keys.bore.is_some());
    (id.quantity == ChannelQuantity::WallTension && !has_bore).then(|| {
        let problem = format!(
            "section {place} has no wall tension: its material {material} is no pipe with a bore"
        );
        let remedy = format!("add [materials.{material}.bore] with its diameter_m");
        (problem, remedy)
    })
}

fn curve(
    case: &CaseKeys<'_>,
    row: &PublishedCurveKeys<'_>,
    recorded: Option<&[String]>,
) -> Vec<Finding> {
    let is_channel = |name: &&String| name.parse::<ChannelId>().is_ok();
    let channels =
        recorded.map(|names| names.iter().filter(is_channel).cloned().collect::<Vec<_>>());
    let found = [
        channel(case, &row.channel, channels.as_deref()),
        window(&row.window_s, None),
        points(row),
        row.at
            .as_ref()
            .and_then(|at| of_study_point(&case.study, at)),
    ];
    found.into_iter().flatten().collect()
}

fn published(
    case: &CaseKeys<'_>,
    row: &PublishedKeys<'_>,
    known: Option<&[String]>,
) -> Vec<Finding> {
    let found = [
        channel(case, &row.channel, known),
        suits(&row.statistic, &row.channel),
        number_of(&row.nth, &row.statistic),
        window(&row.window_s, row.channel.get()),
        stretch(&row.stretch_m, &row.channel),
        stretch(&row.by_stretch_m, &row.channel),
        tolerance(row),
        two_others(&row.place, ["by_stretch_m", "ratio_to", "change_from"]),
    ];
    let points = [&row.at, &row.change_from, &row.ratio_to]
        .into_iter()
        .flatten();
    found
        .into_iter()
        .flatten()
        .chain(points.filter_map(|at| of_study_point(&case.study, at)))
        .collect()
}

fn trend(case: &CaseKeys<'_>, row: &TrendKeys<'_>, known: Option<&[String]>) -> Vec<Finding> {
    let found = [
        channel(case, &row.channel, known),
        suits(&row.statistic, &row.channel),
        number_of(&row.nth, &row.statistic),
        window(&row.window_s, row.channel.get()),
        stretch(&row.stretch_m, &row.channel),
        of_study(&case.study, &row.study).err(),
    ];
    found.into_iter().flatten().collect()
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

fn tolerance(row: &PublishedKeys<'_>) -> Option<Finding> {
    let given = row.tolerance_rel.is_given() || row.tolerance_abs.is_given();
    (!given && row.value.is_given()).then(|| {
        let remedy = "add `tolerance_rel = ...` (a fraction of the value) or `tolerance_abs = ...` (in the unit of the value)";
        row.tolerance_rel.finding("the row has no tolerance", remedy)
    })
}
