//! The keys of a system file as a tree of values, as the transformations read and change them.

use toml::{Table, Value};

use crate::numerics::V3;

/// The tables of a kind by their names: `points`, `bodies`.
pub(super) fn named<'a>(
    file: &'a mut Table,
    kind: &str,
) -> impl Iterator<Item = (&'a String, &'a mut Table)> {
    let tables = file.get_mut(kind).and_then(Value::as_table_mut);
    let all = tables.into_iter().flat_map(Table::iter_mut);
    all.filter_map(|(name, value)| Some((name, value.as_table_mut()?)))
}

/// The tables of a list in their order: `lines`, `waves`.
pub(super) fn listed<'a>(table: &'a mut Table, kind: &str) -> impl Iterator<Item = &'a mut Table> {
    let rows = table.get_mut(kind).and_then(Value::as_array_mut);
    rows.into_iter().flatten().filter_map(Value::as_table_mut)
}

/// The list itself.
pub(super) fn list<'a>(table: &'a mut Table, kind: &str) -> Option<&'a mut Vec<Value>> {
    table.get_mut(kind)?.as_array_mut()
}

/// A number.
pub(super) fn number(table: &Table, key: &str) -> Option<f64> {
    as_number(table.get(key)?)
}

fn as_number(value: &Value) -> Option<f64> {
    match value {
        Value::Float(number) => Some(*number),
        Value::Integer(number) => Some(*number as f64),
        _ => None,
    }
}

/// A word.
pub(super) fn word<'a>(table: &'a Table, key: &str) -> Option<&'a str> {
    table.get(key)?.as_str()
}

/// Numbers: one, or a list.
pub(super) fn numbers(table: &Table, key: &str) -> Vec<f64> {
    match table.get(key) {
        Some(Value::Array(all)) => all.iter().filter_map(as_number).collect(),
        Some(one) => as_number(one).into_iter().collect(),
        None => Vec::new(),
    }
}

/// Puts a number, a word or a list of numbers in the place of a key.
pub(super) fn put(table: &mut Table, key: &str, value: impl Into<Value>) {
    table.insert(key.to_owned(), value.into());
}

/// Changes a number that is there.
pub(super) fn change(table: &mut Table, key: &str, how: impl Fn(f64) -> f64) {
    if let Some(before) = number(table, key) {
        put(table, key, how(before));
    }
}

/// Changes all of some numbers that are there, one or a list.
pub(super) fn change_each(table: &mut Table, key: &str, how: impl Fn(f64) -> f64) {
    if matches!(table.get(key), Some(Value::Array(_))) {
        let changed: Vec<f64> = numbers(table, key).into_iter().map(how).collect();
        put(table, key, changed);
    } else {
        change(table, key, how);
    }
}

/// Changes three numbers that are there, as a vector.
pub(super) fn change_vector(table: &mut Table, key: &str, how: impl Fn(V3) -> V3) {
    if let [x, y, z] = numbers(table, key)[..] {
        let to = how(V3::new(x, y, z));
        put(table, key, vec![to.x, to.y, to.z]);
    }
}

/// Exchanges two keys, of which either may be absent.
pub(super) fn exchange(table: &mut Table, one: &str, other: &str) {
    let (first, second) = (table.remove(one), table.remove(other));
    for (key, value) in [(other, first), (one, second)] {
        if let Some(value) = value {
            table.insert(key.to_owned(), value);
        }
    }
}

/// Unstretched length of a line \[m\].
pub(super) fn length(line: &Table) -> f64 {
    let sections = line.get("sections").and_then(Value::as_array);
    let sections = sections.into_iter().flatten().filter_map(Value::as_table);
    let in_all: f64 = sections
        .filter_map(|section| number(section, "length_m"))
        .sum();
    number(line, "length_m").unwrap_or(in_all)
}
