//! The library of line types: chains, wire ropes and fibre ropes by nominal diameter, from published formulas.
//!
//! [`LINE_TYPES`] is the table, a formula with its source for every property. [`properties()`] computes them at a diameter and
//! converts coefficients on the nominal diameter to those on the volume-equivalent one, which is the
//! [`diameter_m`](crate::case::Material::diameter_m) of a material. [`material_table()`] writes the material with formulas and sources
//! as comments. A [`Library`] holds types of a file of the user.
//!
//! Sources:
//! * IACS UR W22, *Offshore mooring chain*: proof and breaking loads of chain by grade.
//! * DNV-OS-E301, *Position mooring* (2010 and later), Ch. 2: effective modulus of chain, drag coefficients of mooring lines.
//! * Bureau Veritas NR 493, *Classification of mooring systems for permanent and mobile offshore units*: added mass.
//! * Orcina, *OrcaFlex help*, "Chain" and "Rope/wire": diameters and masses of chain, six-strand wire rope.
//! * NREL, *MoorPy*, default line properties (BSD-3-Clause): fits to makers' data of spiral strand and fibre ropes.

mod law;
mod library;
mod material_table;
mod properties;
mod table;
#[cfg(test)]
mod tests;

pub use law::DiameterLaw;
pub use library::{Library, LibraryType, Polynomial, UnreadType};
pub use material_table::{material_name, material_table, with_material};
pub use properties::{
    LineProperties, NominalDiameterError, Property, TypeDescription, nominal_diameter, properties,
};
pub use table::{Coefficient, Family, LINE_TYPES, LineType, OuterDiameter, Sourced, find};
