//! Marine growth and corrosion of lines, by depth and years.
//!
//! [`material`] is the law: what a thickness of growth and a loss of diameter change of a material. [`pieces`] divides
//! sections into pieces, each with the mean of its state along it; [`settled`] finds the depths at which the aged system
//! rests, since what a line gains and loses depends on where it hangs, and where it hangs on that.

pub(super) mod check;
pub mod material;
pub mod pieces;
pub mod settled;

pub use settled::SettledAge;
