//! A ship at a single-point mooring.
//!
//! [`model`] holds the words of a ship file, [`fields`] its keys with unit, range, default and help, [`parse`] and
//! [`load`] check it, [`edit`] lists and sets its keys. [`loads`] are wind, current and mean drift, whose coefficients are
//! [`curve`]s; [`heading`] finds every heading at which they are in balance (by [`roots`]), [`mooring`] how far the ship
//! then lies from its anchor; [`Rest`] is all of it. [`picture`], [`tables`] and [`text`] put it in charts and words.

mod check;
pub mod curve;
pub mod edit;
pub mod fields;
pub mod heading;
pub mod held;
pub mod loads;
pub mod model;
pub mod moored;
pub mod mooring;
pub mod motion;
pub mod picture;
pub mod quantities;
mod read;
mod rest;
pub mod roots;
pub mod rope;
pub mod rope_tables;
pub mod statistics;
pub mod tables;
pub mod text;
mod voyage;

pub use model::Ship;
pub use read::{Loaded, is_ship, load, parse, read, text_of};
pub use rest::{Rest, Station};
pub use voyage::Voyage;
