//! Validation data: studies of keys that exist, published values and trends of channels that a run records.

use super::checks::of_checks;
use super::load_cases::of_load_cases;
use super::published_curve::of_published_curves;
use super::recorded;
use super::studies::{of_studies, of_study, of_study_point, two_others};
use super::taken::{number as number_of, stretch, suits, window};
use super::unknown_name;
use crate::case::diagnostic::Finding;
use crate::case::model::{CASE, CaseKeys, PublishedKeys, TrendKeys};
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
    let is_channel = |name: &&String| name.parse::<ChannelId>().is_ok();
    let channels =
        recorded.map(|names| names.iter().filter(is_channel).cloned().collect::<Vec<_>>());
    let unknown = |key: &Key<'_, ChannelId>| channel(case, key, channels.as_deref());
    found.extend(of_published_curves(
        &case.published_curve,
        unknown,
        &case.study,
    ));
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

fn tolerance(row: &PublishedKeys<'_>) -> Option<Finding> {
    let given = row.tolerance_rel.is_given() || row.tolerance_abs.is_given();
    (!given && row.value.is_given()).then(|| {
        let remedy = "add `tolerance_rel = ...` (a fraction of the value) or `tolerance_abs = ...` (in the unit of the value)";
        row.tolerance_rel.finding("the row has no tolerance", remedy)
    })
}
