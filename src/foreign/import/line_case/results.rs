//! What a case is held to and varied by: load cases, checks, what is published of it.

use super::copied::{copy, copy_keys};
use super::source::LineSource;
use super::{marks, paths, published};
use crate::case::TomlNode;
use crate::import::fault::Fault;
use crate::import::to_case::case_text::{CaseText, text};

/// Load cases of keys that the system does not have, and checks of what it does not name.
pub(super) fn faults(source: &LineSource<'_>) -> Vec<Fault> {
    let mut found = Vec::new();
    for (number, of) in source.case.load_cases.iter().enumerate() {
        let number = (number + 1).to_string();
        let at = |key| ["load_cases", &*number, key];
        if let Some(key) = &of.key
            && paths::translated(source, key).is_none()
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
        if file.is_some_and(|file| !has_same_columns(source, &file.text)) {
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
fn has_same_columns(source: &LineSource<'_>, csv: &str) -> bool {
    let mut rows = csv.lines().map(str::trim);
    let head = rows
        .find(|row| !row.is_empty() && !row.starts_with('#'))
        .unwrap_or_default();
    let is_same = |column: &str| {
        let column = column.trim().trim_matches('"');
        let of_table = ["probability", "occurrences"].contains(&column);
        of_table || paths::translated(source, column).is_some_and(|path| path == column)
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

/// Writes load cases, statistics, checks, published values and curves, and marks of inputs.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    for node in source
        .node(&["load_cases"])
        .iter()
        .flat_map(|list| list.items())
    {
        system.table("[[load_cases]]", Some(&node.span));
        if let Some(key) = node.get("key")
            && let Some(path) = key.text().and_then(|path| paths::translated(source, path))
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
    published::write(system, source);
    marks::write(system, source);
}
