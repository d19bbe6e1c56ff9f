//! A system whose lines, points, bodies and materials have other names and another order.

use std::collections::BTreeMap;

use toml::{Table, Value};

use super::tree::{list, listed, named};
use super::variant::SystemVariant;

type NewNames = BTreeMap<String, String>;

pub(super) fn reordered(system: &Table) -> SystemVariant {
    let mut variant = SystemVariant::of_file(system.clone());
    let file = &mut variant.file;
    let lines: Vec<String> = listed(file, "lines")
        .filter_map(|line| Some(line.get("name")?.as_str()?.to_owned()))
        .collect();
    let lines = names(lines.into_iter(), "x");
    let materials = renamed(file, "materials", "m");
    let points = renamed(file, "points", "q");
    let bodies = renamed(file, "bodies", "w");
    let rods = renamed(file, "rods", "z");
    let ends = rods.iter().flat_map(|(old, new)| {
        ["a", "b"].map(|end| (format!("{old}-{end}"), format!("{new}-{end}")))
    });
    let points: NewNames = points.into_iter().chain(ends).collect();
    let carriers: NewNames = bodies
        .iter()
        .chain(&rods)
        .map(|(a, b)| (a.clone(), b.clone()))
        .collect();
    for (_, point) in named(file, "points") {
        replace(point, "body", &carriers);
    }
    for kind in ["bodies", "rods"] {
        for (_, body) in named(file, kind) {
            replace(body, "pinned_to", &carriers);
        }
    }
    for line in listed(file, "lines") {
        replace(line, "name", &lines);
        replace(line, "from", &points);
        replace(line, "to", &points);
        replace(line, "material", &materials);
        for section in listed(line, "sections") {
            replace(section, "material", &materials);
        }
    }
    for payout in listed(file, "payouts") {
        replace(payout, "line", &lines);
    }
    for kind in ["lines", "waves"] {
        if let Some(rows) = list(file, kind) {
            rows.reverse();
        }
    }
    for (old, new) in lines {
        for end in ['a', 'b'] {
            variant.ends.insert((old.clone(), end), (new.clone(), end));
        }
    }
    variant.parts = points.into_iter().chain(carriers).collect();
    variant
}

/// Other names in the opposite order.
fn names(old: impl Iterator<Item = String>, letter: &str) -> NewNames {
    let numbered = old.enumerate();
    numbered
        .map(|(k, old)| (old, format!("{letter}{:03}", 900 - k)))
        .collect()
}

/// Gives the tables of a kind other names.
fn renamed(file: &mut Table, kind: &str, letter: &str) -> NewNames {
    let Some(tables) = file.get_mut(kind).and_then(Value::as_table_mut) else {
        return NewNames::new();
    };
    let names = names(tables.keys().cloned(), letter);
    let before = std::mem::take(tables);
    for (old, table) in before {
        let new = names.get(&old).cloned().unwrap_or(old);
        tables.insert(new, table);
    }
    names
}

fn replace(table: &mut Table, key: &str, names: &NewNames) {
    let new = table
        .get(key)
        .and_then(Value::as_str)
        .and_then(|old| names.get(old));
    if let Some(new) = new.cloned() {
        table.insert(key.to_owned(), new.into());
    }
}
