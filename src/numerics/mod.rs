//! Numerical methods that know no cable: 3 x 3 blocks and the block-banded solver.

pub mod block_band;
mod both_ends;
pub mod lanes;
mod lu;

pub use block_band::{BlockBand, SingularBlock};

/// A vector of three numbers.
pub type V3 = nalgebra::Vector3<f64>;

/// A 3 x 3 block.
pub type M3 = nalgebra::Matrix3<f64>;
