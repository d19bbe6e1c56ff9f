//! Time integration: classical Runge-Kutta, generalized-alpha, and the quasi-static march without inertia. All take a
//! system by the traits of [`solve`](crate::solve) and report to a [`Sink`](crate::solve::Sink); none knows a case, a file
//! or a screen.

pub mod alpha_scheme;
pub mod generalized_alpha;
pub mod march;
pub mod method;
pub mod method_state;
pub mod numerical_damping;
pub mod progress;
pub mod quasi_static;
pub mod rk4;
pub mod step_control;
pub mod stepper;

pub use alpha_scheme::{AlphaScheme, ErrorLimits};
pub use march::{March, MarchSummary};
pub use method::Method;
pub use method_state::MethodState;
pub use progress::MarchProgress;
pub use step_control::MarchError;
pub use stepper::{Integrator, StepError, Stepper, TimeStep, WorkCounts};
