//! What holds for the keys of every kind of file.

mod keys;
mod names;
mod paths;

pub use keys::{check as check_keys, fields_here, subtable};
pub use names::{unknown, unknown_name, used_twice};
pub use paths::{existing, marks, names, unknown_path};
