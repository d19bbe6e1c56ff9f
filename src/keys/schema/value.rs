//! What a key can hold, as a type.

use toml_edit::{Array, Value as Toml};

use crate::fields::ValueType;
use crate::tree::{TomlData, TomlNode};

/// A type that the value of a key is read into.
pub trait KeyValue: Sized + Clone {
    /// What may be written for it.
    const KIND: ValueType;

    /// 0, nothing, or the first of some words.
    fn blank() -> Self;

    /// The value in a file; nothing where it is of another type.
    fn read(node: &TomlNode) -> Option<Self>;

    /// The value as TOML.
    fn write(&self) -> Toml;

    /// What holds where the key is not given and has no default; nothing where it is needed.
    fn absent() -> Option<Self> {
        None
    }

    /// A default as it stands in a file: as it is declared, unless it is a word.
    fn default_text(&self, declared: &'static str) -> &'static str {
        declared
    }
}

/// The type of a field: a value, or an optional one.
pub trait FieldType: Sized {
    /// The value.
    type Given: KeyValue;

    /// The field of what a key holds; nothing where a value is needed and there is none.
    fn hold(given: Option<Self::Given>) -> Option<Self>;

    /// The field of a value, or a blank one.
    fn or_blank(value: Option<Self::Given>) -> Self;

    /// The value that the field holds.
    fn given(&self) -> Option<&Self::Given>;
}

impl<T: KeyValue> FieldType for T {
    type Given = T;

    fn hold(given: Option<T>) -> Option<Self> {
        given.or_else(T::absent)
    }

    fn or_blank(value: Option<T>) -> Self {
        value.unwrap_or_else(T::blank)
    }

    fn given(&self) -> Option<&T> {
        Some(self)
    }
}

impl<T: KeyValue> FieldType for Option<T> {
    type Given = T;

    fn hold(given: Option<T>) -> Option<Self> {
        Some(given)
    }

    fn or_blank(value: Option<T>) -> Self {
        value
    }

    fn given(&self) -> Option<&T> {
        self.as_ref()
    }
}

/// How a default that is declared as a literal becomes a value.
pub trait FromDefault<L> {
    /// The value.
    fn from_default(declared: L) -> Self;
}

impl FromDefault<&str> for String {
    fn from_default(declared: &str) -> Self {
        declared.to_owned()
    }
}

macro_rules! own_default {
    ($($type:ty),*) => { $(
        impl FromDefault<Self> for $type {
            fn from_default(declared: Self) -> Self {
                declared
            }
        }
    )* };
}

own_default!(f64, bool, usize, u32, u64, [f64; 2], [f64; 3]);

impl KeyValue for f64 {
    const KIND: ValueType = ValueType::Number;

    fn blank() -> Self {
        0.0
    }

    fn read(node: &TomlNode) -> Option<Self> {
        node.number()
    }

    fn write(&self) -> Toml {
        (*self).into()
    }
}

macro_rules! whole_number {
    ($($type:ty),*) => { $(
        impl KeyValue for $type {
            const KIND: ValueType = ValueType::Integer;

            fn blank() -> Self {
                0
            }

            fn read(node: &TomlNode) -> Option<Self> {
                match node.data {
                    TomlData::Integer(value) => Self::try_from(value).ok(),
                    _ => None,
                }
            }

            fn write(&self) -> Toml {
                i64::try_from(*self).unwrap_or(i64::MAX).into()
            }
        }
    )* };
}

whole_number!(usize, u32, u64);

impl KeyValue for bool {
    const KIND: ValueType = ValueType::Boolean;

    fn blank() -> Self {
        false
    }

    fn read(node: &TomlNode) -> Option<Self> {
        match node.data {
            TomlData::Boolean(value) => Some(value),
            _ => None,
        }
    }

    fn write(&self) -> Toml {
        (*self).into()
    }
}

impl KeyValue for String {
    const KIND: ValueType = ValueType::Text;

    fn blank() -> Self {
        Self::new()
    }

    fn read(node: &TomlNode) -> Option<Self> {
        node.text().map(str::to_owned)
    }

    fn write(&self) -> Toml {
        self.as_str().into()
    }
}

fn written<T: KeyValue>(items: &[T]) -> Toml {
    Toml::Array(items.iter().map(KeyValue::write).collect::<Array>())
}

fn items<T: KeyValue>(node: &TomlNode) -> Option<Vec<T>> {
    match &node.data {
        TomlData::List(items) => items.iter().map(T::read).collect(),
        _ => None,
    }
}

macro_rules! numbers {
    ($($count:literal: $kind:ident),*) => { $(
        impl KeyValue for [f64; $count] {
            const KIND: ValueType = ValueType::$kind;

            fn blank() -> Self {
                [0.0; $count]
            }

            fn read(node: &TomlNode) -> Option<Self> {
                node.numbers()?.try_into().ok()
            }

            fn write(&self) -> Toml {
                written(self)
            }
        }
    )* };
}

numbers!(2: Pair, 3: Triple);

/// A type that lists are made of.
pub trait ListElement: KeyValue {
    /// What a list of them is.
    const LIST: ValueType;
}

impl ListElement for f64 {
    const LIST: ValueType = ValueType::List;
}

impl ListElement for String {
    const LIST: ValueType = ValueType::Words;
}

impl<T: ListElement> KeyValue for Vec<T> {
    const KIND: ValueType = T::LIST;

    fn blank() -> Self {
        Self::new()
    }

    /// Another key gives the list in another way.
    fn absent() -> Option<Self> {
        Some(Self::new())
    }

    fn read(node: &TomlNode) -> Option<Self> {
        items(node)
    }

    fn write(&self) -> Toml {
        written(self)
    }
}
