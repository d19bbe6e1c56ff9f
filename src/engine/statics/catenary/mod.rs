//! Marine lines at rest in still water, in closed form.
//!
//! A line is elastic, without bending stiffness, and uniform by sections; the bed is rigid. Forces are
//! found to rounding, not to a tolerance in metres, and every answer is put back into the equations with
//! 30 digits before it is returned; otherwise [`CatenaryLine::solve`] fails with a [`CatenaryError`].
//!
//! ```
//! use seacable_engine::statics::catenary::{CatenaryLine, CatenaryShape, EndOffset, RigidBed, SectionProperties};
//!
//! // 900 m of chain from an anchor on the bed to a fairlead 100 m above it, 860 m away.
//! let chain = [SectionProperties::new(900.0, 1_200.0, 5.0e8)];
//! let line = CatenaryLine {
//!     ends: EndOffset { x_m: 860.0, z_m: 100.0 },
//!     sections: &chain,
//!     bed: Some(RigidBed::default()),
//!     surface_above_a_m: None,
//! };
//! let rest = line.solve()?;
//! assert_eq!(rest.shape, CatenaryShape::PartlyOnBed);
//! assert!(rest.residual < 1e-12);
//! // A fairlead moved by a metre: start from here.
//! let moved = CatenaryLine { ends: EndOffset { x_m: 861.0, z_m: 100.0 }, ..line }.solve_from(&rest)?;
//! assert!(moved.h_b_n > rest.h_b_n);
//! # Ok::<(), seacable_engine::statics::catenary::CatenaryError>(())
//! ```
//!
//! Signs: `h` is the horizontal part of the tension; `v_b` pulls B down and `v_a` pulls A up when
//! positive. The equations and their sources: the elastic catenary in `span`, the suspended line in `suspended`,
//! touchdown on a level or sloping bed with friction in `touchdown`, a line that lies on a level one and is pulled at both ends in `laid_within`, a grounded length between two suspended spans in
//! `grounded_span`, several sections in `composite`, those with touchdown on a slope or with friction in
//! `composite_touchdown`, lines that leave the water in `crossing`.
//!
//! Sources: H. M. Irvine, *Cable Structures*, MIT Press 1981, chapter 1 (elastic catenary); J. M. Jonkman,
//! *Dynamics Modeling and Loads Analysis of an Offshore Floating Wind Turbine*, NREL/TP-500-41958,
//! 2007, section 2.6 (form of the case on the bed, with friction).

mod candidate;
mod composite;
mod composite_line;
mod composite_solution;
mod composite_touchdown;
mod convex_newton;
mod crossing;
mod elements;
mod end_stiffness;
mod error;
mod grounded_solution;
mod grounded_span;
mod laid_profile;
mod laid_within;
mod line;
mod local_frame;
mod planar_line;
mod profile;
mod single;
mod slope;
mod solution;
mod span;
mod suspended;
mod suspended_solution;
mod touchdown;

pub use crossing::CrossingLine;
pub use end_stiffness::EndStiffness;
pub use error::CatenaryError;
pub use line::{CatenaryLine, EndOffset, RigidBed, SectionProperties};
pub use profile::ProfilePoint;
pub use solution::{CatenaryShape, Solution};

use solution::StartingUnknown;

impl CatenaryLine<'_> {
    /// The line at rest.
    ///
    /// # Errors
    /// [`CatenaryError`]: invalid inputs, lines without an equilibrium or without a unique one, and solutions that fail
    /// their verification.
    pub fn solve(&self) -> Result<Solution, CatenaryError> {
        self.start(StartingUnknown::None)
    }

    /// The line at rest, started from the solution of a similar line; quicker, with the same result.
    ///
    /// # Errors
    /// As [`CatenaryLine::solve`].
    pub fn solve_from(&self, neighbour: &Solution) -> Result<Solution, CatenaryError> {
        self.start(neighbour.seed)
    }

    fn start(&self, seed: StartingUnknown) -> Result<Solution, CatenaryError> {
        match self.sections {
            [only] if only.clump_n == 0.0 => {
                single::solve(self.ends, *only, self.bed, self.surface_above_a_m, seed)
            }
            _ => composite::solve(self),
        }
    }
}
