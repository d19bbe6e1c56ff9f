//! The ropeway between a ship and a fixed platform: what its rope carries, how deep the cargo hangs, and
//! what the winch on the ship must do.
//!
//! The source is a paper of the Military Transportation Institute and Tianjin University on supplying a platform from an
//! anchored ship over a ropeway (about 2016; its text is at hand without title and names, so that it is
//! cited here as the Tianjin paper). Its model stands in [`paper`], with [`bare`], [`loaded`] and [`parabola`]; beside it
//! [`exact`], the elastic rope with the cargo on it, and [`line`](mod@line), the same as a discretised line of the ordinary kind.
//!
//! [`model`] holds the words of a ropeway file, [`fields`] its keys, [`parse`] and [`load`] check it, [`edit`] sets them.

pub mod bare;
pub mod edit;
pub mod exact;
pub mod fields;
pub mod full;
pub mod hauling;
pub mod held;
pub mod line;
pub mod loaded;
pub mod model;
pub mod motion;
pub mod motions;
pub mod paper;
pub mod parabola;
pub mod picture;
pub mod quantities;
mod read;
mod search;
mod service;
pub mod swing;
pub mod tables;
pub mod text;
mod trouble;
pub mod winch;
mod work;

pub use model::Ropeway;
pub(crate) use read::RopewayFile;
pub(crate) use read::is_ropeway;
pub use read::{Loaded, load, parse};
pub use service::{Followed, MARGIN};
pub use trouble::Trouble;
pub use work::{Readings, Worked, work};
