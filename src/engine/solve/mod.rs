//! Between the model and the methods: states, the traits that solvers ask for, and the one Newton iteration.

pub mod banded;
pub mod convergence;
pub mod integrated;
pub mod newton;
pub mod parted;
pub mod sink;
pub mod state;
pub mod system;

pub use banded::BandedEquations;
pub use convergence::{Convergence, ConvergenceRate};
pub use integrated::{Integrated, Marched};
pub use newton::{Iterated, Newton, NewtonError};
pub use parted::{Parted, PartedSystem};
pub use sink::{AcceptedStep, Progressing, Sink};
pub use state::{BodyOnBed, HistoryVariables, RopeHistory, SharedStiffness, State};
pub use system::{
    ExplicitRhs, Factors, Hysteresis, Kinematics, MidstepBalance, Residual, StaticSearch,
};
