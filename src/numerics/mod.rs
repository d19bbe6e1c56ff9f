//! Numerical methods that know no cable.
//!
//! * [`BlockBand`]: block-banded systems of 3 x 3 blocks, eliminated from both ends in two [`lanes`].
//! * [`Condensation`]: such a system condensed onto its first and last nodes.
//! * [`envelope`], [`envelope_factors`], [`BlockEnvelope`]: factors of sparse matrices, symmetric and in blocks; [`lowest_modes`](mod@lowest_modes): eigenvalues by them.
//! * [`roots`], [`log_newton`], [`root_isolation`], [`golden_section`](mod@golden_section), [`minimum`]: roots and minima of one unknown.
//! * [`interpolation`], [`spline`], [`piecewise`], [`quadrature`]: tables over an ascending grid.
//! * [`fourier`]: the components of a record.
//! * [`depth_grid`]: a depth over a rectangular grid of places.
//! * [`statistics`], [`random`]: moments and extremes of records; reproducible random numbers.
//! * `elementary`: exponentials and logarithms of many numbers, several at a time.
//! * [`double_double`], [`hyperbolic`]: arithmetic of 32 digits; hyperbolic functions without cancellation.

pub mod block_band;
pub mod block_envelope;
mod both_ends;
pub mod condensation;
pub mod depth_grid;
pub mod double_double;
pub mod elementary;
pub mod envelope;
pub mod envelope_factors;
pub mod fourier;
pub mod golden_section;
pub mod hyperbolic;
pub mod interpolation;
pub mod lanes;
pub mod log_newton;
pub mod lowest_modes;
mod lu;
pub mod minimum;
pub mod piecewise;
pub mod processor;
pub mod quadrature;
pub mod random;
pub mod richardson;
pub mod root_isolation;
pub mod roots;
mod side_front;
pub mod spline;
pub mod statistics;

pub use block_band::{Banded, BlockBand, SingularBlock};
pub use block_envelope::BlockEnvelope;
pub use condensation::{Condensation, CondensedBeside, EndBlocks};
pub use depth_grid::{DepthAt, DepthGrid, DepthGridError, DepthInterpolation};
pub use side_front::SideCouplings;

/// A vector of three numbers.
pub type V3 = nalgebra::Vector3<f64>;

/// A 3 x 3 block.
pub type M3 = nalgebra::Matrix3<f64>;
