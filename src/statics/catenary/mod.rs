//! Marine lines at rest in still water, in closed form.
//!
//! A line is elastic, without bending stiffness, and uniform by sections; the bed is rigid. Forces are
//! found to rounding, not to a tolerance in metres, and every answer has been put back into the
//! equations with 30 digits before it is given out; otherwise there is a [`CatenaryError`] in words.
//!
//! ```
//! use seacable::statics::catenary::{Bed, Ends, Line, SectionProps, Shape};
//!
//! // 900 m of chain from an anchor on the bed to a fairlead 100 m above it, 860 m away.
//! let chain = [SectionProps::new(900.0, 1_200.0, 5.0e8)];
//! let line = Line {
//!     ends: Ends { x_m: 860.0, z_m: 100.0 },
//!     sections: &chain,
//!     bed: Some(Bed::default()),
//!     surface_above_a_m: None,
//! };
//! let rest = line.solve()?;
//! assert_eq!(rest.shape, Shape::PartlyOnBed);
//! assert!(rest.residual < 1e-12);
//! // A fairlead moved by a metre: start from here.
//! let moved = Line { ends: Ends { x_m: 861.0, z_m: 100.0 }, ..line }.solve_from(&rest)?;
//! assert!(moved.h_b_n > rest.h_b_n);
//! # Ok::<(), seacable::statics::catenary::CatenaryError>(())
//! ```
//!
//! Signs: `h` is the horizontal part of the tension; `v_b` pulls B down and `v_a` pulls A up when
//! positive. Where the equations come from stands beside them: hanging stretches in `span`, the free
//! line in `free`, lines on the bed in `incline` and `trough`, several sections in `composite`, those on a slope or with
//! friction in `laid`.
//!
//! Sources: H. M. Irvine, *Cable Structures*, MIT Press 1981, chapter 1 (elastic catenary); J. M. Jonkman,
//! *Dynamics Modeling and Loads Analysis of an Offshore Floating Wind Turbine*, NREL/TP-500-41958,
//! 2007, section 2.6 (form of the case on the bed, with friction).

mod assemble;
mod build;
mod build_bed;
mod chain;
mod composite;
mod descent;
mod error;
mod free;
mod incline;
mod laid;
mod laid_shown;
mod line;
mod place;
mod single;
mod solution;
mod span;

mod trough;

pub use error::CatenaryError;
pub use line::{Bed, Ends, Line, SectionProps};
pub use solution::{Point, Shape, Solution};

use solution::Seed;

impl Line<'_> {
    /// The line at rest.
    ///
    /// # Errors
    /// [`CatenaryError`]: inputs that no line can have, lines without an answer or without a single one, and
    /// answers that could not be verified. Never a number that is not an answer.
    pub fn solve(&self) -> Result<Solution, CatenaryError> {
        self.start(Seed::None)
    }

    /// The line at rest, started from the solution of one much like it; quicker, and the same answer.
    ///
    /// # Errors
    /// As [`Line::solve`].
    pub fn solve_from(&self, neighbour: &Solution) -> Result<Solution, CatenaryError> {
        self.start(neighbour.seed)
    }

    fn start(&self, seed: Seed) -> Result<Solution, CatenaryError> {
        match self.sections {
            [only] if only.clump_n == 0.0 => {
                single::solve(self.ends, *only, self.bed, self.surface_above_a_m, seed)
            }
            _ => composite::solve(self),
        }
    }
}
