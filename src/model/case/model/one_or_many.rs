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
