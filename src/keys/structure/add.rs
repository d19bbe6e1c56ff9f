//! A new table, and the keys of one that is there.

use super::super::fields::parameters_table::{ANY_KEY, PARAMETERS};
use super::blocks::{TableBlock, blocks};
use super::tables::{header, shown, table_of};
use crate::edit;
use crate::fields::{Field, Schema, TableShape, is_name, join, value_text};
use crate::text_lines::newline;
use crate::tree::{TomlNode, element_names};
use crate::typed_value::checked_value;

/// The text with a new table after the last of its kind, or in the order of the declaration.
pub(super) fn add(
    schema: &'static Schema,
    text: &str,
    table: &[String],
    name: Option<&str>,
    values: &[(String, String)],
) -> Result<String, String> {
    let (declared, named) = table_of(schema, table)
        .ok_or_else(|| format!("A {} has no table {}.", schema.what, shown(table)))?;
    if named {
        return Err(format!(
            "{} is one table, not a place for some.",
            shown(table)
        ));
    }
    let tree = TomlNode::parse(text).map_err(|error| error.to_string())?;
    let path = match (declared.shape, name) {
        (TableShape::One, _) => table.to_vec(),
        // A mark is named by the key that it is of.
        (TableShape::ByName, Some(name)) if declared.key() == "marks" => {
            [table, &[name.trim().to_owned()]].concat()
        }
        (TableShape::ByName, Some(name)) => [table, &[checked_name(name)?]].concat(),
        (TableShape::ByName, None) => return Err("Give it a name.".to_owned()),
        (TableShape::List, _) => {
            let own = values.iter().find(|(key, _)| key == "name");
            let count = tree.find(table).map_or(0, |list| list.items().len());
            let name = own.map_or_else(|| (count + 1).to_string(), |(_, value)| value.clone());
            [table, &[name]].concat()
        }
    };
    if path == [PARAMETERS] && tree.find(&path).is_some() {
        return parameters_added(schema, text, &tree, values);
    }
    if tree.find(&path).is_some() {
        return Err(format!("There is a {} already.", shown(&path)));
    }
    let end = newline(text);
    let mut block = header(schema, &path)
        .ok_or_else(|| format!("{} is no table of this file.", shown(&path)))?;
    block.push_str(end);
    let known: Vec<&'static Field> = schema.fields_of(&declared.pattern()).collect();
    for (key, value) in values {
        let field = known
            .iter()
            .find(|field| field.key() == key || field.key() == ANY_KEY)
            .ok_or_else(|| format!("{} has no key {key}.", shown(table)))?;
        let written = checked_value(&tree, field, value)
            .map_err(|(problem, remedy)| format!("{key} {problem}. {}.", capital(&remedy)))?;
        block.push_str(&format!("{} = {written}{end}", join(&[key])));
    }
    let text = match text.is_empty() || text.ends_with('\n') {
        true => text.to_owned(),
        false => format!("{text}{end}"),
    };
    Ok(inserted(&text, place(schema, &text, &path), &block))
}

/// The text with parameters more in their table.
fn parameters_added(
    schema: &'static Schema,
    text: &str,
    tree: &TomlNode,
    values: &[(String, String)],
) -> Result<String, String> {
    let mut text = text.to_owned();
    for (name, value) in values {
        if tree.find(&[PARAMETERS, name]).is_some() {
            return Err(format!("There is a parameter {name} already."));
        }
        text = edit::with_key(schema, &text, PARAMETERS, name, value)?;
    }
    Ok(text)
}

/// A name that channels and key paths may have.
fn checked_name(name: &str) -> Result<String, String> {
    let name = name.trim();
    match is_name(name) {
        true => Ok(name.to_owned()),
        false => Err(format!(
            "`{name}` is not a usable name: give letters, digits, - and _."
        )),
    }
}

/// Where a new table belongs: behind its brothers, else behind what its parent holds, else behind the tables declared before it.
fn place(schema: &'static Schema, text: &str, path: &[String]) -> usize {
    let blocks = blocks(text);
    let last = |of: &dyn Fn(&TableBlock) -> bool| {
        let found = blocks
            .iter()
            .filter(|block| of(block))
            .map(|block| block.range.end);
        found.max()
    };
    let kind = |block: &TableBlock, path: &[String]| block.path.first() == path.first();
    let brothers = match path {
        [first, _, _, ..] => {
            // In a table in a table: behind all that the outer one holds.
            let outer = &path[..path.len().min(2)];
            let own = table_of(schema, &path[..1])
                .is_some_and(|(table, _)| table.shape != TableShape::One);
            let outer = if own {
                outer
            } else {
                std::slice::from_ref(first)
            };
            last(&|block| block.is_in(outer))
        }
        _ => last(&|block| kind(block, path)),
    };
    let rank = |first: Option<&String>| {
        let tables = schema.tables.iter();
        let mut roots = tables.filter(|table| !table.path.contains('.'));
        first.and_then(|first| roots.position(|table| table.path == *first))
    };
    let own_rank = rank(path.first());
    let before = || last(&|block| rank(block.path.first()) < own_rank && !block.path.is_empty());
    brothers.or_else(before).unwrap_or(text.len())
}

/// The text with a block of lines at a place, an empty line before and behind it.
pub(super) fn inserted(text: &str, at: usize, block: &str) -> String {
    let end = newline(text);
    let (before, behind) = text.split_at(at);
    let blank = |text: &str| text.is_empty() || text.ends_with(&format!("{end}{end}"));
    let above = if blank(before) { "" } else { end };
    let below = if behind.is_empty() || behind.starts_with(end) {
        ""
    } else {
        end
    };
    [before, above, block, below, behind].concat()
}

/// The text with keys of a table set and left out; a table that is not there is added.
pub(super) fn fill(
    schema: &'static Schema,
    text: &str,
    path: &str,
    values: &[(String, Option<String>)],
) -> Result<String, String> {
    let mut text = text.to_owned();
    // The word that decides which keys there are is set first.
    let deciding = |key: &str| {
        let fields = schema.fields.iter();
        usize::from(
            !fields
                .clone()
                .any(|field| field.only_if.is_some_and(|(tag, _)| tag == key)),
        )
    };
    let mut values: Vec<&(String, Option<String>)> = values.iter().collect();
    values.sort_by_key(|(key, value)| (value.is_some(), deciding(key)));
    for (key, value) in values {
        let key_path = format!("{path}.{}", join(&[key]));
        text = match value {
            Some(value) => edit::put_value(schema, &text, &key_path, value)
                .map_err(|fault| format!("{key} {}. {}.", fault.problem, capital(&fault.remedy)))?,
            None => edit::cut(&text, &key_path).unwrap_or(text),
        };
    }
    Ok(text)
}

fn capital(words: &str) -> String {
    let mut letters = words.trim_end_matches('.').chars();
    let first = letters.next().map(char::to_uppercase);
    format!(
        "{}{}",
        first.into_iter().flatten().collect::<String>(),
        letters.as_str()
    )
}

/// The keys that a table of this path has, with their values as a user types them; tables in it are not among them.
#[must_use]
pub fn values_of(text: &str, path: &[String]) -> Vec<(String, String)> {
    let tree = TomlNode::parse(text).ok();
    let node = tree.as_ref().and_then(|tree| tree.find(path));
    let entries = node.map_or(&[] as &[_], TomlNode::entries);
    let is_value = |node: &TomlNode| {
        !node.is_table() && (node.items().is_empty() || !node.is_list_of_tables())
    };
    entries
        .iter()
        .filter(|entry| is_value(&entry.node))
        .map(|entry| (entry.key.clone(), value_text(text, &entry.node)))
        .collect()
}

/// A name that none of the tables under this path has: `chain-2`.
#[must_use]
pub fn free_name(text: &str, table: &[String], wanted: &str) -> String {
    let tree = TomlNode::parse(text).ok();
    let node = tree.as_ref().and_then(|tree| tree.find(table));
    let taken = node.map_or(Vec::new(), |node| match node.items() {
        [] => node.names(),
        items => element_names(items),
    });
    let candidates =
        std::iter::once(wanted.to_owned()).chain((2..).map(|n| format!("{wanted}-{n}")));
    let mut free = candidates.filter(|name| !taken.contains(name));
    free.next().unwrap_or_default()
}
