//! A schema of files as a JSON Schema, by which editors complete and check them.

use serde_json::{Map, Value, json};

use super::parameters_table::ANY_KEY;
use super::{AbsentValue, Field, Schema, TableSchema, TableShape, ValueType};
use crate::tree::{TomlData, TomlNode};

/// The schema as a JSON Schema, draft 2020-12, of files converted from TOML to JSON.
#[must_use]
pub fn json_schema(schema: &'static Schema) -> Value {
    let mut root = table_schema(schema, "");
    root.insert(
        "$schema".to_owned(),
        json!("https://json-schema.org/draft/2020-12/schema"),
    );
    root.insert(
        "title".to_owned(),
        json!(format!("seacable {}", schema.what)),
    );
    Value::Object(root)
}

/// A table with the fields and the tables of a pattern.
fn table_schema(schema: &'static Schema, pattern: &str) -> Map<String, Value> {
    let fields: Vec<&Field> = schema.fields_of(pattern).collect();
    let mut properties = Map::new();
    let mut required = Vec::new();
    let mut rules = Vec::new();
    let (named, any): (Vec<&Field>, Vec<&Field>) = fields
        .iter()
        .filter(|field| field.only_if.is_none())
        .partition(|field| field.key() != ANY_KEY);
    for field in named {
        properties.insert(field.key().to_owned(), value_schema(field));
        match field.absent {
            AbsentValue::Required => required.push(field.key()),
            AbsentValue::RequiredWithout(other) => {
                rules.push(
                    json!({ "anyOf": [{ "required": [field.key()] }, { "required": [other] }] }),
                );
            }
            AbsentValue::Default(_) | AbsentValue::Means(_) => {}
        }
    }
    for field in fields.iter().filter(|field| field.only_if.is_some()) {
        let alike = fields
            .iter()
            .filter(|other| other.key() == field.key())
            .count();
        let known = if alike == 1 {
            value_schema(field)
        } else {
            json!({ "description": description(field) })
        };
        properties.entry(field.key()).or_insert(known);
    }
    for table in schema.tables_in(pattern) {
        let key = table.key();
        properties.insert(key.to_owned(), tables_schema(schema, table));
        if table.required {
            required.push(key);
        }
    }
    rules.extend(conditions(&fields));
    let mut object = Map::new();
    object.insert("type".to_owned(), json!("object"));
    object.insert("properties".to_owned(), Value::Object(properties));
    object.insert("required".to_owned(), json!(required));
    let others = any
        .first()
        .map_or(json!(false), |field| value_schema(field));
    object.insert("additionalProperties".to_owned(), others);
    if !rules.is_empty() {
        object.insert("allOf".to_owned(), Value::Array(rules));
    }
    object
}

/// One table, tables by name, or a list of tables.
fn tables_schema(schema: &'static Schema, table: &'static TableSchema) -> Value {
    let mut inner = table_schema(schema, &table.pattern());
    let least = usize::from(table.required);
    match table.shape {
        TableShape::One => {
            inner.insert("description".to_owned(), json!(table.help));
            Value::Object(inner)
        }
        TableShape::ByName => json!({
            "description": table.help, "type": "object", "minProperties": least, "additionalProperties": inner,
        }),
        TableShape::List => json!({
            "description": table.help, "type": "array", "minItems": least, "items": inner,
        }),
    }
}

/// The fields that exist only where another key of their table is a certain word: how they are written there, and that
/// they are not elsewhere.
fn conditions(fields: &[&Field]) -> Vec<Value> {
    let mut groups: Vec<(&str, &str)> = fields.iter().filter_map(|field| field.only_if).collect();
    groups.dedup();
    let mut rules: Vec<Value> = Vec::new();
    for &(tag, word) in &groups {
        let here = fields
            .iter()
            .filter(|field| field.only_if == Some((tag, word)));
        let written: Map<String, Value> = here
            .clone()
            .map(|field| (field.key().to_owned(), value_schema(field)))
            .collect();
        let needed = here.filter(|field| field.absent == AbsentValue::Required);
        let needed: Vec<&str> = needed.map(|field| field.key()).collect();
        rules.push(json!({
            "if": is_one_of(fields, tag, &[word]),
            "then": { "properties": written, "required": needed },
        }));
    }
    let mut done: Vec<&str> = Vec::new();
    for field in fields {
        let (Some((tag, _)), false) = (field.only_if, done.contains(&field.key())) else {
            continue;
        };
        done.push(field.key());
        let alike = fields.iter().filter(|other| other.key() == field.key());
        let words: Vec<&str> = alike.filter_map(|other| Some(other.only_if?.1)).collect();
        rules.push(json!({
            "if": is_one_of(fields, tag, &words),
            "else": { "properties": { field.key(): false } },
        }));
    }
    rules
}

/// That a key is one of some words; a key that is not given is its default.
fn is_one_of(fields: &[&Field], tag: &str, words: &[&str]) -> Value {
    let declared = fields.iter().find(|field| field.key() == tag);
    let default = declared.and_then(|field| match field.absent {
        AbsentValue::Default(text) => Some(text.trim_matches('"')),
        _ => None,
    });
    let needed: &[&str] = match default {
        Some(default) if words.contains(&default) => &[],
        _ => &[tag],
    };
    json!({ "properties": { tag: { "enum": words } }, "required": needed })
}

/// What may be written for a field.
fn value_schema(field: &Field) -> Value {
    let number = || number_schema(field, "number");
    let word = |words: &[&str]| json!({ "enum": words });
    let list = |least: usize, most: Option<usize>| {
        let mut list = json!({ "type": "array", "items": number(), "minItems": least });
        if let Some(most) = most {
            list["maxItems"] = json!(most);
        }
        list
    };
    let texts = || json!({ "type": "array", "items": { "type": "string" }, "minItems": 1 });
    let mut value = match field.kind {
        ValueType::Number => number(),
        ValueType::Integer => number_schema(field, "integer"),
        ValueType::Boolean => json!({ "type": "boolean" }),
        ValueType::Text => json!({ "type": "string" }),
        ValueType::Name => json!({ "type": "string", "pattern": "^[\\p{L}\\p{N}_-]+$" }),
        ValueType::Choice(words) => word(words),
        ValueType::NumberOrChoice(words) => json!({ "anyOf": [number(), word(words)] }),
        ValueType::NumberOrList => json!({ "anyOf": [number(), list(1, None)] }),
        ValueType::NumberOrTriple => json!({ "anyOf": [number(), list(3, Some(3))] }),
        ValueType::List => list(1, None),
        ValueType::Pair => list(2, Some(2)),
        ValueType::Triple => list(3, Some(3)),
        ValueType::Words => texts(),
        ValueType::NumberOrText => json!({ "anyOf": [number(), { "type": "string" }] }),
        ValueType::NumbersOrWords => json!({ "anyOf": [list(1, None), texts()] }),
    };
    value["description"] = json!(description(field));
    if let AbsentValue::Default(text) = field.absent
        && let Some(default) = TomlNode::parse_value(text)
    {
        value["default"] = json_of(&default);
    }
    value
}

fn number_schema(field: &Field, name: &str) -> Value {
    let range = field.range;
    // Numbers may be written as expressions of parameters.
    let mut number = json!({ "type": [name, "string"] });
    if range.min.is_finite() {
        let least = if range.min_excluded {
            "exclusiveMinimum"
        } else {
            "minimum"
        };
        number[least] = json!(range.min);
    }
    if range.max.is_finite() {
        number["maximum"] = json!(range.max);
    }
    number
}

fn json_of(node: &TomlNode) -> Value {
    match &node.data {
        TomlData::Text(text) => json!(text),
        TomlData::Integer(value) => json!(value),
        TomlData::Float(value) => json!(value),
        TomlData::Boolean(value) => json!(value),
        _ => node.items().iter().map(json_of).collect(),
    }
}

/// Label, help, unit and what holds without the key, in a sentence or two.
fn description(field: &Field) -> String {
    let mut text = format!("{} {}", super::field::capital(field.label), field.help);
    if !matches!(field.unit, "" | "-") {
        text += &format!(" Unit: {}.", field.unit);
    }
    if let AbsentValue::Means(meaning) = field.absent {
        text += &format!(" Without it: {meaning}.");
    }
    if let Some(condition) = field.condition() {
        text += &format!(" {}", super::field::capital(&condition));
    }
    text
}
