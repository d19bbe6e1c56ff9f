//! Lines in motion: explicit Runge-Kutta, implicit generalized-alpha, and the march that leaves
//! inertia out. All three take a [`System`](crate::solve::System) and pour into a
//! [`Sink`](crate::solve::Sink); none knows a case, a file or a screen.

pub mod alpha;
pub mod carried;
pub mod damping;
pub mod march;
pub mod quasi;
pub mod rk4;

pub use carried::Carried;
pub use march::{Grid, March, MarchError, Outcome, Place, Step, StepError, Stepper, Tally};
