//! A ship at a single-point mooring.
//!
//! [`model`] holds the words of a ship file, [`fields`] its keys with unit, range, default and help, [`parse`] and
//! [`load`] check it, [`edit`] lists and sets its keys. [`loads`] are wind, current and mean drift, whose coefficients are
//! [`curve`]s; [`heading`] finds every heading at which they are in balance (by [`roots`]), [`mooring`] how far the ship
//! then lies from its anchor, [`fishtail`] whether it stays there once it moves; [`Rest`] is all of it, worked out at once.
//!
//! What takes its time is [`AtSea`]: the [`Voyage`] with six [`motion`]s, ship and anchor line in time ([`coupled`], on the
//! equations of [`moored`]), and the [`rope`] to a platform that follows. [`picture`], [`tables`] and [`text`] put all of it
//! in charts and words.

mod check;
pub mod coupled;
pub mod coupled_tables;
pub mod curve;
pub mod decay;
pub mod edit;
pub mod fields;
pub mod fishtail;
pub mod forcing;
pub mod heading;
pub mod held;
pub mod hull;
pub mod loads;
pub mod model;
pub mod moored;
pub mod mooring;
pub mod motion;
pub mod picture;
pub mod plan;
pub mod quantities;
mod read;
mod rest;
pub mod roots;
pub mod rope;
pub mod rope_dynamic;
pub mod rope_tables;
mod sea;
pub mod setting;
pub mod statistics;
pub mod tables;
pub mod text;
mod voyage;

pub use model::Ship;
pub(crate) use read::ShipFile;
pub(crate) use read::is_ship;
pub use read::{Loaded, load, parse};
pub use rest::{Rest, Station};
pub use sea::AtSea;
pub use voyage::{SeaTest, Voyage, VoyageError};
