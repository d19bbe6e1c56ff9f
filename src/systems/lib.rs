//! Systems of lines, and the ropeways and ships that are computed as such.

pub mod ropeway;
pub mod ship;
pub mod system;
