//! The case file: what the user says, in TOML, with the unit of every number in its key.
//!
//! [`model`] holds the words, as plain data; [`fields`] knows every key with unit, range, default
//! and help; [`parse`] and [`load`] check a file against both and tell all that is wrong at once,
//! each a [`Diagnostic`] with file, line, column, key and remedy; [`edit`] sets
//! single values and keeps the rest of the file; [`channels`](mod@channels) names what a run of the
//! case records, [`AlongLine`] the quantities of the whole line.

mod along;
pub(crate) mod attachments;
pub mod channels;
mod check;
mod diagnostic;
pub mod edit;
pub mod fields;
mod invalid_value;
pub(crate) mod kind;
pub mod model;
mod quantity_id;
mod read;
mod rows;
pub(crate) mod schema;
pub mod shipped;
mod tree;
mod warm_start;
mod write;

pub use along::{AlongLine, STEADY, bends};
pub use attachments::stand_alone;
pub use channels::{
    ChannelId, ChannelNameError, ChannelQuantity, ChannelSpec, LineEnd, Site, channels,
};
pub use diagnostic::{Diagnostic, render_all};
pub use invalid_value::InvalidValue;
pub use kind::Opened;
pub use model::*;
pub use quantity_id::{ModePlane, QuantityId, Subject};
pub use read::{Loaded, load, parse, parse_beside, parse_keys};
pub(crate) use rows::Lister;
pub use rows::{FieldRow, rows};
pub use write::write;

// What another kind of file needs to be read, checked and complained about in the same way.
pub(crate) use diagnostic::Finding;
pub(crate) use fields::{join, nearest, split};

pub(crate) use tree::Node;
