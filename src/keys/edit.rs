//! Edits of a file's text that touch nothing but the value: comments, order of keys, spacing and
//! line ends of every other byte stay as they are.

use std::ops::Range;

use super::check::{fields_here, unknown_path};
use super::diagnostic::{Diagnostic, count};
use super::fields::parameters_table::ANY_KEY;
use super::fields::{AbsentValue, Field, Schema, TableShape, check_value, join, split, value_text};
use super::parameters;
use super::read::tree_of;
use super::text_lines::{line_start, newline};
use super::tree::{TableForm, TomlData, TomlEntry, TomlNode};
use super::typed_value::{bracketed, typed, written};

/// The text with several keys set one after the other, not checked as a whole, and the edits in words.
pub fn put_all(
    schema: &'static Schema,
    text: &str,
    edits: &[(&str, &str)],
) -> Result<(String, String), Vec<Diagnostic>> {
    let mut edited = text.to_owned();
    let mut faults = Vec::new();
    for (key_path, value) in edits {
        match put(schema, &edited, key_path, value) {
            Ok(next) => edited = next,
            Err(fault) => faults.push(fault),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let shown: Vec<String> = edits.iter().map(|(k, v)| format!("{k} = {v}")).collect();
    Ok((edited, shown.join(", ")))
}

/// The text with one optional key left out. A comment behind its value stays, on a line of its own.
///
/// # Errors
///
/// The key is needed or not given.
pub fn without(schema: &'static Schema, text: &str, key_path: &str) -> Result<String, Diagnostic> {
    let refuse = |problem: &str, remedy: &str| {
        Err(refusal(key_path, "", problem.to_owned(), remedy.to_owned()))
    };
    let Ok(root) = tree_of(text) else {
        return refuse(
            "stands in a file that is not TOML",
            "mend the file in an editor first",
        );
    };
    let parts = split(key_path).unwrap_or_default();
    let field = field_of(schema, &root, &parts);
    if field.is_some_and(|f| f.absent == AbsentValue::Required) {
        return refuse("is needed", "give another value");
    }
    let found = parts
        .split_last()
        .and_then(|(key, table)| Some((root.find(table)?, key)))
        .and_then(|(table, key)| Some((table, table.entry(key)?)));
    let (Some((table, entry)), true) = (found, field.is_some()) else {
        return refuse("is not given in this file", "there is nothing to leave out");
    };
    Ok(match table.data {
        TomlData::Table(TableForm::Inline, _) => out_of_braces(text, entry),
        _ => out_of_lines(text, entry),
    })
}

/// The text with one key taken out, without a check of any kind; nothing where the file does not have it.
pub fn cut(text: &str, key_path: &str) -> Option<String> {
    let root = TomlNode::parse(text).ok()?;
    let parts = split(key_path)?;
    let (key, table) = parts.split_last()?;
    let table = root.find(table)?;
    let entry = table.entry(key)?;
    Some(match table.data {
        TomlData::Table(TableForm::Inline, _) => out_of_braces(text, entry),
        _ => out_of_lines(text, entry),
    })
}

/// Takes a key with its comma out of a table in braces.
fn out_of_braces(text: &str, entry: &TomlEntry) -> String {
    let (mut from, mut to) = (entry.key_span.start, entry.node.span.end);
    let after = &text[to..];
    if let Some(rest) = after.trim_start().strip_prefix(',') {
        to += after.len() - rest.trim_start().len();
    } else if let Some(before) = text[..from].trim_end().strip_suffix(',') {
        from = before.len();
    }
    spliced(text, &(from..to), "")
}

/// Takes the lines of a key out of a table; a comment at their end stays.
fn out_of_lines(text: &str, entry: &TomlEntry) -> String {
    let from = line_start(text, entry.key_span.start);
    let end = entry.node.span.end;
    let rest = text[end..].find('\n').map_or(text.len(), |n| end + n + 1);
    let comment = text[end..rest].trim_start();
    spliced(text, &(from..rest), comment)
}

/// The value of a key as the file gives it, text without its quotes; nothing when the file leaves
/// it out or is not TOML.
#[must_use]
pub fn get(text: &str, key_path: &str) -> Option<String> {
    let root = TomlNode::parse(text).ok()?;
    let node = root.find(&split(key_path)?)?;
    Some(value_text(text, node))
}

/// The field of a key path of a file with this schema.
pub fn field_by(
    schema: &'static Schema,
    text: &str,
    key_path: &str,
) -> Result<&'static Field, Diagnostic> {
    let root = tree_of(text).map_err(|_| {
        let problem = "stands in a file that is not TOML".to_owned();
        refusal(
            key_path,
            "",
            problem,
            "mend the file in an editor first".to_owned(),
        )
    })?;
    let found = split(key_path).and_then(|parts| {
        let field = field_of(schema, &root, &parts)?;
        let (_, table) = parts.split_last()?;
        let by_name = table.len() > 1 || field.table().contains('*');
        let is_there = match field.key() {
            ANY_KEY => root.find(&parts).is_some(),
            _ => !by_name || root.find(table).is_some(),
        };
        is_there.then_some(field)
    });
    found.ok_or_else(|| {
        let (problem, remedy) = unknown_path(schema, &root, key_path);
        refusal(key_path, "", problem, remedy)
    })
}

/// The text with one key more in a table that is there, whose keys the user names.
pub fn with_key(
    schema: &'static Schema,
    text: &str,
    table: &str,
    key: &str,
    value: &str,
) -> Result<String, String> {
    let root = TomlNode::parse(text).map_err(|error| error.to_string())?;
    let fields = schema.fields_of(table).next();
    let (Some(node), Some(field)) = (root.get(table), fields) else {
        return Err(format!("There is no [{table}] in this file."));
    };
    let key = join(&[key]);
    into_table(text, node, &key, &written(field, value)).map_err(|(problem, _)| problem)
}

/// Sets one key of a file to a value as typed into a form, checking both but not the file as a whole.
pub fn put_value(
    schema: &'static Schema,
    text: &str,
    key_path: &str,
    value: &str,
) -> Result<String, Diagnostic> {
    let field = split(key_path).and_then(|parts| {
        let root = TomlNode::parse(text).ok()?;
        field_of(schema, &root, &parts)
    });
    let value = field.map_or_else(|| value.to_owned(), |field| bracketed(field, value));
    put(schema, text, key_path, &value)
}

/// Sets one key of a file, checking key and value but not the file as a whole.
fn put(
    schema: &'static Schema,
    text: &str,
    key_path: &str,
    value: &str,
) -> Result<String, Diagnostic> {
    let refuse = |problem: String, remedy: String| refusal(key_path, value, problem, remedy);
    let root = tree_of(text).map_err(|found| {
        let problem = found
            .first()
            .map_or(String::new(), |fault| fault.problem.clone());
        refuse(problem, "mend the file in an editor first".to_owned())
    })?;
    let known = split(key_path)
        .and_then(|parts| field_of(schema, &root, &parts).map(|field| (parts, field)));
    let Some((parts, field)) = known else {
        let (problem, remedy) = unknown_path(schema, &root, key_path);
        return Err(refuse(problem, remedy));
    };
    let (written, node) = typed(field, value);
    let number = parameters::typed(&root, field, &node)
        .map_err(|fault| refuse(fault.problem, fault.remedy.to_string()))?;
    let is_parameter = field.key() == ANY_KEY;
    // An expression of parameters is checked with all of them, in the file.
    if !(is_parameter && node.text().is_some()) {
        check_value(field, number.as_ref().unwrap_or(&node))
            .map_err(|fault| refuse(fault.problem, fault.remedy))?;
    }
    if let Some(node) = root.find(&parts) {
        return Ok(spliced(text, &node.span, &written));
    }
    if is_parameter {
        let (problem, remedy) = parameters::absent(&root, parts.last().map_or("", String::as_str));
        return Err(refuse(problem, remedy));
    }
    inserted(schema, text, &root, &parts, &written)
        .map_err(|(problem, remedy)| refuse(problem, remedy))
}

/// The field that a key path means; of several, the one that its table has.
fn field_of(schema: &'static Schema, root: &TomlNode, parts: &[String]) -> Option<&'static Field> {
    let (_, table) = parts.split_last()?;
    let has = |field: &Field| {
        let node = root.find(table);
        node.is_some_and(|node| fields_here(schema, node, field.table()).contains(&field))
    };
    let mut meant = schema.fields_at(parts);
    let first = schema.fields_at(parts).next();
    meant.find(|field| has(field)).or(first)
}

/// An edit that is refused: the diagnostic carries it, `key = value`, in the place of a file.
#[must_use]
pub fn refusal(key_path: &str, value: &str, problem: String, remedy: String) -> Diagnostic {
    let mut diagnostic = Diagnostic::whole_file(&format!("{key_path} = {value}"), problem, remedy);
    diagnostic.key = key_path.to_owned();
    diagnostic.column = count(key_path.chars().count() + " = ".len() + 1);
    diagnostic
}

fn spliced(text: &str, span: &Range<usize>, new: &str) -> String {
    [&text[..span.start], new, &text[span.end..]].concat()
}

/// Problem and remedy.
pub type EditError = (String, String);

fn no_key() -> EditError {
    (
        "is not the path of a key".to_owned(),
        "write table and key: `solver.method`".to_owned(),
    )
}

/// Adds a key that the file leaves out.
fn inserted(
    schema: &'static Schema,
    text: &str,
    root: &TomlNode,
    parts: &[String],
    written: &str,
) -> Result<String, EditError> {
    let (key, table) = match parts.split_last() {
        Some((key, table)) if !table.is_empty() => (key, table),
        _ => return Err(no_key()),
    };
    match root.find(table) {
        Some(node) if !node.is_table() => Err((
            format!("`{}` has no `{key}` in this file", join(table)),
            "give all three of its numbers".to_owned(),
        )),
        Some(node) => into_table(text, node, key, written),
        None => new_table(schema, text, root, table, &format!("{key} = {written}")),
    }
}

/// Adds a key to a table that stands in the file: after its last value, written like its neighbour.
fn into_table(text: &str, node: &TomlNode, key: &str, written: &str) -> Result<String, EditError> {
    let last = node
        .entries()
        .iter()
        .filter(|entry| !entry.node.is_table() && !holds_tables(&entry.node))
        .max_by_key(|entry| entry.node.span.end);
    if let TomlData::Table(TableForm::Inline, _) = node.data {
        let addition = match last {
            Some(_) => format!(", {key} = {written}"),
            None => format!(" {key} = {written} "),
        };
        let at = last.map_or(node.span.start + 1, |entry| entry.node.span.end);
        return Ok(spliced(text, &(at..at), &addition));
    }
    let (prefix, after) = match last {
        Some(entry) => {
            let line = line_start(text, entry.key_span.start);
            (&text[line..entry.key_span.start], entry.node.span.end)
        }
        None => ("", node.span.end),
    };
    Ok(line_after(
        text,
        after,
        &format!("{prefix}{key} = {written}"),
    ))
}

fn holds_tables(node: &TomlNode) -> bool {
    !node.items().is_empty() && node.is_list_of_tables()
}

/// Adds a table that the file leaves out, with one key, at the end of the file.
fn new_table(
    schema: &'static Schema,
    text: &str,
    root: &TomlNode,
    table: &[String],
    line: &str,
) -> Result<String, EditError> {
    let Some((name, parent)) = table.split_last() else {
        return Err(no_key());
    };
    if schema.fields_at(table).next().is_some() {
        return Err((
            format!(
                "`{}` is not given in this file, so one of its numbers cannot be set",
                join(table)
            ),
            "give all three of its numbers first".to_owned(),
        ));
    }
    let one = schema
        .tables
        .iter()
        .any(|known| known.shape == TableShape::One && known.path == join(table));
    let mark = parent.first().is_some_and(|parent| parent == "marks");
    if !one && !mark {
        let known: Vec<String> = root.find(parent).map_or(Vec::new(), TomlNode::names);
        return Err((
            format!("there is no `{name}` in {}", join(parent)),
            format!("{} has {}", join(parent), known.join(", ")),
        ));
    }
    let end = newline(text);
    let gap = if text.is_empty() || text.ends_with('\n') {
        ""
    } else {
        end
    };
    Ok(format!("{text}{gap}{end}[{}]{end}{line}{end}", join(table)))
}

/// Puts a line after the line in which `offset` stands.
fn line_after(text: &str, offset: usize, line: &str) -> String {
    let end = newline(text);
    match text[offset..].find('\n') {
        Some(rest) => {
            let at = offset + rest + 1;
            spliced(text, &(at..at), &format!("{line}{end}"))
        }
        None => format!("{text}{end}{line}{end}"),
    }
}
