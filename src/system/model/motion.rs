//! How a system is computed in time, and what is recorded.

use crate::case::fields::{of, positive};
use crate::case::schema::{table, words};

table! {
    /// How a run in time is computed, from the equilibrium.
    #[derive(Debug, Clone, PartialEq)]
    pub struct MotionInputs => MotionInputKeys {
        /// Simulated time.
        duration_s: f64, "duration", range positive(1e6);
        /// Implicit generalized-alpha, or explicit Runge-Kutta of order 4.
        method: MotionMethod = MotionMethod::Alpha, "method";
        /// Constant time step. If absent it is chosen, and varies with the error; the run reports it.
        time_step_s: Option<f64>, "time step", range positive(1e3), absent "chosen by the solver";
        /// Error allowed in a step of varying length: in positions by the length L of the longest line, in velocities by 2 sqrt(g L).
        step_tolerance: f64 = 2e-5, "step tolerance", range positive(1.0);
        /// Spectral radius of generalized-alpha at infinite frequency: 0 damps most, 1 not at all.
        rho_inf: f64 = 0.4, "rho infinity", range of(0.0, 1.0);
        /// Newton iterations a step may take before it is halved.
        max_iterations: usize = 30, "greatest iterations", range of(1.0, 1e4);
        /// Newton stops when no node moves by more than this.
        position_tolerance_m: f64 = 1e-5, "position tolerance", range positive(1.0);
        /// Whether companion runs estimate the time and mesh error of every result.
        error_estimate: bool = true, "error estimate";
    }
}

words! {
    /// How time advances.
    #[derive(Default)]
    pub enum MotionMethod {
        /// Generalized-alpha, with steps that vary with the error.
        #[default]
        Alpha = "alpha",
        /// Runge-Kutta of order 4, with steps below the stability limit of the stiffest segment.
        Rk4 = "rk4",
    }
}

table! {
    /// What is recorded of a run in time.
    #[derive(Debug, Clone, PartialEq)]
    pub struct MotionOutput => MotionOutputKeys {
        /// Interval of the time history.
        interval_s: f64 = 0.5, "history interval", range positive(1e5);
    }
}
