//! What a file is made of, as a list of its tables.

use super::tables::table_of;
use crate::fields::{Schema, TableSchema, TableShape, ValueType, join};
use crate::tree::{TomlData, TomlNode, element_names};

/// A table of a file, or the place for tables of a kind that may be several.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutlineRow {
    /// Key path: `materials.chain`; of a heading `materials`.
    pub path: String,
    /// How many tables it is in.
    pub depth: usize,
    /// Its name, or that of its kind.
    pub name: String,
    /// What it is, by its first keys.
    pub summary: String,
    /// True for the heading of tables of a kind.
    pub is_heading: bool,
    /// Help on tables of its kind.
    pub help: &'static str,
}

/// Keys that a summary leaves out.
const LEFT_OUT: [&str; 7] = [
    "name", "title", "source", "notes", "reason", "data", "sha256",
];

/// The tables of a text in the order of their declaration. A text that is not TOML has none.
#[must_use]
pub fn outline(schema: &'static Schema, text: &str) -> Vec<OutlineRow> {
    let Ok(tree) = TomlNode::parse(text) else {
        return Vec::new();
    };
    let mut rows = Vec::new();
    inside(schema, text, &tree, "", &mut Vec::new(), &mut rows);
    rows
}

fn inside(
    schema: &'static Schema,
    text: &str,
    node: &TomlNode,
    pattern: &str,
    path: &mut Vec<String>,
    rows: &mut Vec<OutlineRow>,
) {
    for table in schema.tables_in(pattern) {
        let Some(found) = node.get(table.key()).filter(|_| table.key() != "files") else {
            continue;
        };
        path.push(table.key().to_owned());
        let depth = path.len() - 1;
        match (table.shape, &found.data) {
            (TableShape::One, TomlData::Table(..)) => {
                rows.push(row(schema, text, table, found, path, depth));
                inside(schema, text, found, &table.pattern(), path, rows);
            }
            (TableShape::ByName, TomlData::Table(_, entries)) => {
                rows.push(heading(table, path, depth));
                for entry in entries.iter().filter(|entry| entry.node.is_table()) {
                    path.push(entry.key.clone());
                    rows.push(row(schema, text, table, &entry.node, path, depth + 1));
                    inside(schema, text, &entry.node, &table.pattern(), path, rows);
                    path.pop();
                }
            }
            (TableShape::List, TomlData::List(items)) => {
                rows.push(heading(table, path, depth));
                for (item, name) in items.iter().zip(element_names(items)) {
                    path.push(name);
                    rows.push(row(schema, text, table, item, path, depth + 1));
                    inside(schema, text, item, &table.pattern(), path, rows);
                    path.pop();
                }
            }
            _ => {}
        }
        path.pop();
    }
}

fn heading(table: &TableSchema, path: &[String], depth: usize) -> OutlineRow {
    OutlineRow {
        path: join(path),
        depth,
        name: table.key().replace('_', " "),
        summary: String::new(),
        is_heading: true,
        help: table.help,
    }
}

fn row(
    schema: &'static Schema,
    text: &str,
    table: &TableSchema,
    node: &TomlNode,
    path: &[String],
    depth: usize,
) -> OutlineRow {
    let name = path.last().cloned().unwrap_or_default();
    OutlineRow {
        path: join(path),
        depth,
        name: match table.shape {
            TableShape::One => name.replace('_', " "),
            _ => name,
        },
        summary: summary(schema, text, node, path),
        is_heading: false,
        help: table.help,
    }
}

/// The first keys of a table that say something, with their units.
fn summary(schema: &'static Schema, text: &str, node: &TomlNode, path: &[String]) -> String {
    const KEYS: usize = 4;
    const LONGEST: usize = 24;
    let Some((table, _)) = table_of(schema, path) else {
        return String::new();
    };
    let pattern = table.pattern();
    let words = node.entries().iter().filter_map(|entry| {
        let field = schema
            .fields_of(&pattern)
            .find(|field| field.key() == entry.key || field.key() == "*")?;
        if LEFT_OUT.contains(&entry.key.as_str()) {
            return None;
        }
        let value = match entry.node.text() {
            Some(text) => text.to_owned(),
            None => text.get(entry.node.span.clone())?.to_owned(),
        };
        let says_itself = matches!(field.kind, ValueType::Name | ValueType::Choice(_));
        let label = match (says_itself, field.key()) {
            (true, _) => String::new(),
            (false, "*") => format!("{} ", entry.key),
            (false, _) => format!("{} ", field.label),
        };
        let unit = match field.unit {
            "" | "-" => String::new(),
            unit => format!(" {unit}"),
        };
        let value = value.split_whitespace().collect::<Vec<_>>().join(" ");
        (value.chars().count() <= LONGEST).then(|| format!("{label}{value}{unit}"))
    });
    words.take(KEYS).collect::<Vec<_>>().join(", ")
}
