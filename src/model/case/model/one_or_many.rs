//! A number, or a list of them.

use super::super::{
    TomlNode,
    fields::ValueType::{self, NumberOrList},
    schema::{FromDefault, KeyValue},
};

/// One number, or a list of numbers.
#[derive(Debug, Clone, PartialEq)]
pub enum OneOrMany {
    /// One number.
    One(f64),
    /// A list.
    Many(Vec<f64>),
}

impl OneOrMany {
    /// Whether all of its numbers are zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        match self {
            Self::One(value) => *value == 0.0,
            Self::Many(values) => values.iter().all(|value| *value == 0.0),
        }
    }

    /// The number that all of it is; nothing where they differ.
    #[must_use]
    pub fn alike(&self) -> Option<f64> {
        match self {
            Self::One(value) => Some(*value),
            Self::Many(values) => {
                let first = *values.first()?;
                values.iter().all(|value| *value == first).then_some(first)
            }
        }
    }
}

impl KeyValue for OneOrMany {
    const KIND: ValueType = NumberOrList;

    fn blank() -> Self {
        Self::One(0.0)
    }

    fn read(node: &TomlNode) -> Option<Self> {
        let one = node.number().map(Self::One);
        one.or_else(|| node.numbers().map(Self::Many))
    }

    fn write(&self) -> toml_edit::Value {
        match self {
            Self::One(value) => value.write(),
            Self::Many(values) => values.write(),
        }
    }
}

impl FromDefault<f64> for OneOrMany {
    fn from_default(declared: f64) -> Self {
        Self::One(declared)
    }
}
