//! What a key can hold, as a type.

use toml_edit::{Array, Value as Toml};

use crate::case::fields::Kind;
use crate::case::tree::{Data, Node};

/// A type that the value of a key is read into.
pub(crate) trait Value: Sized + Clone {
    /// What may be written for it.
    const KIND: Kind;

    /// 0, nothing, or the first of some words.
    fn blank() -> Self;

    /// The value in a file; nothing where it is of another type.
    fn read(node: &Node) -> Option<Self>;

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
pub(crate) trait Held: Sized {
    /// The value.
    type Given: Value;

    /// The field of what a key holds; nothing where a value is needed and there is none.
    fn hold(given: Option<Self::Given>) -> Option<Self>;

    /// The field of a value, or a blank one.
    fn or_blank(value: Option<Self::Given>) -> Self;

    /// The value that the field holds.
    fn given(&self) -> Option<&Self::Given>;
}

impl<T: Value> Held for T {
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

impl<T: Value> Held for Option<T> {
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
pub(crate) trait FromDefault<L> {
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

impl Value for f64 {
    const KIND: Kind = Kind::Number;

    fn blank() -> Self {
        0.0
    }

    fn read(node: &Node) -> Option<Self> {
        node.number()
    }

    fn write(&self) -> Toml {
        (*self).into()
    }
}

macro_rules! whole_number {
    ($($type:ty),*) => { $(
        impl Value for $type {
            const KIND: Kind = Kind::Integer;

            fn blank() -> Self {
                0
            }

            fn read(node: &Node) -> Option<Self> {
                match node.data {
                    Data::Integer(value) => Self::try_from(value).ok(),
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

impl Value for bool {
    const KIND: Kind = Kind::Boolean;

    fn blank() -> Self {
        false
    }

    fn read(node: &Node) -> Option<Self> {
        match node.data {
            Data::Boolean(value) => Some(value),
            _ => None,
        }
    }

    fn write(&self) -> Toml {
        (*self).into()
    }
}

impl Value for String {
    const KIND: Kind = Kind::Text;

    fn blank() -> Self {
        Self::new()
    }

    fn read(node: &Node) -> Option<Self> {
        node.text().map(str::to_owned)
    }

    fn write(&self) -> Toml {
        self.as_str().into()
    }
}

fn written<T: Value>(items: &[T]) -> Toml {
    Toml::Array(items.iter().map(Value::write).collect::<Array>())
}

fn items<T: Value>(node: &Node) -> Option<Vec<T>> {
    match &node.data {
        Data::List(items) => items.iter().map(T::read).collect(),
        _ => None,
    }
}

impl Value for [f64; 2] {
    const KIND: Kind = Kind::Pair;

    fn blank() -> Self {
        [0.0; 2]
    }

    fn read(node: &Node) -> Option<Self> {
        node.numbers()?.try_into().ok()
    }

    fn write(&self) -> Toml {
        written(self)
    }
}

impl Value for [f64; 3] {
    const KIND: Kind = Kind::Triple;

    fn blank() -> Self {
        [0.0; 3]
    }

    fn read(node: &Node) -> Option<Self> {
        node.numbers()?.try_into().ok()
    }

    fn write(&self) -> Toml {
        written(self)
    }
}

/// A type that lists are made of.
pub(crate) trait Listed: Value {
    const LIST: Kind;
}

impl Listed for f64 {
    const LIST: Kind = Kind::List;
}

impl Listed for String {
    const LIST: Kind = Kind::Words;
}

impl<T: Listed> Value for Vec<T> {
    const KIND: Kind = T::LIST;

    fn blank() -> Self {
        Self::new()
    }

    /// Another key gives the list in another way.
    fn absent() -> Option<Self> {
        Some(Self::new())
    }

    fn read(node: &Node) -> Option<Self> {
        items(node)
    }

    fn write(&self) -> Toml {
        written(self)
    }
}
