//! What a case is held to and varied by: load cases, checks, published values and curves.

use super::channels;
use super::copied::{copy, copy_keys, value_of};
use super::paths;
use super::source::{LINE, LineSource};
use super::stretches::{Stretch, lines};
use crate::case::{
    ChannelId, ChannelQuantity, Published, PublishedCurve, QuantityId, Statistic, Subject, TomlNode,
};
use crate::import::fault::Fault;
use crate::import::to_case::case_text::{CaseText, numbers, text};

/// Keys that numbers and curves have in both kinds of file.
const KEPT: [&str; 12] = [
    "name",
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

/// Load cases of keys that the system does not have, and checks of what it does not name.
pub(super) fn faults(source: &LineSource<'_>, line: &[Stretch<'_>]) -> Vec<Fault> {
    let mut found = Vec::new();
    for (number, of) in source.case.load_cases.iter().enumerate() {
        let number = (number + 1).to_string();
        let at = |key| ["load_cases", &*number, key];
        if let Some(key) = &of.key
            && paths::translated(source, line, key).is_none()
        {
            let problem = "no key of a system has the value of this one alone";
            found.push(source.fault(
                &at("key"),
                problem,
                "leave the table out, and vary keys of the system",
            ));
        }
        let file = of
            .file
            .as_ref()
            .and_then(|name| source.case.files.get(name));
        if file.is_some_and(|file| !has_same_columns(source, line, &file.text)) {
            let problem = "has columns of keys that a system has elsewhere, or not at all";
            found.push(source.fault(
                &at("file"),
                problem,
                "leave the table out, and vary keys of the system",
            ));
        }
    }
    found.extend(checks(source));
    found
}

/// Whether all columns of a file of load cases are keys that the system has by the same path.
fn has_same_columns(source: &LineSource<'_>, line: &[Stretch<'_>], csv: &str) -> bool {
    let mut rows = csv.lines().map(str::trim);
    let head = rows
        .find(|row| !row.is_empty() && !row.starts_with('#'))
        .unwrap_or_default();
    let is_same = |column: &str| {
        let column = column.trim().trim_matches('"');
        let of_table = ["probability", "occurrences"].contains(&column);
        of_table || paths::translated(source, line, column).is_some_and(|path| path == column)
    };
    head.split(',').all(is_same)
}

/// Checks of parts that the system has no name for: all but the ends.
fn checks(source: &LineSource<'_>) -> Vec<Fault> {
    let ends = [&source.case.ends.a.name, &source.case.ends.b.name];
    let checks = source.case.checks.iter().enumerate();
    let unnamed = checks.filter(|(_, check)| {
        let mut of = check.of.iter().flatten();
        !of.all(|name| ends.contains(&name))
    });
    let paths = source
        .node(&["checks"])
        .map_or_else(Vec::new, TomlNode::names);
    let fault = |(number, _): (usize, _)| {
        let path = ["checks", paths.get(number).map_or("", String::as_str), "of"];
        let problem = "names a part of the line that is no part of the system";
        source.fault(
            &path,
            problem,
            "name an end, or leave it out for the whole line",
        )
    };
    unnamed.map(fault).collect()
}

/// Statistics that are the value itself of a single state.
const ONE_STATE: [Statistic; 4] = [
    Statistic::Mean,
    Statistic::Max,
    Statistic::Min,
    Statistic::Final,
];

/// The quantity of a system that a published value is of: at rest, or of its run in time.
fn quantity(source: &LineSource<'_>, line: &[Stretch<'_>], row: &Published) -> Option<String> {
    let by_other =
        row.change_from.is_some() || row.ratio_to.is_some() || row.by_stretch_m.is_some();
    if row.at.is_some() || by_other {
        return None;
    }
    if source.is_in_time() {
        let of = match &row.channel {
            Subject::Channel(id) => Subject::Channel(channels::translated(source, line, id)?),
            Subject::Line(quantity) if lines(line).len() == 1 => Subject::along(*quantity, LINE),
            of @ Subject::Energy(_) => of.clone(),
            _ => return None,
        };
        let id = QuantityId::new(of, row.statistic, row.within()).numbered(row.nth);
        return Some(id.to_string());
    }
    let is_last = row.window_s.is_none() && ONE_STATE.contains(&row.statistic);
    let id = channel_of(row).filter(|_| is_last)?;
    let found = channels::translated(source, line, id)?;
    // At rest the tension of a system is the force on the end, with the shear of a line that bends.
    if id.quantity == ChannelQuantity::Tension && source.bends() {
        return None;
    }
    let at_rest = [ChannelQuantity::Tension, ChannelQuantity::OnBed];
    let is_known =
        at_rest.contains(&found.quantity) || ChannelQuantity::POSITION.contains(&found.quantity);
    is_known.then(|| found.to_string())
}

/// The channel that a published value is of.
fn channel_of(row: &Published) -> Option<&ChannelId> {
    match &row.channel {
        Subject::Channel(id) => Some(id),
        _ => None,
    }
}

/// The channel of a system in time that a published curve is of.
fn channel(
    source: &LineSource<'_>,
    line: &[Stretch<'_>],
    curve: &PublishedCurve,
) -> Option<ChannelId> {
    let is_plain = curve.at.is_none() && curve.period_s.is_none() && curve.window_s.is_none();
    let found = channels::translated(source, line, &curve.channel);
    found.filter(|_| is_plain && source.is_in_time())
}

/// Whether a published curve or value is of a force on an end.
pub(super) fn reads_forces(source: &LineSource<'_>, line: &[Stretch<'_>]) -> bool {
    let is_force = |id: &ChannelId| ChannelQuantity::FORCE.contains(&id.quantity);
    let case = &source.case;
    let curves = case.published_curve.iter();
    let mut curves = curves.filter_map(|curve| channel(source, line, curve));
    let mut values = case.published.iter().filter_map(channel_of);
    curves.any(|id| is_force(&id)) || values.any(is_force)
}

/// How many published values and curves the system cannot state, of how many.
pub(super) fn left_out(source: &LineSource<'_>, line: &[Stretch<'_>]) -> (usize, usize) {
    let case = &source.case;
    let values = case
        .published
        .iter()
        .filter(|row| quantity(source, line, row).is_none());
    let curves = case
        .published_curve
        .iter()
        .filter(|curve| channel(source, line, curve).is_none());
    let all = case.published.len() + case.published_curve.len();
    (values.count() + curves.count(), all)
}

/// Writes load cases, statistics, checks, published values and curves, and marks of inputs.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>, line: &[Stretch<'_>]) {
    for node in source
        .node(&["load_cases"])
        .iter()
        .flat_map(|list| list.items())
    {
        system.table("[[load_cases]]", Some(&node.span));
        if let Some(key) = node.get("key")
            && let Some(path) = key
                .text()
                .and_then(|path| paths::translated(source, line, path))
        {
            system.given("key", &text(&path), &key.span, "");
        }
        copy_keys(system, source, node, &["key"]);
    }
    copy(system, source, "statistics");
    for node in source
        .node(&["checks"])
        .iter()
        .flat_map(|list| list.items())
    {
        system.table("[[checks]]", Some(&node.span));
        copy_keys(system, source, node, &[]);
    }
    published(system, source, line);
    marks(system, source, line);
}

fn published(system: &mut CaseText<'_>, source: &LineSource<'_>, line: &[Stretch<'_>]) {
    let nodes = source
        .node(&["published"])
        .map_or(&[][..], |list| list.items());
    for (row, node) in source.case.published.iter().zip(nodes) {
        let Some((quantity, at)) = quantity(source, line, row).zip(node.get("channel")) else {
            continue;
        };
        system.table("[[published]]", Some(&node.span));
        system.given("quantity", &text(&quantity), &at.span, "channel");
        kept(system, source, node);
    }
    let nodes = source
        .node(&["published_curve"])
        .map_or(&[][..], |list| list.items());
    for (curve, node) in source.case.published_curve.iter().zip(nodes) {
        let Some((channel, at)) = channel(source, line, curve).zip(node.get("channel")) else {
            continue;
        };
        system.table("[[published_curve]]", Some(&node.span));
        system.given("channel", &text(&channel.to_string()), &at.span, "");
        system.given("time_s", &numbers(&curve.time_s), &node.span, "");
        kept(system, source, node);
        if node.get("value").is_none() {
            system.given("value", &numbers(&curve.value), &node.span, "points_file");
        }
    }
}

/// The keys of a published value or curve that say what it is worth.
fn kept(system: &mut CaseText<'_>, source: &LineSource<'_>, node: &TomlNode) {
    for key in KEPT {
        if let Some(value) = node.get(key) {
            system.given(key, &value_of(source, value), &value.span, "");
        }
    }
}

/// Where inputs come from, of those that the system has.
fn marks(system: &mut CaseText<'_>, source: &LineSource<'_>, line: &[Stretch<'_>]) {
    for entry in source
        .node(&["marks"])
        .map_or(&[][..], |marks| marks.entries())
    {
        let Some(path) = paths::translated(source, line, &entry.key) else {
            continue;
        };
        system.table(&format!("[marks.{}]", text(&path)), Some(&entry.node.span));
        copy_keys(system, source, &entry.node, &[]);
    }
}
