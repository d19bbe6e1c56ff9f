//! Lines in motion: explicit Runge-Kutta, implicit generalized-alpha, and the march that leaves
//! inertia out. All three take a [`System`](crate::solve::System) and pour into a
//! [`Sink`](crate::solve::Sink); none knows a case, a file or a screen.

pub mod generalized_alpha;
pub mod march;
pub mod method_state;
pub mod numerical_damping;
pub mod quasi_static;
pub mod rk4;

pub use march::{
    Grid, March, MarchError, MarchProgress, MarchSummary, StepError, Stepper, TimeStep, WorkCounts,
};
pub use method_state::MethodState;
