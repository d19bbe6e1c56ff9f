//! The cross-section designer: from units, layers, armour and sheaths to the stiffness and weight of
//! a cable, for a line case to use.
//!
//! [`model`] holds the words of a section file, [`fields`] its keys with unit, range, default and
//! help, [`parse`] and [`load`] check it. [`design`](design()) lays the section out
//! ([`layout`], by the [`packing`] of helices) and works out [`stiffness`], [`bending`],
//! [`weight`] and [`strength`]. [`material`] and [`fragment`](fragment()) hand it to a line case. [`edit`] lists its keys for an editor
//! and sets them.

pub mod bending;
mod design;
pub mod edit;
mod element;
pub mod fields;
mod fragment;
mod lay;
pub mod layout;
mod misfit;
pub mod model;
pub mod packing;
mod read;
pub mod stiffness;
pub mod strength;
mod units;
pub mod weight;

pub use design::{Design, design, material};
pub use element::Element;
pub use fragment::{FRAGMENT_HEAD, fragment};
pub use lay::{LAY_ANGLES, MOST_ARMOUR, MOST_UNITS, lay_out};
pub use layout::{Helix, Layout, Middle, SheathTube, Shell};
pub use misfit::Misfit;
pub use model::Section;
pub(crate) use read::SectionFile;
pub(crate) use read::is_section;
pub use read::{Loaded, load, parse};
