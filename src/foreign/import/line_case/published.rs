//! What is published of a case: studies, values at their points, trends along them, curves.

use super::channels;
use super::copied::{copy_keys, value_of};
use super::lines::lines;
use super::paths;
use super::source::{LINE, LineSource};
use crate::case::{
    ChannelId, ChannelQuantity, Published, PublishedCurve, QuantityId, Statistic, Study,
    StudyPoint, StudyValue, Subject, TomlEntry, TomlNode, Trend,
};
use crate::import::to_case::case_text::{CaseText, number, text};

/// Keys that numbers, trends and curves have in both kinds of file.
const KEPT: [&str; 14] = [
    "name",
    "study",
    "expect",
    "value",
    "tolerance_rel",
    "tolerance_abs",
    "tolerance_percent",
    "source",
    "inputs",
    "kind",
    "note",
    "tolerance_reason",
    "out_of_reach",
    "greatest_percent",
];

/// Keys that curves have in both kinds of file beside these.
const OF_CURVES: [&str; 4] = ["points_file", "time_s", "period_s", "window_s"];

/// A result of a case: what it is of, what is taken of that, within which window or stretch, which of several.
struct CaseResult<'c> {
    of: &'c Subject,
    statistic: Statistic,
    within: Option<[f64; 2]>,
    nth: Option<usize>,
}

impl<'c> CaseResult<'c> {
    fn of_value(row: &'c Published) -> Self {
        Self {
            of: &row.channel,
            statistic: row.statistic,
            within: row.within(),
            nth: row.nth,
        }
    }

    fn of_trend(row: &'c Trend) -> Self {
        Self {
            of: &row.channel,
            statistic: row.statistic,
            within: row.within(),
            nth: row.nth,
        }
    }

    /// The quantity of the run of a system that it is.
    fn quantity(&self, source: &LineSource<'_>) -> Option<String> {
        let of = match self.of {
            Subject::Channel(id) => Subject::Channel(channels::translated(source, id)?),
            Subject::Line(quantity) if lines(&source.case).len() == 1 => {
                Subject::along(*quantity, LINE)
            }
            of @ Subject::Energy(_) => of.clone(),
            // Of the system at rest, and without a statistic.
            of @ (Subject::ModeFrequency(..) | Subject::NearestMode(_)) => {
                return Some(of.to_string());
            }
            _ => return None,
        };
        let id = QuantityId::new(of, self.statistic, self.within).numbered(self.nth);
        Some(id.to_string())
    }
}

/// The key of the system that a study varies; nothing where none has the value of this one alone.
fn key_of(source: &LineSource<'_>, study: &Study) -> Option<String> {
    paths::translated(source, &study.key)
}

/// Whether the system has a study.
fn has_study(source: &LineSource<'_>, name: &str) -> bool {
    let mut studies = source.case.study.iter();
    let study = studies.find(|study| study.name == name);
    study.is_some_and(|study| key_of(source, study).is_some())
}

/// Results of the system that a published value is of and that it is divided by; nothing where it has none, or not the points.
fn of_value(source: &LineSource<'_>, row: &Published) -> Option<(String, Option<String>)> {
    let points = [&row.at, &row.change_from, &row.ratio_to];
    let mut points = points.into_iter().flatten();
    if !points.all(|point| has_study(source, &point.study)) {
        return None;
    }
    let of = CaseResult::of_value(row);
    let quantity = of.quantity(source)?;
    let Some(stretch) = row.by_stretch_m else {
        return Some((quantity, None));
    };
    let within = Some(stretch);
    let other = CaseResult { within, ..of }.quantity(source)?;
    Some((quantity, Some(other)))
}

/// The result of the system that a trend is of.
fn of_trend(source: &LineSource<'_>, row: &Trend) -> Option<String> {
    let quantity = CaseResult::of_trend(row).quantity(source);
    quantity.filter(|_| has_study(source, &row.study))
}

/// The channel that a published value is of.
fn channel_of(row: &Published) -> Option<&ChannelId> {
    match &row.channel {
        Subject::Channel(id) => Some(id),
        _ => None,
    }
}

/// The channel of a system in time that a published curve is of.
fn channel(source: &LineSource<'_>, curve: &PublishedCurve) -> Option<ChannelId> {
    let mut at = curve.at.iter();
    let is_known = at.all(|at| has_study(source, &at.study));
    channels::translated(source, &curve.channel).filter(|_| is_known)
}

/// Whether a published curve, value or trend is of a force on an end.
pub(super) fn reads_forces(source: &LineSource<'_>) -> bool {
    let is_force = |id: &ChannelId| ChannelQuantity::FORCE.contains(&id.quantity);
    let case = &source.case;
    let curves = case.published_curve.iter();
    let mut curves = curves.filter_map(|curve| channel(source, curve));
    let mut values = case.published.iter().filter_map(channel_of);
    let mut trends = case.trend.iter().map(|trend| &trend.channel);
    let of_trend = |of: &Subject| matches!(of, Subject::Channel(id) if is_force(id));
    curves.any(|id| is_force(&id)) || values.any(is_force) || trends.any(of_trend)
}

/// How many published values, trends and curves the system cannot state, of how many.
pub(super) fn left_out(source: &LineSource<'_>) -> (usize, usize) {
    let case = &source.case;
    let values = case.published.iter();
    let values = values.filter(|row| of_value(source, row).is_none());
    let trends = case.trend.iter();
    let trends = trends.filter(|row| of_trend(source, row).is_none());
    let curves = case.published_curve.iter();
    let curves = curves.filter(|curve| channel(source, curve).is_none());
    let all = case.published.len() + case.trend.len() + case.published_curve.len();
    (values.count() + trends.count() + curves.count(), all)
}

/// The studies of keys that the system has not by themselves.
pub(super) fn studies_left_out<'c>(source: &'c LineSource<'_>) -> Vec<&'c str> {
    let studies = source.case.study.iter();
    let lost = studies.filter(|study| key_of(source, study).is_none());
    lost.map(|study| &*study.name).collect()
}

/// Writes studies, published values, trends and curves.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let case = &source.case;
    for (study, node) in case.study.iter().zip(items(source, "study")) {
        let Some((key, at)) = key_of(source, study).zip(node.get("key")) else {
            continue;
        };
        system.table("[[study]]", Some(&node.span));
        system.given("key", &text(&key), &at.span, "");
        copy_keys(system, source, node, &["key"]);
    }
    for (row, node) in case.published.iter().zip(items(source, "published")) {
        if let Some(results) = of_value(source, row) {
            value(system, source, row, node, results);
        }
    }
    for (row, node) in case.trend.iter().zip(items(source, "trend")) {
        if let Some(quantity) = of_trend(source, row) {
            trend(system, source, node, &quantity);
        }
    }
    let curves = case.published_curve.iter();
    for (row, node) in curves.zip(items(source, "published_curve")) {
        if let Some(channel) = channel(source, row) {
            curve(system, source, row, node, &channel);
        }
    }
}

fn value(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    row: &Published,
    node: &TomlNode,
    (quantity, by): (String, Option<String>),
) {
    system.table("[[published]]", Some(&node.span));
    let points = [
        ("at", &row.at),
        ("change_from", &row.change_from),
        ("ratio_to", &row.ratio_to),
    ];
    let point_of = |key: &str| points.iter().find(|(own, _)| *own == key)?.1.as_ref();
    for entry in node.entries() {
        let (key, span) = (&*entry.key, &entry.node.span);
        match (key, &by) {
            ("channel", _) => system.given("quantity", &text(&quantity), span, ""),
            ("by_stretch_m", Some(by)) => system.given("divided_by", &text(by), span, ""),
            _ => kept(system, source, entry, point_of(key)),
        }
    }
}

fn trend(system: &mut CaseText<'_>, source: &LineSource<'_>, node: &TomlNode, quantity: &str) {
    system.table("[[trend]]", Some(&node.span));
    for entry in node.entries() {
        match &*entry.key {
            "channel" => system.given("quantity", &text(quantity), &entry.node.span, ""),
            _ => kept(system, source, entry, None),
        }
    }
}

fn curve(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    row: &PublishedCurve,
    node: &TomlNode,
    channel: &ChannelId,
) {
    system.table("[[published_curve]]", Some(&node.span));
    for entry in node.entries() {
        let span = &entry.node.span;
        match &*entry.key {
            "channel" => system.given("channel", &text(&channel.to_string()), span, ""),
            key if OF_CURVES.contains(&key) => copied(system, source, entry),
            key => kept(
                system,
                source,
                entry,
                row.at.as_ref().filter(|_| key == "at"),
            ),
        }
    }
}

/// The tables of a list of the case.
fn items<'n>(source: &'n LineSource<'_>, list: &str) -> &'n [TomlNode] {
    source.node(&[list]).map_or(&[][..], TomlNode::items)
}

/// A point of a study as an inline table.
fn inline(point: &StudyPoint) -> String {
    let value = match &point.value {
        StudyValue::Number(value) => number(*value),
        StudyValue::Word(word) => text(word),
    };
    format!("{{ study = {}, value = {value} }}", text(&point.study))
}

/// Writes a key of a published value, trend or curve that is a point of a study, or that says what it is worth.
fn kept(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    entry: &TomlEntry,
    point: Option<&StudyPoint>,
) {
    match point {
        Some(point) => system.given(&entry.key, &inline(point), &entry.node.span, ""),
        None if KEPT.contains(&&*entry.key) => copied(system, source, entry),
        None => {}
    }
}

fn copied(system: &mut CaseText<'_>, source: &LineSource<'_>, entry: &TomlEntry) {
    let value = value_of(source, &entry.node);
    system.given(&entry.key, &value, &entry.node.span, "");
}
