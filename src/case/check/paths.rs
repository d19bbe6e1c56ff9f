//! Key paths of a case: those that stand in it, and what was meant by one that does not.

use crate::case::fields::{Absent, Field};
use crate::case::fields::{join, nearest, split, unknown_key};
use crate::case::model::{CASE, field_at};
use crate::case::tree::{Data, Node, element_names};

/// The field of a key path whose table stands in the file.
pub(super) fn existing(root: &Node, path: &str) -> Result<&'static Field, (String, String)> {
    let unknown = |remedy: String| (format!("there is no key `{path}` in this case"), remedy);
    let Some(parts) = split(path) else {
        return Err(unknown(
            "write a key path such as `current.speed_m_per_s`".to_owned(),
        ));
    };
    let here = given_or_defaulted(root);
    let Some(field) = field_at(&parts) else {
        return Err(unknown(near_path(path, &here)));
    };
    if here.iter().any(|known| *known == join(&parts)) {
        return Ok(field);
    }
    // A required key that its table lacks is reported as missing already.
    let remedy = match (root.find(&parts[..parts.len() - 1]), field.absent) {
        (Some(_), Absent::Required | Absent::RequiredWithout(_)) => return Ok(field),
        (Some(_), Absent::Means(_)) => "give the key a value in this file first".to_owned(),
        _ => near_path(path, &here),
    };
    Err(unknown(remedy))
}

/// What to say of a key path that no field has.
pub(crate) fn unknown_path(root: &Node, path: &str) -> (String, String) {
    let remedy = split(path).and_then(|parts| right_key(root, &parts));
    let problem = format!("there is no key `{path}` in a case");
    let remedy = remedy.unwrap_or_else(|| near_path(path, &given_or_defaulted(root)));
    (problem, remedy)
}

/// The remedy for a last part that its table does not know, when the table is there.
fn right_key(root: &Node, parts: &[String]) -> Option<String> {
    let (key, table) = parts.split_last()?;
    let known = CASE.fields.iter().filter(|field| {
        let mut path = table.to_vec();
        path.push(field.key().to_owned());
        field_at(&path).is_some_and(|found| found.path == field.path)
    });
    let known: Vec<&'static Field> = known.collect();
    if known.is_empty() || root.find(table).is_none() {
        return None;
    }
    Some(unknown_key(&CASE, key, &known, &[]).remedy)
}

fn near_path(path: &str, here: &[String]) -> String {
    match nearest(path, here.iter().map(String::as_str)) {
        Some(near) => format!("did you mean `{near}`?"),
        None => "name a key as in `materials.<name>.ea_n`, `line.<section>.length_m`, `ends.b.position_m`".to_owned(),
    }
}

/// Key paths with a value: those given, and those left to their default.
fn given_or_defaulted(root: &Node) -> Vec<String> {
    let mut list = Vec::new();
    collect(root, &mut Vec::new(), &mut list);
    let defaults = CASE.fields.iter();
    for field in defaults.filter(|field| matches!(field.absent, Absent::Default(_))) {
        match field.table().strip_suffix(".*") {
            Some(table @ ("materials" | "floats" | "clumps" | "modules")) => {
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
pub(super) fn names(root: &Node, table: &str) -> Vec<String> {
    root.get(table).map_or_else(Vec::new, Node::names)
}

fn collect(node: &Node, path: &mut Vec<String>, list: &mut Vec<String>) {
    match &node.data {
        Data::Table(_, entries) => {
            for entry in entries {
                path.push(entry.key.clone());
                collect(&entry.node, path, list);
                path.pop();
            }
        }
        Data::List(items) if !items.is_empty() && node.is_list_of_tables() => {
            for (item, name) in items.iter().zip(element_names(items)) {
                path.push(name);
                collect(item, path, list);
                path.pop();
            }
        }
        _ => list.push(join(path)),
    }
}
