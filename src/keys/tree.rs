//! The document as a plain tree with the place of every key and value.
//!
//! `toml_edit` keeps standard tables, inline tables, dotted keys and arrays of tables apart; for
//! checks they are the same. The tree here forgets the difference and keeps the spans.

use std::collections::HashSet;
use std::ops::Range;

use toml_edit::{Document, Item, Table, TomlError, Value};

use crate::files::shallow::shallow;

/// A value of the document and where it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct TomlNode {
    /// The bytes of the document that hold it.
    pub span: Range<usize>,
    /// What it is.
    pub data: TomlData,
}

/// What a value is.
#[derive(Debug, Clone, PartialEq)]
pub enum TomlData {
    /// A table with its keys in the order of the document.
    Table(TableForm, Vec<TomlEntry>),
    /// A list.
    List(Vec<TomlNode>),
    /// A text.
    Text(String),
    /// A whole number.
    Integer(i64),
    /// A number.
    Float(f64),
    /// True or false.
    Boolean(bool),
    /// A date or a time.
    Date,
}

/// How a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableForm {
    /// Under a header of its own, or as dotted keys.
    Lines,
    /// `{ … }`.
    Inline,
}

/// A key of a table with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct TomlEntry {
    /// The key.
    pub key: String,
    /// Its bytes.
    pub key_span: Range<usize>,
    /// The value.
    pub node: TomlNode,
}

impl TomlNode {
    /// The document as a tree.
    pub fn parse(text: &str) -> Result<Self, TomlError> {
        let document = Document::parse(shallow(text))?;
        Ok(table(document.as_table(), &(0..0)))
    }

    /// The tree of a table that no file holds.
    pub fn of_table(content: &Table) -> Self {
        table(content, &(0..0))
    }

    /// A value written alone, as a user types it into a field.
    pub fn parse_value(text: &str) -> Option<Self> {
        let value: Value = shallow(text).parse().ok()?;
        Some(from_value(&value, &(0..text.len())))
    }

    /// The keys of a table with their values; none of another value.
    #[must_use]
    pub fn entries(&self) -> &[TomlEntry] {
        match &self.data {
            TomlData::Table(_, entries) => entries,
            _ => &[],
        }
    }

    /// Whether it is a table.
    #[must_use]
    pub fn is_table(&self) -> bool {
        matches!(self.data, TomlData::Table(..))
    }

    /// Whether it is a list.
    #[must_use]
    pub fn is_list(&self) -> bool {
        matches!(self.data, TomlData::List(_))
    }

    /// True for a list that holds nothing but tables.
    pub fn is_list_of_tables(&self) -> bool {
        matches!(&self.data, TomlData::List(items) if items.iter().all(Self::is_table))
    }

    /// The elements of a list.
    pub fn items(&self) -> &[Self] {
        match &self.data {
            TomlData::List(items) => items,
            _ => &[],
        }
    }

    /// A key of a table with its value.
    #[must_use]
    pub fn entry(&self, key: &str) -> Option<&TomlEntry> {
        self.entries().iter().find(|entry| entry.key == key)
    }

    /// The value of a key of a table.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Self> {
        self.entry(key).map(|entry| &entry.node)
    }

    /// The text, of a text.
    #[must_use]
    pub fn text(&self) -> Option<&str> {
        match &self.data {
            TomlData::Text(text) => Some(text),
            _ => None,
        }
    }

    /// Whether it is true, of a value that is true or false.
    #[must_use]
    pub fn boolean(&self) -> Option<bool> {
        match self.data {
            TomlData::Boolean(value) => Some(value),
            _ => None,
        }
    }

    /// The value as a finite number.
    pub fn number(&self) -> Option<f64> {
        match self.data {
            TomlData::Integer(value) => Some(value as f64),
            TomlData::Float(value) if value.is_finite() => Some(value),
            _ => None,
        }
    }

    /// The value as a list of finite numbers.
    pub fn numbers(&self) -> Option<Vec<f64>> {
        match &self.data {
            TomlData::List(items) => items.iter().map(Self::number).collect(),
            _ => None,
        }
    }

    /// What kind of value this is, for messages.
    pub fn describe(&self) -> &'static str {
        match &self.data {
            TomlData::Table(..) => "a table",
            TomlData::List(items) if !items.is_empty() && self.is_list_of_tables() => {
                "a list of tables"
            }
            TomlData::List(_) => "a list",
            TomlData::Text(_) => "text",
            TomlData::Integer(_) => "a whole number",
            TomlData::Float(_) => "a number",
            TomlData::Boolean(_) => "true or false",
            TomlData::Date => "a date",
        }
    }

    /// The names of what a table or a list of tables holds: keys, or the names of the elements.
    pub fn names(&self) -> Vec<String> {
        match &self.data {
            TomlData::Table(_, entries) => entries.iter().map(|entry| entry.key.clone()).collect(),
            _ => element_names(self.items()),
        }
    }

    /// The bytes of all values below, of lists and inline tables as a whole.
    pub fn value_spans(&self) -> Vec<Range<usize>> {
        let within = |nodes: Vec<&Self>| nodes.into_iter().flat_map(Self::value_spans).collect();
        match &self.data {
            TomlData::Table(TableForm::Lines, entries) => {
                within(entries.iter().map(|entry| &entry.node).collect())
            }
            TomlData::List(items) if items.iter().any(Self::is_under_header) => {
                within(items.iter().collect())
            }
            _ => vec![self.span.clone()],
        }
    }

    /// True for a table under a header of its own, or of dotted keys.
    #[must_use]
    pub fn is_under_header(&self) -> bool {
        matches!(self.data, TomlData::Table(TableForm::Lines, _))
    }

    /// The value at a key path. Elements of lists of tables go by their name (or, for floats, their
    /// section), or by their number from 1; those of lists of numbers by the letter of their axis.
    pub fn find<S: AsRef<str>>(&self, path: &[S]) -> Option<&Self> {
        let Some((first, rest)) = path.split_first() else {
            return Some(self);
        };
        let first = first.as_ref();
        let next = match &self.data {
            TomlData::List(items) if !items.is_empty() && !self.is_list_of_tables() => {
                items.get(["x", "y", "z"].iter().position(|axis| *axis == first)?)?
            }
            TomlData::List(items) => {
                let position = position_of(items, first)?;
                items.get(position)?
            }
            _ => self.get(first)?,
        };
        next.find(rest)
    }
}

/// The names by which elements of a list of tables are known in key paths: the key `name`, or
/// `section` for floats; where that is missing or taken by an earlier element, the number from 1.
pub fn element_names(items: &[TomlNode]) -> Vec<String> {
    let mut names: Vec<String> = Vec::with_capacity(items.len());
    let mut taken: HashSet<String> = HashSet::with_capacity(items.len());
    for (index, item) in items.iter().enumerate() {
        let name = match own_name(item) {
            Some(name) if !taken.contains(name) => name.to_owned(),
            _ => (index + 1).to_string(),
        };
        taken.insert(name.clone());
        names.push(name);
    }
    names
}

/// The name that an element of a list gives itself.
fn own_name(item: &TomlNode) -> Option<&str> {
    ["name", "section"]
        .iter()
        .find_map(|key| item.get(key)?.text())
}

/// Where the element of a name is in a list.
fn position_of(items: &[TomlNode], name: &str) -> Option<usize> {
    let is_number = name.bytes().all(|byte| byte.is_ascii_digit());
    match is_number {
        // It may be the number of an element without a name.
        true => element_names(items).iter().position(|one| one == name),
        false => items.iter().position(|item| own_name(item) == Some(name)),
    }
}

fn table(table: &Table, fallback: &Range<usize>) -> TomlNode {
    let entries: Vec<TomlEntry> = table
        .iter()
        .filter_map(|(key, item)| {
            let key_span = table.key(key).and_then(toml_edit::Key::span);
            entry(key, key_span, item, fallback)
        })
        .collect();
    let span = table.span().unwrap_or_else(|| fallback.clone());
    TomlNode {
        span,
        data: TomlData::Table(TableForm::Lines, entries),
    }
}

fn entry(
    key: &str,
    key_span: Option<Range<usize>>,
    item: &Item,
    fallback: &Range<usize>,
) -> Option<TomlEntry> {
    let key_span = key_span.unwrap_or_else(|| fallback.clone());
    let node = match item {
        Item::None => return None,
        Item::Value(value) => from_value(value, &key_span),
        Item::Table(inner) => table(inner, &key_span),
        Item::ArrayOfTables(list) => TomlNode {
            span: list.span().unwrap_or_else(|| key_span.clone()),
            data: TomlData::List(list.iter().map(|inner| table(inner, &key_span)).collect()),
        },
    };
    Some(TomlEntry {
        key: key.to_owned(),
        key_span,
        node,
    })
}

fn from_value(value: &Value, fallback: &Range<usize>) -> TomlNode {
    let span = value.span().unwrap_or_else(|| fallback.clone());
    let data = match value {
        Value::String(text) => TomlData::Text(text.value().clone()),
        Value::Integer(number) => TomlData::Integer(*number.value()),
        Value::Float(number) => TomlData::Float(*number.value()),
        Value::Boolean(truth) => TomlData::Boolean(*truth.value()),
        Value::Datetime(_) => TomlData::Date,
        Value::Array(list) => {
            TomlData::List(list.iter().map(|item| from_value(item, &span)).collect())
        }
        Value::InlineTable(inner) => {
            let entries = inner.iter().map(|(key, item)| {
                let key_span = inner.key(key).and_then(toml_edit::Key::span);
                TomlEntry {
                    key: key.to_owned(),
                    key_span: key_span.unwrap_or_else(|| span.clone()),
                    node: from_value(item, &span),
                }
            });
            let form = if inner.is_dotted() {
                TableForm::Lines
            } else {
                TableForm::Inline
            };
            TomlData::Table(form, entries.collect())
        }
    };
    TomlNode { span, data }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_of_keys_values_and_headers() {
        let text = "# top\n[a]\nx = 1 # one\n\n[[l]]\nname = \"n\"\ny = [1, 2.5]\n[[l]]\nname=\"n\"\n[a.b]\nz = { q = true }\n";
        let tree = TomlNode::parse(text).unwrap();
        let show = |n: &TomlNode| text[n.span.clone()].to_owned();
        assert_eq!(show(tree.find(&["a", "x"]).unwrap()), "1");
        assert_eq!(show(tree.find(&["a"]).unwrap()), "[a]");
        assert_eq!(show(tree.find(&["l", "n"]).unwrap()), "[[l]]");
        assert_eq!(show(tree.find(&["l", "n", "y"]).unwrap()), "[1, 2.5]");
        assert_eq!(show(tree.find(&["l", "2"]).unwrap()), "[[l]]");
        assert_eq!(show(tree.find(&["a", "b", "z"]).unwrap()), "{ q = true }");
        assert_eq!(
            &text[tree.get("a").unwrap().entry("x").unwrap().key_span.clone()],
            "x"
        );
    }
}
