//! Key paths of a case: those that stand in it, and what was meant by one that does not.

use crate::case::fields::{Absent, CASE, Field, field_at};
use crate::case::fields::{join, nearest, split, unknown_key};
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
    // A required key that its table lacks is told as missing already.
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
    for field in CASE.fields.iter() {
        let plain = !field.path.contains('*') && matches!(field.absent, Absent::Default(_));
        if plain && !list.iter().any(|known| *known == field.path) {
            list.push(field.path.to_string());
        }
    }
    for (table, names) in [
        ("materials", material_names(root)),
        ("floats", names_of(root, "floats")),
        ("clumps", names_of(root, "clumps")),
        ("modules", names_of(root, "modules")),
    ] {
        let defaults = CASE.fields.iter().filter(|field| {
            field.table() == format!("{table}.*") && matches!(field.absent, Absent::Default(_))
        });
        for field in defaults {
            list.extend(
                names
                    .iter()
                    .map(|name| join(&[table, name.as_str(), field.key()])),
            );
        }
    }
    list
}

pub(super) fn material_names(root: &Node) -> Vec<String> {
    let materials = root.get("materials").map_or(&[] as &[_], Node::entries);
    materials.iter().map(|entry| entry.key.clone()).collect()
}

fn names_of(root: &Node, list: &str) -> Vec<String> {
    named(root, list)
        .into_iter()
        .map(|(name, _)| name)
        .collect()
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

pub(super) fn named<'a>(root: &'a Node, list: &str) -> Vec<(String, &'a Node)> {
    let items = root.get(list).map_or(&[] as &[Node], Node::items);
    element_names(items).into_iter().zip(items).collect()
}
