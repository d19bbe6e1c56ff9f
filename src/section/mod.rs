//! The cross-section designer: stiffness, weight and strength of a cable from its units, layers, armour and sheaths, as a
//! material of a line case.
//!
//! [`model`] declares the keys of a section file, [`parse`] and [`load`] read and check a
//! file. [`design`](design()) lays out the geometry ([`layout`], by the [`packing`] of helices) and computes
//! [`stiffness`], [`bending`], [`weight`] and [`strength`]. [`material`] and [`material_table`](material_table()) give
//! the material. [`edit`] lists and sets single keys.

pub mod bending;
mod design;
pub mod edit;
mod element;
mod format;
mod lay_out;
mod layer_checks;
pub mod layout;
mod material_table;
pub mod model;
pub mod packing;
mod read;
pub mod stiffness;
pub mod strength;
mod units;
pub mod weight;

pub use design::{Design, design, material};
pub use element::Element;
pub use lay_out::{MOST_UNITS, lay_out};
pub use layer_checks::{LAY_ANGLES, MOST_ARMOUR};
pub use layout::{CentreCylinder, Helix, Layout, SheathTube, Shell};
pub use material_table::material_table;
pub use model::Section;
pub(crate) use read::SectionFile;
pub(crate) use read::is_section;
pub use read::{Loaded, load, parse};
