//! Between the model and the methods: states, the traits that solvers ask for, and the one Newton iteration.

pub mod convergence;
pub mod newton;
pub mod sink;
pub mod state;
pub mod system;

pub use convergence::{Convergence, ConvergenceRate};
pub use newton::{Newton, NewtonError};
pub use sink::{AcceptedStep, Progressing, Sink};
pub use state::{BodyOnBed, HistoryVariables, RopeHistory, SharedStiffness, State};
pub use system::{
    ExplicitRhs, Factors, Hysteresis, Kinematics, Marched, MidstepBalance, Residual, StaticSearch,
};
