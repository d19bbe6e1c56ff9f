//! Every table and value of a file against the fields of its kind: unknown keys, missing units,
//! wrong types, numbers out of range, required keys that are not there.

use std::ops::Range;

use super::super::fields::parameters_table::ANY_KEY;
use crate::diagnostic::Finding;
use crate::fields::{
    AbsentValue, Field, Schema, TableSchema, TableShape, check_value, join, unknown_key,
};
use crate::tree::{TomlEntry, TomlNode, element_names};

/// Checks the whole document.
pub fn check(schema: &'static Schema, root: &TomlNode) -> Vec<Finding> {
    let mut walk = KeyChecker {
        schema,
        found: Vec::new(),
    };
    walk.table(root, "", &mut Vec::new());
    walk.found
}

struct KeyChecker {
    schema: &'static Schema,
    found: Vec<Finding>,
}

impl KeyChecker {
    fn report(
        &mut self,
        span: &Range<usize>,
        path: &[String],
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) {
        let finding = Finding::new(span, join(path), problem, remedy);
        self.found.push(finding);
    }

    /// A table instance: `pattern` is the pattern of the table, `path` its own key path.
    fn table(&mut self, node: &TomlNode, pattern: &str, path: &mut Vec<String>) {
        let known = fields_here(self.schema, node, pattern);
        let mut meant = Vec::new();
        for entry in node.entries() {
            path.push(entry.key.clone());
            let same =
                |field: &&&'static Field| [entry.key.as_str(), ANY_KEY].contains(&field.key());
            if let Some(field) = known.iter().find(same) {
                self.value(field, entry, path);
            } else if let Some(table) = subtable(self.schema, pattern, &entry.key) {
                self.subtables(table, entry, path);
            } else {
                meant.extend(self.unknown(entry, pattern, &known, path));
            }
            path.pop();
        }
        for field in known {
            let required = match field.absent {
                AbsentValue::Required => exists(self.schema, field, node) == Some(true),
                AbsentValue::RequiredWithout(other) => node.get(other).is_none(),
                AbsentValue::Default(_) | AbsentValue::Means(_) => false,
            };
            if required && node.get(field.key()).is_none() && !meant.contains(&field.key()) {
                self.missing_field(field, node, path);
            }
        }
        self.missing_tables(node, pattern, path);
    }

    fn value(&mut self, field: &Field, entry: &TomlEntry, path: &[String]) {
        if let Err(error) = check_value(field, &entry.node) {
            self.report(&error.span, path, error.problem, error.remedy);
        }
    }

    fn subtables(
        &mut self,
        table: &'static TableSchema,
        entry: &TomlEntry,
        path: &mut Vec<String>,
    ) {
        let inner = table.pattern();
        match table.shape {
            TableShape::One if entry.node.is_table() => {
                self.table(&entry.node, &inner, path);
            }
            TableShape::ByName if entry.node.is_table() => {
                self.empty(table, &entry.node, path);
                for named in entry.node.entries() {
                    path.push(named.key.clone());
                    if named.node.is_table() {
                        self.table(&named.node, &inner, path);
                    } else {
                        self.not_a_table(table, &named.node, path);
                    }
                    path.pop();
                }
            }
            TableShape::List if entry.node.is_list_of_tables() => {
                self.empty(table, &entry.node, path);
                let items = entry.node.items();
                for (item, name) in items.iter().zip(element_names(items)) {
                    path.push(name);
                    self.table(item, &inner, path);
                    path.pop();
                }
            }
            _ => self.not_a_table(table, &entry.node, path),
        }
    }

    /// A required list of tables that holds none.
    fn empty(&mut self, table: &TableSchema, node: &TomlNode, path: &[String]) {
        if table.required && node.items().is_empty() && node.entries().is_empty() {
            let remedy = format!("add {}", table.header());
            self.report(&node.span, path, "is empty", remedy);
        }
    }

    fn not_a_table(&mut self, table: &TableSchema, node: &TomlNode, path: &[String]) {
        let (header, what) = (table.header(), node.describe());
        let problem = format!("must be written as {header}, and is {what}");
        self.report(&node.span, path, problem, format!("write {header}"));
    }

    /// Reports an unknown key; returns the key that was meant, when that is clear.
    fn unknown(
        &mut self,
        entry: &TomlEntry,
        pattern: &str,
        known: &[&'static Field],
        path: &[String],
    ) -> Option<&'static str> {
        let wrong_kind = self
            .schema
            .fields
            .iter()
            .find(|field| field.table() == pattern && field.key() == entry.key)
            .and_then(|field| field.only_if);
        if let Some((key, wanted)) = wrong_kind {
            let problem = format!("belongs to a table with {key} = \"{wanted}\"");
            let remedy = format!("remove it, or set {key} = \"{wanted}\"");
            self.report(&entry.key_span, path, problem, remedy);
            return None;
        }
        let mut absent = self.schema.absent.iter();
        if let Some(why) = absent.find(|absent| absent.table == pattern && absent.key == entry.key)
        {
            self.report(&entry.key_span, path, why.problem, why.remedy);
            return None;
        }
        let tables: Vec<&str> = self
            .schema
            .tables_in(pattern)
            .map(TableSchema::key)
            .collect();
        let said = unknown_key(self.schema, &entry.key, known, &tables);
        self.report(&entry.key_span, path, said.problem, said.remedy);
        said.meant
    }

    fn missing_field(&mut self, field: &Field, node: &TomlNode, path: &mut Vec<String>) {
        path.push(field.key().to_owned());
        let remedy = format!(
            "add `{} = ...` ({}): {}",
            field.key(),
            field.label,
            field.range_text()
        );
        self.report(&node.span, path, "is missing", remedy);
        path.pop();
    }

    fn missing_tables(&mut self, node: &TomlNode, pattern: &str, path: &mut Vec<String>) {
        for table in self.schema.tables_in(pattern) {
            let key = table.key();
            if table.required && node.get(key).is_none() {
                path.push(key.to_owned());
                let remedy = format!("add {}: {}", table.header(), table.help);
                self.report(&node.span, path, "is missing", remedy);
                path.pop();
            }
        }
    }
}

/// The fields a table of this pattern has, given what its own keys say.
pub fn fields_here(schema: &'static Schema, node: &TomlNode, pattern: &str) -> Vec<&'static Field> {
    schema
        .fields_of(pattern)
        .filter(|field| exists(schema, field, node) != Some(false))
        .collect()
}

/// Whether this table has the field at all; nothing when the key that decides it is itself wrong or missing. A key that is
/// left out decides by its default.
fn exists(schema: &'static Schema, field: &Field, node: &TomlNode) -> Option<bool> {
    let Some((key, wanted)) = field.only_if else {
        return Some(true);
    };
    let decides = schema
        .fields_of(field.table())
        .find(|other| other.key() == key)?;
    match (node.get(key), decides.absent) {
        (Some(deciding), _) => {
            check_value(decides, deciding).ok()?;
            Some(deciding.text() == Some(wanted))
        }
        (None, AbsentValue::Default(value)) => Some(value.trim_matches('"') == wanted),
        (None, _) => None,
    }
}

/// The table of this key in a table of this pattern.
pub fn subtable(schema: &'static Schema, pattern: &str, key: &str) -> Option<&'static TableSchema> {
    schema.tables_in(pattern).find(|table| table.key() == key)
}
