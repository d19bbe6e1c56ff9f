//! How a case is computed: start, solver, output.

use serde::{Deserialize, Serialize};

/// Where the line is at time zero, at rest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Start {
    /// How the line lies.
    pub shape: StartShape,
    /// Azimuth of a straight line with a free end, from +x towards +y \[deg\].
    pub azimuth_deg: f64,
    /// Elevation of a straight line with a free end, positive up \[deg\].
    pub elevation_deg: f64,
}

impl Default for Start {
    fn default() -> Self {
        Self {
            shape: StartShape::Equilibrium,
            azimuth_deg: 0.0,
            elevation_deg: 0.0,
        }
    }
}

/// How the line lies at time zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum StartShape {
    /// Straight and unstretched from end A, in the direction given.
    Straight,
    /// In static equilibrium.
    Equilibrium,
}

/// Which solver, and its settings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Solver {
    /// The method.
    pub method: Method,
    /// Simulated time \[s\].
    pub duration_s: f64,
    /// Time step \[s\]; absent: chosen by the solver and told in the run. `alpha` then takes steps of varying length,
    /// as its error estimate allows.
    pub time_step_s: Option<f64>,
    /// Error that `alpha` allows in one step of varying length \[-\]: in positions as a share of the line's length
    /// L, in velocities of 2 sqrt(g L).
    pub step_tolerance: f64,
    /// Spectral radius of generalized-alpha at infinite frequency, 0 to 1 \[-\].
    pub rho_inf: f64,
    /// Greatest Newton iterations a step before it is halved.
    pub max_iterations: usize,
    /// Newton stops when no node moves by more than this \[m\].
    pub position_tolerance_m: f64,
    /// Whether companion runs estimate the time and mesh error of every result.
    pub error_estimate: bool,
}

impl Default for Solver {
    fn default() -> Self {
        Self {
            method: Method::Alpha,
            duration_s: 600.0,
            time_step_s: None,
            step_tolerance: 2e-5,
            rho_inf: 0.4,
            max_iterations: 30,
            position_tolerance_m: 1e-5,
            error_estimate: true,
        }
    }
}

/// The solvers.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// Static equilibrium by Newton on the nodes.
    Static,
    /// Quasi-static march: equilibrium of weight and drag at each instant, inertia left out.
    Quasi,
    /// Explicit Runge-Kutta of order 4.
    Rk4,
    /// Implicit generalized-alpha.
    #[default]
    Alpha,
}

/// What is recorded and how often.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Interval of the time history \[s\].
    pub interval_s: f64,
    /// Interval of the stored line shapes \[s\].
    pub shape_interval_s: f64,
}

impl Default for Output {
    fn default() -> Self {
        Self {
            interval_s: 0.5,
            shape_interval_s: 5.0,
        }
    }
}

/// A flat sea bed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Seabed {
    /// Depth below still water \[m\].
    pub depth_m: f64,
    /// Push per area and depth below it \[N/m³\].
    #[serde(default = "bed_stiffness")]
    pub stiffness_n_per_m3: f64,
    /// Push per area and speed into it \[N s/m³\].
    #[serde(default)]
    pub damping_n_s_per_m3: f64,
}

fn bed_stiffness() -> f64 {
    1.0e5
}
