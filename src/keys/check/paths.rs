//! Key paths of a file: those that stand in it, and what was meant by one that does not.

use crate::diagnostic::Finding;
use crate::fields::{AbsentValue, Field, Schema, join, nearest, split, unknown_key};
use crate::schema::TableNode;
use crate::tree::{TomlData, TomlNode, element_names};

/// The field of a key path whose table stands in the file.
pub fn existing(
    schema: &'static Schema,
    root: &TomlNode,
    path: &str,
) -> Result<&'static Field, (String, String)> {
    let problem = || format!("there is no key `{path}` in this {}", schema.what);
    let unknown = |remedy: String| (problem(), remedy);
    let Some(parts) = split(path) else {
        return Err(unknown(
            "write a key path such as `current.speed_m_per_s`".to_owned(),
        ));
    };
    let field = schema.fields_at(&parts).next();
    // Most are given: the list of all keys is long.
    if let Some(field) = field.filter(|_| is_given(root, &parts)) {
        return Ok(field);
    }
    let here = given_or_defaulted(schema, root);
    let Some(field) = field else {
        return Err(unknown(near_path(schema, path, &here)));
    };
    if here.iter().any(|known| *known == join(&parts)) {
        return Ok(field);
    }
    // A required key that its table lacks is reported as missing already.
    let remedy = match (root.find(&parts[..parts.len() - 1]), field.absent) {
        (Some(_), AbsentValue::Required | AbsentValue::RequiredWithout(_)) => return Ok(field),
        (Some(_), AbsentValue::Means(_)) => "give the key a value in this file first".to_owned(),
        _ => near_path(schema, path, &here),
    };
    Err(unknown(remedy))
}

/// What to say of a key path that no field has.
pub fn unknown_path(schema: &'static Schema, root: &TomlNode, path: &str) -> (String, String) {
    let remedy = split(path).and_then(|parts| right_key(schema, root, &parts));
    let problem = format!("there is no key `{path}` in a {}", schema.what);
    let near = || near_path(schema, path, &given_or_defaulted(schema, root));
    let remedy = remedy.unwrap_or_else(near);
    (problem, remedy)
}

/// The remedy for a last part that its table does not know, when the table is there.
fn right_key(schema: &'static Schema, root: &TomlNode, parts: &[String]) -> Option<String> {
    let (key, table) = parts.split_last()?;
    let known = schema.fields.iter().filter(|field| {
        let mut path = table.to_vec();
        path.push(field.key().to_owned());
        schema
            .fields_at(&path)
            .next()
            .is_some_and(|found| found.path == field.path)
    });
    let known: Vec<&'static Field> = known.collect();
    if known.is_empty() || root.find(table).is_none() {
        return None;
    }
    Some(unknown_key(schema, key, &known, &[]).remedy)
}

fn near_path(schema: &Schema, path: &str, here: &[String]) -> String {
    match nearest(path, here.iter().map(String::as_str)) {
        Some(near) => format!("did you mean `{near}`?"),
        None => schema.example.to_owned(),
    }
}

/// Whether a key path has a value in the file.
fn is_given(root: &TomlNode, parts: &[String]) -> bool {
    let value = parts.split_last().and_then(|(key, table)| {
        let table = root.find(table)?;
        let is_table = matches!(table.data, TomlData::Table(..));
        table.get(key).filter(|_| is_table)
    });
    value.is_some_and(|value| match &value.data {
        TomlData::Table(..) => false,
        TomlData::List(items) => items.is_empty() || !value.is_list_of_tables(),
        _ => true,
    })
}

/// Key paths with a value: those given, and those left to their default.
fn given_or_defaulted(schema: &'static Schema, root: &TomlNode) -> Vec<String> {
    let mut list = Vec::new();
    collect(root, &mut Vec::new(), &mut list);
    let defaults = schema.fields.iter();
    for field in defaults.filter(|field| matches!(field.absent, AbsentValue::Default(_))) {
        match field.table().strip_suffix(".*") {
            Some(table) if !table.contains('*') => {
                let names = names(root, table);
                list.extend(names.iter().map(|name| join(&[table, name, field.key()])));
            }
            None if !field.path.contains('*') => list.push(field.path.to_string()),
            _ => {}
        }
    }
    list
}

/// The names by which the tables below a key go.
pub fn names(root: &TomlNode, table: &str) -> Vec<String> {
    root.get(table).map_or_else(Vec::new, TomlNode::names)
}

fn collect(node: &TomlNode, path: &mut Vec<String>, list: &mut Vec<String>) {
    match &node.data {
        TomlData::Table(_, entries) => {
            for entry in entries {
                path.push(entry.key.clone());
                collect(&entry.node, path, list);
                path.pop();
            }
        }
        TomlData::List(items) if !items.is_empty() && node.is_list_of_tables() => {
            for (item, name) in items.iter().zip(element_names(items)) {
                path.push(name);
                collect(item, path, list);
                path.pop();
            }
        }
        _ => list.push(join(path)),
    }
}

/// Marks of keys that the file does not have.
pub fn marks(schema: &'static Schema, root: &TomlNode) -> Vec<Finding> {
    let Some(table) = root.get("marks") else {
        return Vec::new();
    };
    let place = TableNode::root(root).inner(table, "marks");
    let lost = table.entries().iter().filter_map(|mark| {
        let (problem, remedy) = existing(schema, root, &mark.key).err()?;
        let path = place.key(&mark.key);
        Some(Finding::new(&mark.key_span, path, problem, remedy))
    });
    lost.collect()
}
