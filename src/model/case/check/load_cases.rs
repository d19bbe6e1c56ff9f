//! Tables of load cases: keys that exist, values that they take, rows that go together.

use super::existing;
use crate::case::diagnostic::Finding;
use crate::case::effective_inputs::NO_INPUTS;
use crate::case::fields::{Field, Schema, ValueType, check_value};
use crate::case::load_cases::add_up;
use crate::case::model::LoadCaseKeys;
use crate::case::schema::Key;
use crate::case::tree::TomlNode;
use crate::case::value_range::ValueRange;

/// Checks the tables of load cases of a file with this schema.
pub fn of_load_cases(
    schema: &'static Schema,
    root: &TomlNode,
    tables: &[(String, LoadCaseKeys<'_>)],
) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut zipped: Vec<(&str, usize)> = Vec::new();
    for (_, table) in tables {
        let count = match (table.key.is_given(), table.file.is_given()) {
            (true, false) => of_key(schema, root, table, &mut found),
            (false, true) => {
                found.extend(only_a_file(table));
                None
            }
            (true, true) => {
                let problem = "the table has a key and a file";
                found.extend(table.file.if_given(problem, "give each a table of its own"));
                None
            }
            (false, false) => {
                let remedy = "add `key = \"...\"` with `values` or `range`, or `file = \"...\"`";
                found.push(table.key.finding_at_table("the table sets nothing", remedy));
                None
            }
        };
        if let (Some(zip), Some(count)) = (table.zip.get(), count) {
            let known = zipped.iter().find(|(name, _)| name == zip);
            if let Some((_, other)) = known.filter(|(_, other)| *other != count) {
                let problem =
                    format!("goes together with a table of {other} rows, and has {count}");
                found.push(table.zip.finding(problem, "give as many values in each"));
            }
            zipped.push((zip, count));
        }
    }
    found
}

/// A table of one key: the number of its values, where they are known.
fn of_key(
    schema: &'static Schema,
    root: &TomlNode,
    table: &LoadCaseKeys<'_>,
    found: &mut Vec<Finding>,
) -> Option<usize> {
    let field = match varied(schema, root, table.key.get()?) {
        Ok(field) => field,
        Err((problem, remedy)) => {
            found.push(table.key.finding(problem, remedy));
            return None;
        }
    };
    let count = match (table.values.is_given(), table.range.is_given()) {
        (true, false) => {
            let faults = values(&table.values, field);
            let sound = faults.is_empty();
            found.extend(faults);
            table.values.get().filter(|_| sound).map(Vec::len)
        }
        (false, true) => match ValueRange::parse(table.range.get()?, field) {
            Ok(range) => Some(range.values.len()),
            Err(error) => {
                let remedy = "write A..B/N, such as 0.2..0.8/4, or a,b,c";
                found.push(table.range.finding(error.to_string(), remedy));
                None
            }
        },
        _ => {
            let problem = "the table needs the values of its key, once";
            let remedy = "give either `values = [...]` or `range = \"A..B/N\"`";
            found.push(table.key.finding(problem, remedy));
            None
        }
    };
    found.extend(probabilities(table, count));
    count
}

/// A file says all by itself.
fn only_a_file(table: &LoadCaseKeys<'_>) -> Vec<Finding> {
    let problem = "belongs to a key, and the file has its own";
    let remedy = "leave it out; the file may have a column `probability`";
    let given = [
        table.values.if_given(problem, remedy),
        table.range.if_given(problem, remedy),
        table.probability.if_given(problem, remedy),
    ];
    given.into_iter().flatten().collect()
}

fn probabilities(table: &LoadCaseKeys<'_>, count: Option<usize>) -> Option<Finding> {
    let given = table.probability.get()?;
    if let Some(count) = count.filter(|count| *count != given.len()) {
        let problem = format!("there are {} probabilities of {count} values", given.len());
        return Some(
            table
                .probability
                .finding(problem, "give one for each value"),
        );
    }
    (!add_up(given)).then(|| {
        let sum: f64 = given.iter().sum();
        let problem = format!("the probabilities add up to {sum}");
        table.probability.finding(problem, "let them add up to 1")
    })
}

/// Whether studies and load cases may set a key: it takes one number, or words that are an input.
pub fn takes_values(path: &str, field: &Field) -> bool {
    let mut tables = path.split('.');
    let is_input = tables
        .next()
        .is_some_and(|table| !NO_INPUTS.contains(&table));
    let takes_words = match field.kind {
        ValueType::Choice(_) | ValueType::Boolean => true,
        ValueType::Text => is_input,
        _ => false,
    };
    field.takes_number() || takes_words
}

/// The field of a key that studies and load cases may set: one number, or one of some words.
pub(crate) fn varied(
    schema: &'static Schema,
    root: &TomlNode,
    key: &str,
) -> Result<&'static Field, (String, String)> {
    variable(key, existing(schema, root, key)?)
}

/// The field, if studies and load cases may set its key.
pub(crate) fn variable(
    key: &str,
    field: &'static Field,
) -> Result<&'static Field, (String, String)> {
    if takes_values(key, field) {
        return Ok(field);
    }
    let problem = format!("`{key}` is not a number, so it cannot be varied");
    let remedy = match field.kind {
        ValueType::Triple => format!("vary one of its numbers: `{key}.x`, `{key}.y` or `{key}.z`"),
        _ => "name a key that takes one number, or words".to_owned(),
    };
    Err((problem, remedy))
}

/// Values that a key does not take.
pub(super) fn values<T>(key: &Key<'_, Vec<T>>, field: &Field) -> Vec<Finding>
where
    Vec<T>: crate::case::schema::KeyValue,
{
    let items = key.items().iter().enumerate();
    let wrong = items.filter_map(|(index, item)| {
        // A switch stands here as a word, since a list holds numbers or words.
        let is_switch =
            field.kind == ValueType::Boolean && matches!(item.text(), Some("true" | "false"));
        let fault = check_value(field, item).err().filter(|_| !is_switch);
        let fault = fault.filter(|_| item.number().is_some() || item.text().is_some())?;
        Some(key.finding_at_item(index, fault.problem, fault.remedy))
    });
    wrong.collect()
}
