//! Between physics and numerics: what a solver may ask of a line, and the one Newton loop.

pub mod newton;
pub mod sink;
pub mod system;

pub use newton::{Newton, NewtonError};
pub use sink::{Instant, Progressing, Sink};
pub use system::{Factors, Memory, RopeHistory, State, System};
