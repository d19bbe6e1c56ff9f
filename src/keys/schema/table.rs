//! Tables of a file as types.

use std::collections::BTreeMap;

use toml_edit::{ArrayOfTables, Item, Table as TomlTable};

use super::key::TableNode;
use super::value::{FieldType, KeyValue};
use crate::diagnostic::Finding;
use crate::fields::{Field, Schema, TableSchema, TableShape};
use crate::tree::{TomlNode, element_names};

/// A table as a type: declared with [`table!`](super::table!) or [`variants!`](super::variants).
pub trait TableType: Sized {
    /// Its keys as they are read, each with its place.
    type Keys<'a>;

    /// Adds its keys, and those of the tables in it, to the schema, below the pattern of its path.
    fn declare(pattern: &str, schema: &mut DeclaredSchema);

    /// Reads what can be read of a table.
    fn keys<'a>(place: &TableNode<'a>) -> Self::Keys<'a>;

    /// The table, of keys without faults.
    fn from_keys(keys: &Self::Keys<'_>) -> Result<Self, Finding>;

    /// Its keys as TOML.
    fn write(&self, written: WrittenKeys) -> TomlTable;
}

/// Tables and fields as they are declared.
#[derive(Debug, Default)]
pub struct DeclaredSchema {
    /// The tables.
    pub tables: Vec<TableSchema>,
    /// The fields.
    pub fields: Vec<Field>,
}

impl DeclaredSchema {
    /// The fields of a table of this pattern.
    pub fn fields(&mut self, pattern: &str, fields: &[Field]) {
        let placed = fields.iter().map(|field| field.below(pattern));
        self.fields.extend(placed);
    }

    /// The fields of a table that stands alone.
    pub fn of_table<T: TableType>() -> Vec<Field> {
        let mut alone = Self::default();
        T::declare("", &mut alone);
        alone.fields
    }

    /// The fields of a table of several kinds, told apart by the word of `tag`: what all kinds declare alike, and what
    /// exists for one of them.
    pub fn kinds(
        &mut self,
        pattern: &str,
        (tag_name, tag): (&'static str, Field),
        kinds: &[(&'static str, Vec<Field>)],
    ) {
        let of_all = |field: &&Field| kinds.iter().all(|(_, fields)| fields.contains(field));
        let first = kinds.first().map_or(&[] as &[Field], |(_, fields)| fields);
        let (names, common): (Vec<&Field>, Vec<&Field>) = first
            .iter()
            .filter(of_all)
            .partition(|field| field.key() == "name");
        let of_one = kinds.iter().flat_map(|(word, fields)| {
            let own = fields.iter().filter(|field| !of_all(field));
            own.map(|field| Field {
                only_if: Some((tag_name, *word)),
                ..field.clone()
            })
        });
        let mut fields: Vec<Field> = names.into_iter().cloned().collect();
        fields.push(tag.clone());
        fields.extend(common.into_iter().cloned());
        fields.extend(of_one);
        self.fields(pattern, &fields);
    }

    /// A table in a table, and what is in it.
    pub fn table<S: SubTable>(
        &mut self,
        pattern: &str,
        key: &str,
        presence: Option<&&str>,
        help: &'static str,
    ) {
        let required = match presence {
            Some(&word) => word != "optional",
            None => S::REQUIRED,
        };
        let path = if pattern.is_empty() {
            key.to_owned()
        } else {
            format!("{pattern}.{key}")
        };
        let mut table = TableSchema::new(path, S::SHAPE, required, help);
        if presence == Some(&"alike") {
            table = table.with_fields(format!("{pattern}.*"));
        }
        let inner = table.pattern().into_owned();
        let known = self.tables.iter().any(|other| other.pattern() == inner);
        self.tables.push(table);
        if !known {
            S::Inner::declare(&inner, self);
        }
    }
}

/// The schema of a kind of file, of the declaration of its tables.
pub fn schema_of<T: TableType>(what: &'static str, least: &'static str) -> Schema {
    let mut declared = DeclaredSchema::default();
    T::declare("", &mut declared);
    Schema {
        what,
        least,
        example: "name a key as the file groups them: table, name, key",
        fields: declared.fields,
        parts: Vec::new(),
        tables: declared.tables,
        absent: &[],
    }
}

/// Which keys are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WrittenKeys {
    /// All that hold a value.
    All,
    /// Those that hold something else than their default.
    WithoutDefaults,
}

/// Writes a key, unless it holds nothing, or its default and defaults are left out.
pub fn put<H: FieldType>(
    table: &mut TomlTable,
    key: &str,
    held: &H,
    default: Option<H::Given>,
    written: WrittenKeys,
) where
    H::Given: PartialEq,
{
    let Some(given) = held.given() else {
        return;
    };
    let idle = written == WrittenKeys::WithoutDefaults && default.is_some_and(|d| d == *given);
    let absent = H::Given::absent().is_some_and(|absent| absent == *given);
    if !idle && !absent {
        table.insert(key, Item::Value(given.write()));
    }
}

/// The type of a field that holds tables.
pub trait SubTable: Sized {
    /// What it holds.
    type Inner: TableType;
    /// Its keys as they are read.
    type Keys<'a>;
    /// How many there are.
    const SHAPE: TableShape;
    /// Whether the type has no place for none.
    const REQUIRED: bool = false;

    /// Reads what can be read of the tables below a key.
    fn keys<'a>(place: &TableNode<'a>, key: &str) -> Self::Keys<'a>;

    /// The tables below a key, of keys without faults.
    fn from_keys(keys: &Self::Keys<'_>, place: &TableNode<'_>, key: &str) -> Result<Self, Finding>;

    /// The tables as TOML, if there are any.
    fn write(&self, written: WrittenKeys) -> Option<Item>;
}

impl<T: TableType> SubTable for T {
    type Inner = T;
    type Keys<'a> = Option<T::Keys<'a>>;
    const SHAPE: TableShape = TableShape::One;
    const REQUIRED: bool = true;

    fn keys<'a>(place: &TableNode<'a>, key: &str) -> Self::Keys<'a> {
        let node = place.node.get(key).filter(|node| node.is_table())?;
        Some(T::keys(&place.inner(node, key)))
    }

    fn from_keys(keys: &Self::Keys<'_>, place: &TableNode<'_>, key: &str) -> Result<Self, Finding> {
        match keys {
            Some(keys) => T::from_keys(keys),
            None => defaults().ok_or_else(|| place.faulty(key)),
        }
    }

    fn write(&self, written: WrittenKeys) -> Option<Item> {
        Some(Item::Table(TableType::write(self, written)))
    }
}

/// The table that holds where the file leaves it out; nothing where it has keys without default.
pub(super) fn defaults<T: TableType>() -> Option<T> {
    let nothing = TomlNode::of_table(&TomlTable::new());
    T::from_keys(&T::keys(&TableNode::root(&nothing))).ok()
}

impl<T: TableType> SubTable for Option<T> {
    type Inner = T;
    type Keys<'a> = Option<T::Keys<'a>>;
    const SHAPE: TableShape = TableShape::One;

    fn keys<'a>(place: &TableNode<'a>, key: &str) -> Self::Keys<'a> {
        <T as SubTable>::keys(place, key)
    }

    fn from_keys(keys: &Self::Keys<'_>, _: &TableNode<'_>, _: &str) -> Result<Self, Finding> {
        match keys {
            Some(keys) => T::from_keys(keys).map(Some),
            None => Ok(None),
        }
    }

    fn write(&self, written: WrittenKeys) -> Option<Item> {
        self.as_ref()
            .and_then(|table| SubTable::write(table, written))
    }
}

impl<T: TableType> SubTable for BTreeMap<String, T> {
    type Inner = T;
    type Keys<'a> = Vec<(String, T::Keys<'a>)>;
    const SHAPE: TableShape = TableShape::ByName;

    fn keys<'a>(place: &TableNode<'a>, key: &str) -> Self::Keys<'a> {
        let Some(node) = place.node.get(key) else {
            return Vec::new();
        };
        let place = place.inner(node, key);
        let tables = node.entries().iter().filter(|entry| entry.node.is_table());
        tables
            .map(|entry| {
                let inner = place.inner(&entry.node, &entry.key);
                (entry.key.clone(), T::keys(&inner))
            })
            .collect()
    }

    fn from_keys(keys: &Self::Keys<'_>, _: &TableNode<'_>, _: &str) -> Result<Self, Finding> {
        let named = keys
            .iter()
            .map(|(name, keys)| Ok((name.clone(), T::from_keys(keys)?)));
        named.collect()
    }

    fn write(&self, written: WrittenKeys) -> Option<Item> {
        let mut table = TomlTable::new();
        table.set_implicit(true);
        for (name, inner) in self {
            table.insert(name, Item::Table(inner.write(written)));
        }
        (!table.is_empty()).then_some(Item::Table(table))
    }
}

impl<T: TableType> SubTable for Vec<T> {
    type Inner = T;
    type Keys<'a> = Vec<(String, T::Keys<'a>)>;
    const SHAPE: TableShape = TableShape::List;

    fn keys<'a>(place: &TableNode<'a>, key: &str) -> Self::Keys<'a> {
        let Some(node) = place.node.get(key) else {
            return Vec::new();
        };
        let place = place.inner(node, key);
        let named = element_names(node.items()).into_iter().zip(node.items());
        named
            .filter(|(_, node)| node.is_table())
            .map(|(name, node)| {
                let keys = T::keys(&place.inner(node, &name));
                (name, keys)
            })
            .collect()
    }

    fn from_keys(keys: &Self::Keys<'_>, _: &TableNode<'_>, _: &str) -> Result<Self, Finding> {
        keys.iter().map(|(_, keys)| T::from_keys(keys)).collect()
    }

    fn write(&self, written: WrittenKeys) -> Option<Item> {
        let mut list = ArrayOfTables::new();
        for table in self {
            list.push(table.write(written));
        }
        (!list.is_empty()).then_some(Item::ArrayOfTables(list))
    }
}
