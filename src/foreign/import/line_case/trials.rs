//! Trials of a hard case as trials of its system.
//!
//! A trial of the system sets what the system of the case with the keys of the trial has other than that of the case as it stands.

use std::collections::BTreeMap;

use super::copied::{bare, copy_keys};
use super::paths;
use super::source::LineSource;
use super::system_of;
use crate::case::kind::read_variant;
use crate::case::{Case, CaseInfo, TomlNode, Trial, stand_alone};
use crate::import::to_case::case_text::{CaseText, text};
use crate::system::SystemFile;

/// Tables that say what a file is and is held against, and that no trial sets.
const BESIDE: [&str; 7] = [
    "system",
    "published",
    "published_curve",
    "trend",
    "study",
    "marks",
    "files",
];

/// Words of a refusal that is of lines alone: what nothing holds begins where a system puts it.
const LOOSE: &str = "nothing holds the line";

/// A trial as one of the system.
struct CarriedTrial {
    /// What it sets.
    set: Vec<String>,
    /// The published values that it names and the system has.
    rows: Option<Vec<String>>,
}

/// The trials of a case in its system, in their order; nothing for one that the system cannot state.
pub(super) struct CarriedTrials(Vec<Option<CarriedTrial>>);

impl CarriedTrials {
    /// Of a case that can be converted.
    pub(super) fn new(source: &LineSource<'_>) -> Self {
        let trials = &source.case.trial;
        if trials.is_empty() {
            return Self(Vec::new());
        }
        let text = stand_alone(source.text, &source.case);
        let base = SystemText::of_case(&text, &[], source);
        let carry = |trial| {
            base.as_ref()
                .and_then(|base| carried(source, (base, &text), trial))
        };
        let mut all: Vec<_> = trials.iter().map(carry).collect();
        // Numbers that are to come out again need the trial that they are of.
        for number in 0..all.len() {
            let other = trials[number].same_as.as_ref();
            let at = other.and_then(|name| trials.iter().position(|one| one.name == *name));
            if at.is_some_and(|at| all[at].is_none()) {
                all[number] = None;
            }
        }
        Self(all)
    }

    /// The names of those that are left out.
    pub(super) fn left_out<'c>(&self, source: &'c LineSource<'_>) -> Vec<&'c str> {
        let trials = source.case.trial.iter().zip(&self.0);
        let lost = trials.filter(|(_, carried)| carried.is_none());
        lost.map(|(trial, _)| trial.name.as_str()).collect()
    }

    /// Writes them.
    pub(super) fn write(&self, system: &mut CaseText<'_>, source: &LineSource<'_>) {
        let nodes = source.node(&["trial"]).map_or(&[][..], TomlNode::items);
        for (carried, node) in self.0.iter().zip(nodes) {
            let Some(carried) = carried else { continue };
            system.table("[[trial]]", Some(&node.span));
            let name = ["set", "rows"];
            copy_keys(system, source, node, &name);
            let lists = [Some(&carried.set), carried.rows.as_ref()]
                .map(|list| list.filter(|list| !list.is_empty()));
            for (key, list) in name.into_iter().zip(lists) {
                if let Some((list, at)) = list.zip(node.get(key)) {
                    let list: Vec<String> = list.iter().map(|word| text(word)).collect();
                    system.given(key, &format!("[{}]", list.join(", ")), &at.span, "");
                }
            }
        }
    }
}

/// The text of the system of a case with some keys set, and its tree.
struct SystemText {
    text: String,
    root: TomlNode,
}

impl SystemText {
    /// Nothing where the case is refused, or cannot be stated as a system.
    fn of_case(text: &str, edits: &[(&str, &str)], source: &LineSource<'_>) -> Option<Self> {
        let mut read = read_variant::<Case>(text, edits, &source.case.files).ok()?;
        read.content.trial.clear();
        let variant = LineSource::new(&read.text, read.content);
        let text = system_of(&variant).ok()?.text;
        let root = TomlNode::parse(&text).ok()?;
        Some(Self { text, root })
    }

    /// Names of the published values and curves.
    fn rows(&self) -> impl Iterator<Item = &str> {
        let lists = ["published", "published_curve"].into_iter();
        let lists = lists.filter_map(|list| self.root.get(list));
        let rows = lists.flat_map(TomlNode::items);
        rows.filter_map(|row| row.get("name")?.text())
    }
}

/// A trial of the system that computes what a trial of the case does; nothing where there is none.
fn carried(
    source: &LineSource<'_>,
    (base, text): (&SystemText, &str),
    trial: &Trial,
) -> Option<CarriedTrial> {
    if trial
        .refused
        .as_ref()
        .is_some_and(|words| words.contains(LOOSE))
    {
        return None;
    }
    let set: Vec<&String> = trial.set.iter().flatten().collect();
    let edits: Option<Vec<(&str, &str)>> = set.iter().map(|word| word.split_once('=')).collect();
    let edits: Vec<(&str, &str)> = edits?
        .into_iter()
        .map(|(key, value)| (key.trim(), value.trim()))
        .collect();
    let set = match SystemText::of_case(text, &edits, source) {
        Some(variant) => {
            let set = differences(base, &variant);
            sets_the_same(base, &variant, &set).then_some(set)?
        }
        // It is refused as it is read, and so is that of the system.
        None => {
            let words = edits.iter().map(|(key, value)| {
                let path = paths::translated(source, key)?;
                Some(format!("{path}={value}"))
            });
            let set = words.collect::<Option<Vec<String>>>()?;
            trial.refused.is_some().then_some(set)?
        }
    };
    let rows = trial.rows.as_ref().map(|rows| {
        let kept = rows
            .iter()
            .filter(|name| base.rows().any(|row| row == *name));
        kept.cloned().collect::<Vec<String>>()
    });
    let is_held = match &rows {
        Some(rows) => !rows.is_empty(),
        None => base.rows().next().is_some(),
    };
    (is_held || trial.refused.is_some()).then_some(CarriedTrial { set, rows })
}

/// The keys that a system has other than another, each as key=value.
fn differences(base: &SystemText, variant: &SystemText) -> Vec<String> {
    let mut own = Vec::new();
    for entry in variant.root.entries() {
        if !BESIDE.contains(&&*entry.key) {
            add_values(&entry.node, (&bare(&entry.key), &variant.text), &mut own);
        }
    }
    let mut before = Vec::new();
    add_values(&base.root, ("", &base.text), &mut before);
    let mut set = own;
    set.retain(|one| !before.contains(one));
    set.into_iter()
        .map(|(path, value)| format!("{path}={value}"))
        .collect()
}

/// The values below a table or list of tables, by their key paths.
fn add_values(node: &TomlNode, (path, text): (&str, &str), values: &mut Vec<(String, String)>) {
    let below = |name: &str| match path {
        "" => bare(name),
        path => format!("{path}.{}", bare(name)),
    };
    if node.is_table() {
        for entry in node.entries() {
            add_values(&entry.node, (&below(&entry.key), text), values);
        }
    } else if node.is_list_of_tables() && !node.items().is_empty() {
        for (name, item) in node.names().iter().zip(node.items()) {
            add_values(item, (&below(name), text), values);
        }
    } else {
        let value = node.text().unwrap_or(&text[node.span.clone()]);
        values.push((path.to_owned(), value.to_owned()));
    }
}

/// Whether a system with keys set is another, but for what it is held against.
fn sets_the_same(base: &SystemText, variant: &SystemText, set: &[String]) -> bool {
    let edits: Vec<(&str, &str)> = set.iter().filter_map(|word| word.split_once('=')).collect();
    let none = BTreeMap::new();
    let read = |text: &str, edits: &[(&str, &str)]| {
        let mut file = read_variant::<SystemFile>(text, edits, &none).ok()?.content;
        file.about = CaseInfo::default();
        file.published.clear();
        file.published_curve.clear();
        file.trend.clear();
        file.study.clear();
        file.marks.clear();
        file.files.clear();
        Some(file)
    };
    let (own, other) = (read(&base.text, &edits), read(&variant.text, &[]));
    // What no system can be is refused.
    own == other
}
