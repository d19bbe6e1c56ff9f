//! Tables as the user had them: filter, sorting, columns that were hidden, by their heads.

use serde::{Deserialize, Serialize};

/// A table as the user had it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TableMemory {
    /// Which.
    pub(super) table: String,
    pub(super) filter: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub(super) sort: String,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(super) greatest_first: bool,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) hidden: Vec<String>,
}

/// The table of runs as the user had it: columns by the key of an input, the name of a result, or their heads.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RunsMemory {
    pub(super) filter: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub(super) sort: String,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(super) greatest_first: bool,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) hidden: Vec<String>,
}
