//! The cross-section designer: stiffness, weight and strength of a cable from its units, layers, armour and sheaths, as a
//! material of a line case.
//!
//! [`model`] declares the keys of a section file. [`design`](design()) lays out the geometry ([`layout`], by the [`packing`]
//! of helices) and computes [`stiffness`], [`bending`], [`weight`] and [`strength`]. [`material`] and
//! [`material_table`](material_table()) give the material. [`quantities`] are what published values may name, [`validation`] compares
//! them.

pub mod bending;
mod check;
mod design;
mod element;
mod file;
mod format;
pub mod hot_spots;
mod lay_out;
pub mod layout;
mod material_table;
pub mod model;
pub mod packing;
pub mod quantities;
pub mod stiffness;
pub mod strength;
pub mod validation;
pub mod weight;

pub use check::{LAY_ANGLES, MOST_ARMOUR};
pub use design::{Design, design, material};
pub use element::CableElement;
pub use file::SECTION;
pub use lay_out::{LayoutError, LayoutKey, MOST_UNITS, lay_out};
pub use layout::{CentreCylinder, Helix, LaidLayer, SectionLayout, SheathTube};
pub use material_table::material_table;
pub use model::CrossSection;
