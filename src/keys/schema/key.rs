//! A key of a file as it is read: value and place.

use std::ops::Range;
use std::rc::Rc;

use super::value::KeyValue;
use crate::diagnostic::Finding;
use crate::fields::{Field, check_value, join};
use crate::tree::{TomlEntry, TomlNode};

/// A table of a file and its key path.
#[derive(Debug, Clone)]
pub struct TableNode<'a> {
    /// The table.
    pub node: &'a TomlNode,
    /// Its key path.
    pub path: Rc<str>,
}

impl<'a> TableNode<'a> {
    /// The file as a whole.
    pub fn root(node: &'a TomlNode) -> Self {
        Self {
            node,
            path: "".into(),
        }
    }

    /// A table in this one, or an element of a list of tables.
    pub fn inner(&self, node: &'a TomlNode, name: &str) -> Self {
        Self {
            node,
            path: self.key(name).into(),
        }
    }

    /// The path of a key of this table.
    pub fn key(&self, name: &str) -> String {
        let name = join(&[name]);
        if self.path.is_empty() {
            name
        } else {
            format!("{}.{name}", self.path)
        }
    }

    /// A finding at the table.
    pub fn finding(&self, problem: impl Into<String>, remedy: impl Into<String>) -> Finding {
        Finding::new(&self.node.span, &*self.path, problem, remedy)
    }

    /// A finding at a value of the table, such as the word that gives its kind.
    pub fn finding_at(
        &self,
        name: &str,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Finding {
        let node = self.node.get(name).unwrap_or(self.node);
        Finding::new(&node.span, self.key(name), problem, remedy)
    }

    /// A finding about a key that the checks passed and that still cannot be read: a fault of the checks.
    pub fn faulty(&self, name: &str) -> Finding {
        let remedy = "compare with the cases that come with the program";
        Finding::new(
            &self.node.span,
            self.key(name),
            "cannot be understood",
            remedy,
        )
    }
}

/// A key of a table as it is read.
#[derive(Debug, Clone)]
pub struct Key<'a, T> {
    table: TableNode<'a>,
    name: &'static str,
    entry: Option<&'a TomlEntry>,
    value: Option<T>,
}

impl<'a, T: KeyValue> Key<'a, T> {
    /// Reads a key of a table; a key that is not given has its default, if it has one.
    pub fn read(
        table: &TableNode<'a>,
        name: &'static str,
        fields: &[Field],
        default: Option<T>,
    ) -> Self {
        let entry = table.node.entry(name);
        let field = fields.iter().find(|field| field.key() == name);
        let sound = |entry: &&TomlEntry| field.is_some_and(|f| check_value(f, &entry.node).is_ok());
        let value = match entry {
            None => default,
            Some(_) => entry.filter(sound).and_then(|entry| T::read(&entry.node)),
        };
        Self {
            table: table.clone(),
            name,
            entry,
            value,
        }
    }

    /// The value that holds, given or default; nothing where it is faulty or absent without default.
    pub fn get(&self) -> Option<&T> {
        self.value.as_ref()
    }

    /// The same, as a value of its own.
    pub fn value(&self) -> Option<T> {
        self.value.clone()
    }

    /// The value that the file gives; nothing where it is faulty.
    pub fn given(&self) -> Option<&T> {
        self.entry.and(self.value.as_ref())
    }

    /// Whether the value that holds is this one.
    pub fn is(&self, value: &T) -> bool
    where
        T: PartialEq,
    {
        self.get() == Some(value)
    }

    /// Whether the file gives the key, faulty or not.
    pub fn is_given(&self) -> bool {
        self.entry.is_some()
    }

    /// The text that the file gives, whether it is a value or not.
    pub fn text(&self) -> Option<&'a str> {
        self.entry.and_then(|entry| entry.node.text())
    }

    /// Whether the file gives the key with a value that it cannot have.
    pub fn is_faulty(&self) -> bool {
        self.entry.is_some() && self.value.is_none()
    }

    /// The elements of a list, as they stand in the file.
    pub fn items(&self) -> &'a [TomlNode] {
        self.entry.map_or(&[], |entry| entry.node.items())
    }

    /// The path of the key.
    pub fn path(&self) -> String {
        self.table.key(self.name)
    }

    /// Its name in its table.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Where the key itself stands, from the start of the file.
    pub fn start(&self) -> Option<usize> {
        self.entry.map(|entry| entry.key_span.start)
    }

    /// A finding at the value; at the table where the key is not given.
    pub fn finding(&self, problem: impl Into<String>, remedy: impl Into<String>) -> Finding {
        let span = self.entry.map(|entry| &entry.node.span);
        self.finding_at(span, problem, remedy)
    }

    /// A finding at the name of the key.
    pub fn finding_at_name(
        &self,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Finding {
        let span = self.entry.map(|entry| &entry.key_span);
        self.finding_at(span, problem, remedy)
    }

    /// A finding at an element of a list.
    pub fn finding_at_item(
        &self,
        index: usize,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Finding {
        let item = self.entry.and_then(|entry| entry.node.items().get(index));
        self.finding_at(item.map(|node| &node.span), problem, remedy)
    }

    /// A finding at the table, whether the key is given or not.
    pub fn finding_at_table(
        &self,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Finding {
        self.finding_at(None, problem, remedy)
    }

    /// A finding at the table where the key is not given.
    pub fn if_missing(&self, remedy: impl Into<String>) -> Option<Finding> {
        self.entry.is_none().then(|| self.missing(remedy))
    }

    /// A finding at the table: this key is not given.
    pub fn missing(&self, remedy: impl Into<String>) -> Finding {
        self.finding_at(None, "is missing", remedy)
    }

    /// A finding where the key is given: it has no effect.
    pub fn if_given(
        &self,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Option<Finding> {
        self.entry.map(|_| self.finding(problem, remedy))
    }

    fn finding_at(
        &self,
        span: Option<&Range<usize>>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Finding {
        let span = span.unwrap_or(&self.table.node.span);
        Finding::new(span, self.path(), problem, remedy)
    }
}
