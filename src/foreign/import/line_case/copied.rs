//! Tables that both kinds of file have, copied key by key with the expressions in them.

use super::source::LineSource;
use crate::case::{EndKind, MotionName, OneOrMany, TomlNode};
use crate::import::to_case::case_text::{CaseText, block, number, text};

/// Copies a table of the case, where it has it.
pub(super) fn copy(system: &mut CaseText<'_>, source: &LineSource<'_>, table: &str) {
    if let Some(node) = source.node(&[table]) {
        copy_table(system, source, &format!("[{table}]"), node, &[]);
    }
}

/// Copies a table under a header, but for some of its keys.
pub(super) fn copy_table(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    header: &str,
    node: &TomlNode,
    without: &[&str],
) {
    system.table(header, Some(&node.span));
    copy_keys(system, source, node, without);
    copy_inner(system, source, header, node);
}

/// Copies the tables in a table that has this header.
pub(super) fn copy_inner(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    header: &str,
    node: &TomlNode,
) {
    for entry in node.entries().iter().filter(|entry| entry.node.is_table()) {
        let inner = format!("[{}.{}]", header.trim_matches(['[', ']']), bare(&entry.key));
        copy_table(system, source, &inner, &entry.node, &[]);
    }
}

/// Copies the keys of a table, but for its tables and for those named.
pub(super) fn copy_keys(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    node: &TomlNode,
    without: &[&str],
) {
    for entry in node.entries() {
        if !entry.node.is_table() && !without.contains(&&*entry.key) {
            let value = value_of(source, &entry.node);
            system.given(&bare(&entry.key), &value, &entry.node.span, "");
        }
    }
}

/// Writes a drag area or added mass, as one number where that is enough.
pub(super) fn coefficient(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    path: &[&str],
    value: &OneOrMany,
) {
    let (Some(node), Some(key)) = (source.node(path), path.last()) else {
        return;
    };
    match value.alike() {
        Some(0.0) => {}
        Some(one) => system.given(key, &number(one), &node.span, ""),
        None => system.given(key, &value_of(source, node), &node.span, ""),
    }
}

/// A value as the case writes it.
pub(super) fn value_of(source: &LineSource<'_>, node: &TomlNode) -> String {
    source.text[node.span.clone()].to_owned()
}

/// A key as a header or a row writes it: between quotes unless it is bare.
pub(super) fn bare(key: &str) -> String {
    let is_bare = |letter: char| letter.is_ascii_alphanumeric() || "-_".contains(letter);
    match !key.is_empty() && key.chars().all(is_bare) {
        true => key.to_owned(),
        false => text(key),
    }
}

/// Carries the files that the system names.
pub(super) fn files(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let case = &source.case;
    let bed = case.seabed.iter().filter_map(|bed| bed.depth_file.as_ref());
    let load_cases = case.load_cases.iter().filter_map(|of| of.file.as_ref());
    let curves = case.published_curve.iter();
    let curves = curves.filter_map(|curve| curve.points_file.as_ref());
    let mut named: Vec<&String> = bed.chain(load_cases).chain(curves).collect();
    if source.is_in_time() {
        let ends = [&case.ends.a, &case.ends.b].into_iter();
        let of_file = [MotionName::Vessel, MotionName::Table];
        let moving =
            ends.filter(|end| end.kind == EndKind::Moving && of_file.contains(&end.motion));
        named.extend(moving.filter_map(|end| end.motion_file.as_ref()));
    }
    for check in &case.checks {
        named.extend(
            [&check.rules, &check.curve, &check.section]
                .into_iter()
                .flatten(),
        );
    }
    for (name, file) in &case.files {
        let is_named = |one: &&&String| **one == name || format!("{one}.toml") == *name;
        if named.iter().any(|one| is_named(&one)) {
            system.table(&format!("[files.{}]", text(name)), None);
            system.line(&format!("text = {}", block(&file.text)), None);
        }
    }
}
