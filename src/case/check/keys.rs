//! Every table and value of a file against the fields of its kind: unknown keys, missing units,
//! wrong types, numbers out of range, required keys that are not there.

use crate::case::diagnostic::Finding;
use crate::case::fields::check_value;
use crate::case::fields::{Absent, Field, Schema, Table, TableShape};
use crate::case::fields::{join, unknown_key};
use crate::case::tree::{Entry, Node, element_names};

/// Checks the whole document.
pub(crate) fn check(schema: &'static Schema, root: &Node) -> Vec<Finding> {
    let mut walk = Walk {
        schema,
        found: Vec::new(),
    };
    walk.table(root, "", &mut Vec::new());
    walk.found
}

struct Walk {
    schema: &'static Schema,
    found: Vec<Finding>,
}

impl Walk {
    /// A table instance: `pattern` is the pattern of the table, `path` its own key path.
    fn table(&mut self, node: &Node, pattern: &str, path: &mut Vec<String>) {
        let known = fields_here(self.schema, node, pattern);
        let mut meant = Vec::new();
        for entry in node.entries() {
            path.push(entry.key.clone());
            if let Some(field) = known.iter().find(|field| field.key() == entry.key) {
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
                Absent::Required => exists(self.schema, field, node) == Some(true),
                Absent::RequiredWithout(other) => node.get(other).is_none(),
                Absent::Default(_) | Absent::Means(_) => false,
            };
            if required && node.get(field.key()).is_none() && !meant.contains(&field.key()) {
                self.missing_field(field, node, path);
            }
        }
        self.missing_tables(node, pattern, path);
    }

    fn value(&mut self, field: &Field, entry: &Entry, path: &[String]) {
        if let Err(fault) = check_value(field, &entry.node) {
            let finding = Finding::new(&fault.span, join(path), fault.problem, fault.remedy);
            self.found.push(finding);
        }
    }

    fn subtables(&mut self, table: &'static Table, entry: &Entry, path: &mut Vec<String>) {
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
    fn empty(&mut self, table: &Table, node: &Node, path: &[String]) {
        if table.required && node.items().is_empty() && node.entries().is_empty() {
            let finding = Finding::new(
                &node.span,
                join(path),
                "is empty",
                format!("add {}", table.header()),
            );
            self.found.push(finding);
        }
    }

    fn not_a_table(&mut self, table: &Table, node: &Node, path: &[String]) {
        let problem = format!(
            "must be written as {}, and is {}",
            table.header(),
            node.describe()
        );
        let finding = Finding::new(
            &node.span,
            join(path),
            problem,
            format!("write {}", table.header()),
        );
        self.found.push(finding);
    }

    /// Reports an unknown key; returns the key that was meant, when that is clear.
    fn unknown(
        &mut self,
        entry: &Entry,
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
            let finding = Finding::new(
                &entry.key_span,
                join(path),
                problem,
                format!("remove it, or set {key} = \"{wanted}\""),
            );
            self.found.push(finding);
            return None;
        }
        let tables: Vec<&str> = self.schema.tables_in(pattern).map(Table::key).collect();
        let said = unknown_key(self.schema, &entry.key, known, &tables);
        self.found.push(Finding::new(
            &entry.key_span,
            join(path),
            said.problem,
            said.remedy,
        ));
        said.meant
    }

    fn missing_field(&mut self, field: &Field, node: &Node, path: &mut Vec<String>) {
        path.push(field.key().to_owned());
        let remedy = format!(
            "add `{} = ...` ({}): {}",
            field.key(),
            field.label,
            field.range_text()
        );
        self.found
            .push(Finding::new(&node.span, join(path), "is missing", remedy));
        path.pop();
    }

    fn missing_tables(&mut self, node: &Node, pattern: &str, path: &mut Vec<String>) {
        for table in self.schema.tables_in(pattern) {
            let key = table.key();
            if table.required && node.get(key).is_none() {
                path.push(key.to_owned());
                let remedy = format!("add {}: {}", table.header(), table.help);
                self.found
                    .push(Finding::new(&node.span, join(path), "is missing", remedy));
                path.pop();
            }
        }
    }
}

/// The fields a table of this pattern has, given what its own keys say.
pub(crate) fn fields_here(
    schema: &'static Schema,
    node: &Node,
    pattern: &str,
) -> Vec<&'static Field> {
    schema
        .fields_of(pattern)
        .filter(|field| exists(schema, field, node) != Some(false))
        .collect()
}

/// Whether this table has the field at all; nothing when the key that decides it is itself wrong or missing. A key that is
/// left out decides by its default.
fn exists(schema: &'static Schema, field: &Field, node: &Node) -> Option<bool> {
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
        (None, Absent::Default(value)) => Some(value.trim_matches('"') == wanted),
        (None, _) => None,
    }
}

fn subtable(schema: &'static Schema, pattern: &str, key: &str) -> Option<&'static Table> {
    schema.tables_in(pattern).find(|table| table.key() == key)
}
