//! The fields of a file, as a parameter editor lists them.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::check::fields_here;
use super::fields::parameters_table::PARAMETERS;
use super::fields::{AbsentValue, Field, Schema, in_words, join, number, value_text};
use super::model::Mark;
use super::replaced_value::{ReplacedValue, void};
use super::schema::{SubTable, TableNode};
use super::tree::{TomlData, TomlNode};

/// A field of a file with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldRow {
    /// Key path: `materials.chain.ea_n`.
    pub path: String,
    /// The heading it stands under: `environment`, `material chain`, `end A (vessel)`.
    pub group: String,
    /// What it is, in a few words.
    pub label: Cow<'static, str>,
    /// Unit as shown; empty for words, "-" for pure numbers.
    pub unit: &'static str,
    /// The value as in the file, or its default; empty when it is absent and has none.
    pub value: String,
    /// The number that an expression of parameters comes to, as text; absent where the value is none.
    pub computed: Option<String>,
    /// What holds when the key is absent and has no default: "chosen by the solver".
    pub absent: Option<&'static str>,
    /// What may be written, with range and unit.
    pub range: String,
    /// One line of help.
    pub help: &'static str,
    /// Where the value comes from, when the case marks it.
    pub standing: Option<Mark>,
    /// The value in whose place the user's is; absent where the value is the file's own.
    pub replaced: Option<ReplacedValue>,
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

/// Lists the fields of a file.
pub struct FieldLister<'a> {
    /// Kind of the file.
    pub schema: &'static Schema,
    /// Its text.
    pub(crate) text: &'a str,
    /// The text as a tree.
    pub root: &'a TomlNode,
    /// Where its values come from, by key path.
    marks: BTreeMap<String, Mark>,
}

impl<'a> FieldLister<'a> {
    pub(crate) fn new(schema: &'static Schema, text: &'a str, root: &'a TomlNode) -> Self {
        type Marks = BTreeMap<String, Mark>;
        let place = TableNode::root(root);
        let keys = <Marks as SubTable>::keys(&place, "marks");
        Self {
            schema,
            text,
            root,
            marks: <Marks as SubTable>::from_keys(&keys, &place, "marks").unwrap_or_default(),
        }
    }

    /// The rows of a table under a heading of its own, whether the file has it or not.
    pub fn always(&self, table: &str) -> Vec<FieldRow> {
        self.table(table, &[table], table)
    }

    /// The rows of a table, if the file has it.
    pub fn if_given(&self, path: &[&str], group: &str) -> Vec<FieldRow> {
        match self.root.find(path) {
            Some(_) => self.table(&path.join("."), path, group),
            None => Vec::new(),
        }
    }

    /// The rows of every table under `table`, by name.
    pub fn named(&self, table: &str, heading: &str) -> Vec<FieldRow> {
        let Some(node) = self.root.get(table) else {
            return Vec::new();
        };
        let names = node.names();
        // Looked for by their names one by one, many would take the square of their number.
        let known: Vec<&TomlNode> = match &node.data {
            TomlData::Table(_, entries) => entries.iter().map(|entry| &entry.node).collect(),
            TomlData::List(items) if node.is_list_of_tables() => items.iter().collect(),
            _ => Vec::new(),
        };
        let pattern = format!("{table}.*");
        let each = names.iter().enumerate().flat_map(|(number, name)| {
            let path = [table, name];
            let element = known.get(number).copied();
            let element = element.or_else(|| self.root.find(&path));
            self.rows(element, &pattern, &path, &format!("{heading} {name}"))
        });
        each.collect()
    }

    /// The rows of the named parameters, each under its own name.
    pub(crate) fn parameters(&self) -> Vec<FieldRow> {
        let Some(node) = self.root.get(PARAMETERS) else {
            return Vec::new();
        };
        let Some(field) = self.schema.fields_of(PARAMETERS).next() else {
            return Vec::new();
        };
        let rows = node.entries().iter().map(|entry| {
            let (label, unit) = in_words(&entry.key);
            FieldRow {
                path: join(&[PARAMETERS, &entry.key]),
                label: Cow::Owned(label),
                unit: unit.unwrap_or("-"),
                ..self.row(field, Some(&entry.node), &[PARAMETERS], PARAMETERS)
            }
        });
        rows.collect()
    }

    /// The rows of one table, whether the file has it or not.
    pub fn table(&self, pattern: &str, path: &[&str], group: &str) -> Vec<FieldRow> {
        self.rows(self.root.find(path), pattern, path, group)
    }

    /// The rows of a table at a path.
    fn rows(
        &self,
        node: Option<&TomlNode>,
        pattern: &str,
        path: &[&str],
        group: &str,
    ) -> Vec<FieldRow> {
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
        given: Option<&TomlNode>,
        path: &[&str],
        group: &str,
    ) -> FieldRow {
        let path = join(&[path, &[field.key()]].concat());
        let (value, absent) = match (given, field.absent) {
            (Some(node), _) => (expression_or_value(self.text, node), None),
            (None, AbsentValue::Default(value)) => (value.trim_matches('"').to_owned(), None),
            (None, AbsentValue::Means(meaning)) => (String::new(), Some(meaning)),
            (None, AbsentValue::Required | AbsentValue::RequiredWithout(_)) => {
                (String::new(), None)
            }
        };
        let mark = self.marks.get(&path);
        let replaced = mark.and_then(|mark| void(mark, &value, field.unit));
        FieldRow {
            standing: mark.filter(|_| replaced.is_none()).cloned(),
            replaced,
            path,
            group: group.to_owned(),
            label: Cow::Borrowed(field.label),
            computed: given.and_then(|node| computed(self.text, node)),
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

/// The text of an expression without its quotes, or the value as the file gives it.
fn expression_or_value(text: &str, node: &TomlNode) -> String {
    let written = value_text(text, node);
    let read = TomlNode::parse_value(&written).filter(|_| is_number(node));
    match read.as_ref().and_then(TomlNode::text) {
        Some(expression) => expression.to_owned(),
        None => written,
    }
}

/// The number that an expression comes to.
fn computed(text: &str, node: &TomlNode) -> Option<String> {
    let is_text = |node: &TomlNode| value_text(text, node).starts_with(['"', '\'']);
    let value = |node: &TomlNode| node.number().map(number);
    match &node.data {
        TomlData::List(items) => {
            let any = items.iter().any(|item| is_number(item) && is_text(item));
            let values: Option<Vec<String>> = items.iter().map(value).collect();
            Some(format!("[{}]", values?.join(", "))).filter(|_| any)
        }
        _ => value(node).filter(|_| is_text(node)),
    }
}

fn is_number(node: &TomlNode) -> bool {
    matches!(node.data, TomlData::Float(_) | TomlData::Integer(_))
}

/// Whether the field matters in this table of a file, which may leave the table out.
fn applies(schema: &'static Schema, field: &Field, table: Option<&TomlNode>) -> bool {
    field.matters.iter().all(|(key, words)| {
        let given = table
            .and_then(|node| node.get(key))
            .and_then(TomlNode::text);
        let default = schema.fields_of(field.table()).find(|f| f.key() == *key);
        let default = default.and_then(|f| match f.absent {
            AbsentValue::Default(value) => Some(value.trim_matches('"')),
            _ => None,
        });
        given.or(default).is_none_or(|word| words.contains(&word))
    })
}
