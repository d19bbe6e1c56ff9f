//! Tables under another name, and copies of tables.

use std::ops::Range;

use super::add::inserted;
use super::blocks::{blocks, extent};
use super::references::{Replacements, uses};
use super::tables::{shown, table_of};
use crate::fields::{Schema, TableShape, is_name, join, split};
use crate::tree::TomlNode;

/// The text with another name of a table, and with that name wherever a key or a mark names the table.
pub(super) fn rename(
    schema: &'static Schema,
    text: &str,
    path: &[String],
    to: &str,
) -> Result<String, String> {
    let tree = TomlNode::parse(text).map_err(|error| error.to_string())?;
    let renamed = renamed_path(&tree, path, to)?;
    let mut changes = names_itself(schema, text, &tree, path, to)?;
    changes.extend(uses(schema, text, &tree, path, to));
    for block in blocks(text) {
        let [marks, key, ..] = block.path.as_slice() else {
            continue;
        };
        let Some(mut parts) = split(key).filter(|_| marks == "marks") else {
            continue;
        };
        if parts.starts_with(path) {
            parts[path.len() - 1] = to.to_owned();
            changes.push((
                block.header.clone(),
                format!("[{}]", join(&["marks", &join(&parts)])),
            ));
        }
    }
    let text = replaced(text, changes);
    let is_there = TomlNode::parse(&text).is_ok_and(|tree| tree.find(&renamed).is_some());
    match is_there {
        true => Ok(text),
        false => Err(format!(
            "{} cannot be renamed; edit it in an editor.",
            shown(path)
        )),
    }
}

/// The path with the new name, where nothing else has it.
fn renamed_path(tree: &TomlNode, path: &[String], to: &str) -> Result<Vec<String>, String> {
    if !is_name(to) {
        return Err(format!(
            "`{to}` is not a usable name: give letters, digits, - and _."
        ));
    }
    let mut renamed = path.to_vec();
    if let Some(last) = renamed.last_mut() {
        to.clone_into(last);
    }
    if tree.find(path).is_none() {
        return Err(format!("There is no {} in this file.", shown(path)));
    }
    match tree.find(&renamed) {
        Some(_) => Err(format!("There is a {} already.", shown(&renamed))),
        None => Ok(renamed),
    }
}

/// Where the table says its own name: its key `name`, or the headers of it and of the tables in it.
fn names_itself(
    schema: &'static Schema,
    text: &str,
    tree: &TomlNode,
    path: &[String],
    to: &str,
) -> Result<Replacements, String> {
    let quoted = || toml_edit::Value::from(to).to_string();
    match table_of(schema, path) {
        Some((table, true)) if table.shape == TableShape::List => {
            let name = tree.find(path).and_then(|node| node.get("name"));
            let name = name.ok_or_else(|| format!("{} has no key `name`.", shown(path)))?;
            Ok(vec![(name.span.clone(), quoted())])
        }
        Some((table, true)) if table.shape == TableShape::ByName => {
            Ok(new_headers(text, 0..text.len(), path, to))
        }
        _ => Err(format!("{} has no name of its own.", shown(path))),
    }
}

/// The headers of a table by name and of the tables in it, with another name.
fn new_headers(text: &str, within: Range<usize>, path: &[String], to: &str) -> Replacements {
    let all = blocks(text);
    let own = all
        .iter()
        .filter(|block| block.is_in(path) && within.contains(&block.header.start));
    let new = own.filter_map(|block| {
        let header = text.get(block.header.clone())?;
        let brackets = header.len() - header.trim_start_matches('[').len();
        let inner = header.get(brackets..header.len() - brackets)?;
        let mut parts = split(inner.trim())?;
        to.clone_into(parts.get_mut(path.len() - 1)?);
        let (open, close) = ("[".repeat(brackets), "]".repeat(brackets));
        Some((
            block.header.clone(),
            format!("{open}{}{close}", join(&parts)),
        ))
    });
    new.collect()
}

/// The text with other words in some places.
fn replaced(text: &str, mut changes: Replacements) -> String {
    changes.sort_by_key(|(range, _)| range.start);
    changes.dedup_by_key(|(range, _)| range.start);
    let mut out = text.to_owned();
    for (range, words) in changes.iter().rev() {
        out.replace_range(range.clone(), words);
    }
    out
}

/// The text with a copy of a table behind it.
pub(super) fn copy(
    schema: &'static Schema,
    text: &str,
    path: &[String],
    name: Option<&str>,
) -> Result<String, String> {
    let several = table_of(schema, path).is_some_and(|(_, named)| named);
    if !several {
        return Err(format!(
            "{} is one table: it cannot be there twice.",
            shown(path)
        ));
    }
    let tree = TomlNode::parse(text).map_err(|error| error.to_string())?;
    let range = extent(text, &blocks(text), path)?;
    let changes = match name {
        Some(to) => {
            renamed_path(&tree, path, to)?;
            names_itself(schema, text, &tree, path, to)?
        }
        None => Vec::new(),
    };
    let own = changes
        .into_iter()
        .filter(|(place, _)| range.contains(&place.start));
    let moved =
        own.map(|(place, words)| (place.start - range.start..place.end - range.start, words));
    let copied = replaced(&text[range.clone()], moved.collect());
    Ok(inserted(text, range.end, &copied))
}
