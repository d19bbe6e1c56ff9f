//! Natural modes of a whole system about its rest: lines, points and bodies with the mass of all of them.
//!
//! `K x = omega² M x` with K and M the tangents by position and by acceleration that the steps in time use, read at rest with drag left out, as
//! for a line by itself ([`crate::modes`]): a system of one line between held ends has the modes of that line. The unknowns are the inner nodes of
//! the lines and the joints that are free (`SystemPencil`); ends of lines and clamps move with them.

mod asked;
mod blocks;
mod pencil;
mod whole;

pub use asked::id_of_mode;
pub(in crate::system) use asked::not_asked;
pub use whole::modes_of_system;
