//! Small dense blocks and the block-tridiagonal solver. Knows no cable.

pub mod block_tri;

pub use block_tri::{BlockTri, SingularBlock};

/// A vector of three numbers.
pub type V3 = nalgebra::Vector3<f64>;

/// A 3 x 3 block.
pub type M3 = nalgebra::Matrix3<f64>;
