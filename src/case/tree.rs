//! The document as a plain tree with the place of every key and value.
//!
//! `toml_edit` keeps standard tables, inline tables, dotted keys and arrays of tables apart; for
//! checks they are the same. The tree here forgets the difference and keeps the spans.

use std::ops::Range;

use toml_edit::{Document, Item, Table, TomlError, Value};

/// A value of the document and where it stands.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    pub(crate) span: Range<usize>,
    pub(crate) data: Data,
}

/// What a value is.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Data {
    Table(Form, Vec<Entry>),
    List(Vec<Node>),
    Text(String),
    Integer(i64),
    Float(f64),
    Boolean(bool),
    Date,
}

/// How a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// Under a header of its own, or as dotted keys.
    Lines,
    /// `{ … }`.
    Inline,
}

/// A key of a table with its value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Entry {
    pub(crate) key: String,
    pub(crate) key_span: Range<usize>,
    pub(crate) node: Node,
}

impl Node {
    /// The document as a tree.
    pub(crate) fn parse(text: &str) -> Result<Self, TomlError> {
        let document = Document::parse(text)?;
        Ok(table(document.as_table(), &(0..0)))
    }

    /// A table without keys.
    pub(crate) fn empty_table() -> Self {
        Self {
            span: 0..0,
            data: Data::Table(Form::Lines, Vec::new()),
        }
    }

    /// A value written alone, as a user types it into a field.
    pub(crate) fn parse_value(text: &str) -> Option<Self> {
        let value: Value = text.parse().ok()?;
        Some(from_value(&value, &(0..text.len())))
    }

    pub(crate) fn entries(&self) -> &[Entry] {
        match &self.data {
            Data::Table(_, entries) => entries,
            _ => &[],
        }
    }

    pub(crate) fn is_table(&self) -> bool {
        matches!(self.data, Data::Table(..))
    }

    /// True for a list that holds nothing but tables.
    pub(crate) fn is_list_of_tables(&self) -> bool {
        matches!(&self.data, Data::List(items) if items.iter().all(Self::is_table))
    }

    /// The elements of a list.
    pub(crate) fn items(&self) -> &[Self] {
        match &self.data {
            Data::List(items) => items,
            _ => &[],
        }
    }

    pub(crate) fn entry(&self, key: &str) -> Option<&Entry> {
        self.entries().iter().find(|entry| entry.key == key)
    }

    pub(crate) fn get(&self, key: &str) -> Option<&Self> {
        self.entry(key).map(|entry| &entry.node)
    }

    pub(crate) fn text(&self) -> Option<&str> {
        match &self.data {
            Data::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The value as a finite number.
    pub(crate) fn number(&self) -> Option<f64> {
        match self.data {
            Data::Integer(value) => Some(value as f64),
            Data::Float(value) if value.is_finite() => Some(value),
            _ => None,
        }
    }

    /// The value as a list of finite numbers.
    pub(crate) fn numbers(&self) -> Option<Vec<f64>> {
        match &self.data {
            Data::List(items) => items.iter().map(Self::number).collect(),
            _ => None,
        }
    }

    /// What kind of value this is, for messages.
    pub(crate) fn describe(&self) -> &'static str {
        match &self.data {
            Data::Table(..) => "a table",
            Data::List(items) if !items.is_empty() && self.is_list_of_tables() => {
                "a list of tables"
            }
            Data::List(_) => "a list",
            Data::Text(_) => "text",
            Data::Integer(_) => "a whole number",
            Data::Float(_) => "a number",
            Data::Boolean(_) => "true or false",
            Data::Date => "a date",
        }
    }

    /// The names of what a table or a list of tables holds: keys, or the names of the elements.
    pub(crate) fn names(&self) -> Vec<String> {
        match &self.data {
            Data::Table(_, entries) => entries.iter().map(|entry| entry.key.clone()).collect(),
            _ => element_names(self.items()),
        }
    }

    /// The value at a key path. Elements of lists of tables go by their name (or, for floats, their
    /// section), or by their number from 1; those of lists of numbers by the letter of their axis.
    pub(crate) fn find<S: AsRef<str>>(&self, path: &[S]) -> Option<&Self> {
        let Some((first, rest)) = path.split_first() else {
            return Some(self);
        };
        let first = first.as_ref();
        let next = match &self.data {
            Data::List(items) if !items.is_empty() && !self.is_list_of_tables() => {
                items.get(["x", "y", "z"].iter().position(|axis| *axis == first)?)?
            }
            Data::List(items) => {
                let position = element_names(items).iter().position(|name| name == first)?;
                items.get(position)?
            }
            _ => self.get(first)?,
        };
        next.find(rest)
    }
}

/// The names by which elements of a list of tables are known in key paths: the key `name`, or
/// `section` for floats; where that is missing or taken by an earlier element, the number from 1.
pub(crate) fn element_names(items: &[Node]) -> Vec<String> {
    let mut names: Vec<String> = Vec::with_capacity(items.len());
    for (index, item) in items.iter().enumerate() {
        let own = ["name", "section"]
            .iter()
            .find_map(|key| item.get(key)?.text());
        let name = match own {
            Some(name) if !names.iter().any(|earlier| earlier == name) => name.to_owned(),
            _ => (index + 1).to_string(),
        };
        names.push(name);
    }
    names
}

fn table(table: &Table, fallback: &Range<usize>) -> Node {
    let entries: Vec<Entry> = table
        .iter()
        .filter_map(|(key, item)| {
            let key_span = table.key(key).and_then(toml_edit::Key::span);
            entry(key, key_span, item, fallback)
        })
        .collect();
    let span = table.span().unwrap_or_else(|| fallback.clone());
    Node {
        span,
        data: Data::Table(Form::Lines, entries),
    }
}

fn entry(
    key: &str,
    key_span: Option<Range<usize>>,
    item: &Item,
    fallback: &Range<usize>,
) -> Option<Entry> {
    let key_span = key_span.unwrap_or_else(|| fallback.clone());
    let node = match item {
        Item::None => return None,
        Item::Value(value) => from_value(value, &key_span),
        Item::Table(inner) => table(inner, &key_span),
        Item::ArrayOfTables(list) => Node {
            span: list.span().unwrap_or_else(|| key_span.clone()),
            data: Data::List(list.iter().map(|inner| table(inner, &key_span)).collect()),
        },
    };
    Some(Entry {
        key: key.to_owned(),
        key_span,
        node,
    })
}

fn from_value(value: &Value, fallback: &Range<usize>) -> Node {
    let span = value.span().unwrap_or_else(|| fallback.clone());
    let data = match value {
        Value::String(text) => Data::Text(text.value().clone()),
        Value::Integer(number) => Data::Integer(*number.value()),
        Value::Float(number) => Data::Float(*number.value()),
        Value::Boolean(truth) => Data::Boolean(*truth.value()),
        Value::Datetime(_) => Data::Date,
        Value::Array(list) => Data::List(list.iter().map(|item| from_value(item, &span)).collect()),
        Value::InlineTable(inner) => {
            let entries = inner.iter().map(|(key, item)| {
                let key_span = inner.key(key).and_then(toml_edit::Key::span);
                Entry {
                    key: key.to_owned(),
                    key_span: key_span.unwrap_or_else(|| span.clone()),
                    node: from_value(item, &span),
                }
            });
            let form = if inner.is_dotted() {
                Form::Lines
            } else {
                Form::Inline
            };
            Data::Table(form, entries.collect())
        }
    };
    Node { span, data }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_of_keys_values_and_headers() {
        let text = "# top\n[a]\nx = 1 # one\n\n[[l]]\nname = \"n\"\ny = [1, 2.5]\n[[l]]\nname=\"n\"\n[a.b]\nz = { q = true }\n";
        let tree = Node::parse(text).unwrap();
        let show = |n: &Node| text[n.span.clone()].to_owned();
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
