//! The fields of one case, as a parameter editor lists them.

use std::collections::BTreeMap;

use super::fields::{Absent, Field, Schema, join, value_text};
use super::model::CASE;
use crate::case::check::fields_here;
use crate::case::model::{Case, Mark};
use crate::case::tree::Node;

/// A field of one case with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldRow {
    /// Key path: `materials.chain.ea_n`.
    pub path: String,
    /// The heading it stands under: `environment`, `material chain`, `end A (vessel)`.
    pub group: String,
    /// What it is, in a few words.
    pub label: &'static str,
    /// Unit as shown; empty for words, "-" for pure numbers.
    pub unit: &'static str,
    /// The value as in the file, or its default; empty when it is absent and has none.
    pub value: String,
    /// What holds when the key is absent and has no default: "chosen by the solver".
    pub absent: Option<&'static str>,
    /// What may be written, with range and unit.
    pub range: String,
    /// One line of help.
    pub help: &'static str,
    /// Where the value comes from, when the case marks it.
    pub standing: Option<Mark>,
    /// True when the file gives it, false when the default holds.
    pub given: bool,
    /// Whether it matters beside the other keys of its table; editor and report leave it out where it neither matters nor is
    /// given.
    pub applies: bool,
    /// The field itself.
    pub field: &'static Field,
}

impl FieldRow {
    /// Whether editor and report show it.
    #[must_use]
    pub fn is_shown(&self) -> bool {
        self.applies || self.given
    }
}

/// Every input the case can have, given or not, in reading order: environment, current, sea bed, each
/// material, each section, ends, payload, floats, clumps, modules, traveller, start, solver, output.
///
/// `text` is the text the case was parsed from; a text that is not TOML gives no rows.
#[must_use]
pub fn rows(text: &str, case: &Case) -> Vec<FieldRow> {
    let Ok(root) = Node::parse(text) else {
        return Vec::new();
    };
    let lister = Lister {
        schema: &CASE,
        text,
        root: &root,
        marks: &case.marks,
    };
    lister.of_case(case)
}

/// Lists the fields of a file.
pub(crate) struct Lister<'a> {
    /// Kind of the file.
    pub(crate) schema: &'static Schema,
    /// Its text.
    pub(crate) text: &'a str,
    /// The text as a tree.
    pub(crate) root: &'a Node,
    /// Where its values come from, by key path.
    pub(crate) marks: &'a BTreeMap<String, Mark>,
}

impl Lister<'_> {
    fn of_case(&self, case: &Case) -> Vec<FieldRow> {
        let mut rows = Vec::new();
        for table in ["environment", "current"] {
            rows.extend(self.table(table, &[table], table));
        }
        if case.waves.is_some() {
            rows.extend(self.table("waves", &["waves"], "waves"));
        }
        if case.seabed.is_some() {
            rows.extend(self.table("seabed", &["seabed"], "sea bed"));
        }
        rows.extend(self.named("materials", "material"));
        rows.extend(self.named("line", "section"));
        for (letter, end) in [("a", &case.ends.a), ("b", &case.ends.b)] {
            let group = format!("end {} ({})", letter.to_uppercase(), end.name);
            rows.extend(self.table("ends.*", &["ends", letter], &group));
        }
        if case.payload.is_some() {
            rows.extend(self.table("payload", &["payload"], "payload"));
            if self.root.find(&["payload", "rotation"]).is_some() {
                let path = ["payload", "rotation"];
                rows.extend(self.table("payload.rotation", &path, "payload"));
            }
            if self.root.find(&["payload", "shape"]).is_some() {
                rows.extend(self.table("payload.shape", &["payload", "shape"], "payload"));
            }
        }
        rows.extend(self.named("floats", "floats on"));
        rows.extend(self.named("clumps", "body"));
        rows.extend(self.named("modules", "modules on"));
        if case.traveller.is_some() {
            rows.extend(self.table("traveller", &["traveller"], "traveller"));
        }
        for table in ["start", "solver", "output"] {
            rows.extend(self.table(table, &[table], table));
        }
        rows
    }

    /// The rows of every table under `table`, by name.
    pub(crate) fn named(&self, table: &str, heading: &str) -> Vec<FieldRow> {
        let Some(node) = self.root.get(table) else {
            return Vec::new();
        };
        let names = node.names();
        let each = names.iter().flat_map(|name| {
            self.table(
                &format!("{table}.*"),
                &[table, name],
                &format!("{heading} {name}"),
            )
        });
        each.collect()
    }

    /// The rows of one table, whether the file has it or not.
    pub(crate) fn table(&self, pattern: &str, path: &[&str], group: &str) -> Vec<FieldRow> {
        let node = self.root.find(path);
        let fields: Vec<&'static Field> = match node {
            Some(node) => fields_here(self.schema, node, pattern),
            None => self.schema.fields_of(pattern).collect(),
        };
        let rows = fields.into_iter().map(|field| {
            let given = node.and_then(|node| node.get(field.key()));
            FieldRow {
                applies: applies(self.schema, field, node),
                ..self.row(field, given, path, group)
            }
        });
        rows.collect()
    }

    fn row(
        &self,
        field: &'static Field,
        given: Option<&Node>,
        path: &[&str],
        group: &str,
    ) -> FieldRow {
        let path = join(&[path, &[field.key()]].concat());
        let (value, absent) = match (given, field.absent) {
            (Some(node), _) => (value_text(self.text, node), None),
            (None, Absent::Default(value)) => (value.trim_matches('"').to_owned(), None),
            (None, Absent::Means(meaning)) => (String::new(), Some(meaning)),
            (None, Absent::Required | Absent::RequiredWithout(_)) => (String::new(), None),
        };
        FieldRow {
            standing: self.marks.get(&path).cloned(),
            path,
            group: group.to_owned(),
            label: field.label,
            unit: field.unit,
            value,
            absent,
            range: field.range_text(),
            help: field.help,
            given: given.is_some(),
            applies: true,
            field,
        }
    }
}

/// Whether the field matters in this table of a file, which may leave the table out.
fn applies(schema: &'static Schema, field: &Field, table: Option<&Node>) -> bool {
    field.matters.iter().all(|(key, words)| {
        let given = table.and_then(|node| node.get(key)).and_then(Node::text);
        let default = schema.fields_of(field.table()).find(|f| f.key() == *key);
        let default = default.and_then(|f| match f.absent {
            Absent::Default(value) => Some(value.trim_matches('"')),
            _ => None,
        });
        given.or(default).is_none_or(|word| words.contains(&word))
    })
}
