//! The instructions of the processor that the program runs on.
//!
//! Code that is generic over [`pulp::Simd`] and makes no use of it is compiled once for each set of instructions; without fused products, and with
//! a fixed number of partial sums, its bits are the same on all.

use std::sync::LazyLock;

use pulp::Arch;

/// Numbers that such code takes side by side, and partial sums that it has, whatever the processor.
pub const LANES: usize = 4;

/// So many numbers side by side.
pub type Lanes = [f64; LANES];

/// What this processor has.
pub static ARCH: LazyLock<Arch> = LazyLock::new(Arch::new);
