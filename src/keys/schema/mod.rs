//! One declaration a key. [`table!`](macro@crate::table) declares a table of a file as a struct; from it come the rows of the
//! [`Schema`](super::fields::Schema), the reading of the table from the tree of a file and the writing of it as TOML.
//!
//! A file is read in two steps. [`TableType::keys`] reads what it can: every key with its place and its value, none where the
//! value is faulty, so that checks see all tables at once. [`TableType::from_keys`] makes the struct of keys without faults.

mod key;
mod macros;
mod table;
mod value;

pub use key::{Key, TableNode};
pub use macros::{table, variants, words};
pub use table::{DeclaredSchema, SubTable, TableType, WrittenKeys, put, schema_of};
pub use value::{FieldType, FromDefault, KeyValue, ListElement};
