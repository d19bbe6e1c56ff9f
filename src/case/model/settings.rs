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
    /// Unstretched arc lengths from end A at which a shape is given, from 0 to the whole line \[m\].
    pub arc_m: Option<Vec<f64>>,
    /// x there \[m\]; straight in between.
    pub x_m: Option<Vec<f64>>,
    /// y there \[m\]; absent: 0.
    pub y_m: Option<Vec<f64>>,
    /// z there \[m\].
    pub z_m: Option<Vec<f64>>,
    /// Directory of a stored run of the same line, from where that stands; its state is one of the files of the case.
    pub from_run: Option<String>,
    /// Velocity of the whole line at time zero, of what is not held \[m/s\].
    pub velocity_m_per_s: [f64; 3],
}

impl Default for Start {
    fn default() -> Self {
        Self {
            shape: StartShape::Equilibrium,
            azimuth_deg: 0.0,
            elevation_deg: 0.0,
            arc_m: None,
            x_m: None,
            y_m: None,
            z_m: None,
            from_run: None,
            velocity_m_per_s: [0.0; 3],
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
    /// As the coordinates along its arc length say.
    Given,
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
    /// Runge-Kutta or generalized-alpha, whichever is estimated to cost less; the run tells which and why.
    Auto,
}

/// What is recorded and how often.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Interval of the time history \[s\].
    pub interval_s: f64,
    /// Interval of the stored line shapes \[s\].
    pub shape_interval_s: f64,
    /// Whether the energy of the line is recorded.
    pub energy: bool,
    /// When greatest and smallest values along the line are taken.
    pub envelope: EnvelopeOf,
    /// From which time on root mean square displacements along the line are taken \[s\]; absent: none are.
    pub response_from_s: Option<f64>,
}

/// What the envelopes along the line are of.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EnvelopeOf {
    /// The output times, unless a limit, a published extreme or a trend of the line asks for more.
    #[default]
    Outputs,
    /// Every step.
    Steps,
}

impl Default for Output {
    fn default() -> Self {
        Self {
            interval_s: 0.5,
            shape_interval_s: 5.0,
            energy: false,
            envelope: EnvelopeOf::Outputs,
            response_from_s: None,
        }
    }
}

/// Natural modes about the static shape, told beside the results of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Modes {
    /// How many, the lowest first.
    #[serde(default = "ten")]
    pub count: usize,
    /// A frequency \[Hz\], such as that of the waves: the run tells which mode lies nearest to it.
    pub near_hz: Option<f64>,
}

fn ten() -> usize {
    10
}

impl Modes {
    /// What a run tells of them, where a channel would stand: frequencies by their number among the modes in the plane of
    /// the line and out of it, and the numbers of those nearest to the frequency given.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let mut names = Vec::new();
        for plane in ["in_plane", "out_of_plane"] {
            names.extend((1..=self.count).map(|n| format!("{plane}_hz[{n}]")));
            names.extend(self.near_hz.map(|_| format!("{plane}_mode_near")));
        }
        names
    }
}

/// A sea bed: level, or sloping evenly.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Seabed {
    /// Depth below still water \[m\], at the place below.
    pub depth_m: f64,
    /// Place (x, y) of that depth \[m\]; matters on a slope.
    #[serde(default)]
    pub depth_at_m: [f64; 2],
    /// How steeply the bed rises towards the azimuth below \[deg\]; negative where it falls.
    #[serde(default)]
    pub slope_deg: f64,
    /// Direction in which the bed rises, from +x towards +y \[deg\].
    #[serde(default)]
    pub slope_azimuth_deg: f64,
    /// Push per area and depth below it \[N/m³\].
    #[serde(default = "bed_stiffness")]
    pub stiffness_n_per_m3: f64,
    /// Push per area and speed into it \[N s/m³\].
    #[serde(default)]
    pub damping_n_s_per_m3: f64,
    /// Coefficient of friction along the line, and across it unless that is given \[-\]; absent: none.
    pub friction: Option<f64>,
    /// Coefficient of friction across the line \[-\].
    pub friction_lateral: Option<f64>,
    /// How friction acts.
    #[serde(default)]
    pub friction_law: FrictionLaw,
    /// Stiffness of a grip per area \[N/m³\]; absent: as that of the push.
    pub grip_stiffness_n_per_m3: Option<f64>,
    /// Speed below which friction by `zhu-2017` is in proportion to the speed \[m/s\].
    #[serde(default = "slip_speed")]
    pub slip_speed_m_per_s: f64,
}

impl Seabed {
    /// A level bed at this depth \[m\] without friction; all else as in a file that leaves it out.
    #[must_use]
    pub fn level(depth_m: f64) -> Self {
        Self {
            depth_m,
            depth_at_m: [0.0; 2],
            slope_deg: 0.0,
            slope_azimuth_deg: 0.0,
            stiffness_n_per_m3: bed_stiffness(),
            damping_n_s_per_m3: 0.0,
            friction: None,
            friction_lateral: None,
            friction_law: FrictionLaw::default(),
            grip_stiffness_n_per_m3: None,
            slip_speed_m_per_s: slip_speed(),
        }
    }
}

/// How friction of the bed acts.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum FrictionLaw {
    /// Holds at rest by a spring, and is dragged along beyond what friction bears.
    #[default]
    #[serde(rename = "grip")]
    Grip,
    /// Against the velocity and in proportion to it below a slip speed (Zhu, Yin and Shen 2017, eq. 9); holds nothing.
    #[serde(rename = "zhu-2017")]
    Zhu2017,
}

fn bed_stiffness() -> f64 {
    1.0e5
}

fn slip_speed() -> f64 {
    0.01
}
