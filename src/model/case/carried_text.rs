//! The text of a carried file, with the tables that were parsed from it.

use std::any::Any;
use std::fmt;
use std::ops::Deref;
use std::sync::{Arc, Mutex, PoisonError};

use super::fields::ValueType;
use super::schema::KeyValue;
use super::tree::TomlNode;

/// A text that never changes, and what was parsed from it: a table that several builds need is parsed once. Copies share both.
#[derive(Clone)]
pub struct CarriedText {
    text: Arc<str>,
    tables: Arc<Mutex<Vec<Box<dyn Any + Send>>>>,
}

/// A table, and how it was parsed.
struct ParsedTable<K, T> {
    how: K,
    table: Arc<T>,
}

impl CarriedText {
    /// The table that the text holds: as it was parsed before in the same way, or parsed now. A text with a fault is parsed each time,
    /// as its message names the file as it is known there.
    ///
    /// # Errors
    /// That of parsing.
    pub fn parsed<K, T, E>(
        &self,
        how: K,
        parse: impl FnOnce(&str) -> Result<T, E>,
    ) -> Result<Arc<T>, E>
    where
        K: PartialEq + Send + 'static,
        T: Send + Sync + 'static,
    {
        // Held while it parses: others wait for the table rather than parsing it too.
        let mut tables = self.tables.lock().unwrap_or_else(PoisonError::into_inner);
        let known = tables
            .iter()
            .filter_map(|known| known.downcast_ref::<ParsedTable<K, T>>())
            .find(|known| known.how == how);
        if let Some(known) = known {
            return Ok(known.table.clone());
        }
        let table = Arc::new(parse(&self.text)?);
        tables.push(Box::new(ParsedTable {
            how,
            table: table.clone(),
        }));
        Ok(table)
    }
}

impl Deref for CarriedText {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

impl From<String> for CarriedText {
    fn from(text: String) -> Self {
        Self::from(text.as_str())
    }
}

impl From<&str> for CarriedText {
    fn from(text: &str) -> Self {
        Self {
            text: text.into(),
            tables: Arc::default(),
        }
    }
}

/// By the text alone.
impl PartialEq for CarriedText {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl fmt::Debug for CarriedText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.text.fmt(f)
    }
}

impl KeyValue for CarriedText {
    const KIND: ValueType = ValueType::Text;

    fn blank() -> Self {
        Self::from("")
    }

    fn read(node: &TomlNode) -> Option<Self> {
        node.text().map(Self::from)
    }

    fn write(&self) -> toml_edit::Value {
        (*self.text).into()
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    #[test]
    fn a_table_is_parsed_once_for_all_copies_and_each_way() {
        let text = CarriedText::from("1 2");
        let parses = Cell::new(0);
        let sum = |text: &CarriedText, times: u64| {
            let parsed = text.parsed(times, |text| {
                parses.set(parses.get() + 1);
                let numbers = text.split(' ').map(str::parse::<u64>);
                numbers.sum::<Result<u64, _>>().map(|sum| times * sum)
            });
            *parsed.unwrap()
        };
        assert_eq!([1, 1, 2].map(|times| sum(&text, times)), [3, 3, 6]);
        assert_eq!(sum(&text.clone(), 2), 6);
        assert_eq!(parses.get(), 2);
    }

    #[test]
    fn a_fault_is_told_each_time_with_the_name_at_hand() {
        let text = CarriedText::from("x");
        let fault = |name: &str| text.parsed((), |_| Err::<u8, _>(name.to_owned()));
        assert_eq!(fault("a").unwrap_err(), "a");
        assert_eq!(fault("b").unwrap_err(), "b");
    }
}
