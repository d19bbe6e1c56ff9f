//! A case as the user words it: one struct a table of the file, one field a key.
//!
//! Units stand in the field names, exactly as in the file. Nothing here computes; `scene` turns a
//! [`Case`] into numbers for the solvers. Optional keys are `Option` where "not given" means
//! something, and carry their default otherwise.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// Everything a case file says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// What the case is, for people.
    pub case: About,
    /// Water and gravity.
    #[serde(default)]
    pub environment: Environment,
    /// The current; absent means still water.
    pub current: Option<Current>,
    /// Materials by name, referred to by the sections of the line.
    pub materials: BTreeMap<String, Material>,
    /// Sections of the line, from end A to end B.
    pub line: Vec<Section>,
    /// The two ends.
    pub ends: Ends,
    /// The body hung on an end of kind `payload`.
    pub payload: Option<Payload>,
    /// Floats spread over stretches of the line.
    #[serde(default)]
    pub floats: Vec<Floats>,
    /// Where the line is at time zero.
    #[serde(default)]
    pub start: Start,
    /// Which solver, and its settings.
    #[serde(default)]
    pub solver: Solver,
    /// What is recorded and how often.
    #[serde(default)]
    pub output: Output,
    /// Where inputs come from, by key path (`"payload.drag_area_m2"`): published inputs need no mark.
    #[serde(default)]
    pub marks: BTreeMap<String, Mark>,
    /// Studies: one key varied over a list of values.
    #[serde(default)]
    pub study: Vec<Study>,
    /// Published values the case is held against.
    #[serde(default)]
    pub published: Vec<Published>,
    /// Published statements of trend, checked along a study.
    #[serde(default)]
    pub trend: Vec<Trend>,
}

/// What a case is, for people.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct About {
    /// One line.
    pub title: String,
    /// Where the data come from.
    #[serde(default)]
    pub source: String,
    /// A few sentences: the scene, what is missing in the source, what was decided.
    #[serde(default)]
    pub notes: String,
}

/// Water and gravity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Environment {
    /// Gravity \[m/s²\].
    pub gravity_m_per_s2: f64,
    /// Density of the water \[kg/m³\].
    pub water_density_kg_per_m3: f64,
    /// Kinematic viscosity of the water \[m²/s\], for Reynolds numbers.
    pub kinematic_viscosity_m2_per_s: f64,
}

impl Default for Environment {
    fn default() -> Self {
        Self {
            gravity_m_per_s2: 9.80665,
            water_density_kg_per_m3: 1025.0,
            kinematic_viscosity_m2_per_s: 1.19e-6,
        }
    }
}

/// A current: uniform (`speed_m_per_s` one number) or a table over depth (lists of equal length).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Current {
    /// Speed \[m/s\]: one number, or one for each depth.
    pub speed_m_per_s: OneOrMany,
    /// Direction the water flows to, from +x towards +y \[deg\]: one number, or one for each depth.
    #[serde(default = "zero")]
    pub direction_deg: OneOrMany,
    /// Depths below still water \[m\], increasing; needed when speed or direction is a list. Linear
    /// in between (by components), constant above the first and below the last.
    pub depth_m: Option<Vec<f64>>,
}

fn zero() -> OneOrMany {
    OneOrMany::One(0.0)
}

/// One number, or a list of numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum OneOrMany {
    /// One number.
    One(f64),
    /// A list.
    Many(Vec<f64>),
}

/// What a stretch of line is made of.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Hydrodynamic (outer) diameter \[m\].
    pub diameter_m: f64,
    /// Mass per unstretched length \[kg/m\].
    pub mass_kg_per_m: f64,
    /// Weight in water as mass per unstretched length \[kg/m\]; absent: from mass, diameter and water density.
    pub wet_weight_kg_per_m: Option<f64>,
    /// Axial stiffness EA \[N\].
    pub ea_n: f64,
    /// Axial damping \[N s\]: tension per strain rate. At most one of this and the ratio.
    pub axial_damping_n_s: Option<f64>,
    /// Axial damping as a fraction of critical of a segment's highest axial mode \[-\].
    pub axial_damping_ratio: Option<f64>,
    /// Normal drag on the diameter: a coefficient or a named law \[-\].
    #[serde(default = "no_drag")]
    pub drag_normal: DragLaw,
    /// Tangential drag, on the width chosen below: a coefficient or a named law \[-\].
    #[serde(default = "no_drag")]
    pub drag_tangential: DragLaw,
    /// Reference width of tangential drag: `diameter` (Jia et al. 2019, eq. 3) or `perimeter`.
    #[serde(default)]
    pub drag_tangential_width: DragWidth,
    /// Normal added-mass coefficient on the displaced volume \[-\].
    #[serde(default = "one")]
    pub added_mass_normal: f64,
    /// Tangential added-mass coefficient on the displaced volume \[-\].
    #[serde(default)]
    pub added_mass_tangential: f64,
    /// Minimum breaking load \[N\], for checks.
    pub break_load_n: Option<f64>,
}

fn no_drag() -> DragLaw {
    DragLaw::Constant(0.0)
}

fn one() -> f64 {
    1.0
}

/// A drag coefficient, constant or from a named law of the Reynolds number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum DragLaw {
    /// The same at every Reynolds number.
    Constant(f64),
    /// A law by name.
    Named(DragLawName),
}

/// The drag laws known by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum DragLawName {
    /// Normal drag of Jia et al. 2019, eq. (4).
    #[serde(rename = "jia-2019-normal")]
    Jia2019Normal,
    /// Tangential drag of Jia et al. 2019, eq. (5).
    #[serde(rename = "jia-2019-tangential")]
    Jia2019Tangential,
}

/// The width that tangential drag is referred to.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum DragWidth {
    /// The diameter D.
    #[default]
    Diameter,
    /// The perimeter πD.
    Perimeter,
}

/// A section of the line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// Name, used in channel names and key paths (`line.polyester.length_m`).
    pub name: String,
    /// Name of its material.
    pub material: String,
    /// Unstretched length \[m\].
    pub length_m: f64,
    /// Number of segments it is divided into.
    pub segments: usize,
}

/// The two ends of the line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ends {
    /// Where arc length is zero.
    pub a: End,
    /// Where arc length is greatest.
    pub b: End,
}

/// One end of the line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct End {
    /// Name, used in channel names (`tension_n[vessel|chain]`).
    pub name: String,
    /// What holds it.
    pub kind: EndKind,
    /// Position \[m\] as \[x, y, z\], z up from still water. Needed for held ends; a free or payload
    /// end may leave it out, the start shape then gives it.
    pub position_m: Option<[f64; 3]>,
    /// Amplitude of prescribed motion along x, y, z \[m\].
    #[serde(default)]
    pub amplitude_m: [f64; 3],
    /// Period of prescribed motion \[s\].
    pub period_s: Option<f64>,
    /// Phase of prescribed motion along x, y, z \[deg\]: x = x0 + A sin(2πt/T + phase).
    #[serde(default)]
    pub phase_deg: [f64; 3],
    /// The motion grows smoothly from nothing over this time \[s\].
    #[serde(default)]
    pub ramp_s: f64,
}

/// What holds an end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum EndKind {
    /// Held at its position (a vessel taken as fixed, a platform).
    Fixed,
    /// Held at its position on the sea bed.
    Anchor,
    /// Carries the payload; otherwise free.
    Payload,
    /// Follows a prescribed motion about its position.
    Moving,
    /// Free.
    Free,
}

/// A body at the end of the line, without rotation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Payload {
    /// Mass in air \[kg\].
    pub dry_mass_kg: f64,
    /// Weight in water as mass \[kg\]. Give this or `volume_m3`, or let the shape give the volume.
    pub wet_mass_kg: Option<f64>,
    /// Displaced volume \[m³\].
    pub volume_m3: Option<f64>,
    /// Drag coefficient times area \[m²\]: one number, or along x, y, z. Absent: from the shape.
    pub drag_area_m2: Option<OneOrMany>,
    /// Added mass \[kg\]: one number, or along x, y, z. Absent: from the shape.
    pub added_mass_kg: Option<OneOrMany>,
    /// Its form, for what the keys above leave out.
    pub shape: Option<Shape>,
}

/// The form of a payload.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, tag = "kind")]
pub enum Shape {
    /// A box: length along x, breadth along y, height along z.
    Box {
        /// Length \[m\].
        length_m: f64,
        /// Breadth \[m\].
        breadth_m: f64,
        /// Height \[m\].
        height_m: f64,
    },
    /// A sphere and an upright cylinder.
    SphereAndCylinder {
        /// Diameter of the sphere \[m\].
        sphere_diameter_m: f64,
        /// Diameter of the cylinder \[m\].
        cylinder_diameter_m: f64,
        /// Length of the cylinder \[m\].
        cylinder_length_m: f64,
    },
}

/// Floats spread evenly over a stretch of a section.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Floats {
    /// The section they sit on.
    pub section: String,
    /// Where the stretch begins, from the section's end nearer to A \[m\].
    #[serde(default)]
    pub from_m: f64,
    /// Where it ends \[m\]; absent: the section's end.
    pub to_m: Option<f64>,
    /// Net lift of all of them as mass \[kg\] (buoyancy less their own weight).
    pub lift_kg: f64,
    /// Mass of all of them \[kg\].
    #[serde(default)]
    pub mass_kg: f64,
    /// Normal drag coefficient times area of all of them \[m²\].
    #[serde(default)]
    pub drag_area_m2: f64,
    /// Normal added mass of all of them \[kg\].
    #[serde(default)]
    pub added_mass_kg: f64,
}

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

/// Where an input comes from when the source does not print it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mark {
    /// Its standing.
    pub status: Standing,
    /// Why this value.
    pub reason: String,
}

/// Standing of a number, from best to worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Standing {
    /// Printed in the source.
    Published,
    /// Follows from printed numbers by algebra.
    Derived,
    /// Fitted so that printed outputs come out.
    Calibrated,
    /// An engineering choice.
    Assumed,
}

/// One key, or several together, varied over a list of values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// Name, referred to by `published` and `trend`.
    pub name: String,
    /// The key path varied (`current.speed_m_per_s`).
    pub key: String,
    /// Its values, in the unit of the key.
    pub values: Vec<f64>,
    /// What the study shows, one line.
    #[serde(default)]
    pub title: String,
}

/// A published value and how a run is held against it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Published {
    /// What it is, in words.
    pub name: String,
    /// Channel of the history (`tension_n[wire|payload]`).
    pub channel: String,
    /// What is taken of the channel.
    pub statistic: Statistic,
    /// Window of time \[s\] for the statistic; absent: the whole run.
    pub window_s: Option<[f64; 2]>,
    /// The published value, in the unit of the channel (seconds for times).
    pub value: f64,
    /// Tolerance relative to the value \[-\]. One of the two tolerances is needed.
    pub tolerance_rel: Option<f64>,
    /// Tolerance in the unit of the value.
    pub tolerance_abs: Option<f64>,
    /// Where it is printed ("sec. 2.1, fig. 5").
    pub source: String,
    /// Standing of the inputs behind the computed value, at worst.
    pub inputs: Standing,
    /// True when an input was fitted to this very number: agreement is then no evidence.
    #[serde(default)]
    pub fitted: bool,
    /// The study and the value of its key this row belongs to; absent: the case as it stands.
    pub at: Option<At>,
    /// Why the number is out of reach; the row then reads DIFFERS instead of FAIL.
    pub out_of_reach: Option<String>,
}

/// A point of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct At {
    /// Name of the study.
    pub study: String,
    /// Value of its key.
    pub value: f64,
}

/// A number taken of a channel over a window of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Statistic {
    /// Time average.
    Mean,
    /// Greatest value, over every step of the solver.
    Max,
    /// Smallest value, over every step of the solver.
    Min,
    /// Value at the end of the window.
    Final,
    /// First value less the smallest (the paper's travel distance).
    Travel,
    /// Time of the greatest value \[s\].
    TimeOfMax,
    /// Time of the smallest value \[s\].
    TimeOfMin,
    /// First time after which the channel stays within 2 % of its whole range from its final value \[s\].
    SettlingTime,
    /// First time at which the channel has gone 90 % of the way from its first to its final value \[s\].
    RiseTime,
    /// Magnitude of the mean rate of change: |final value less first value| over the window's length
    /// \[unit of the channel per second\].
    Rate,
}

impl Statistic {
    /// Every statistic, in the order in which they are explained to users.
    pub const ALL: [Self; 10] = [
        Self::Mean,
        Self::Max,
        Self::Min,
        Self::Final,
        Self::Travel,
        Self::TimeOfMax,
        Self::TimeOfMin,
        Self::SettlingTime,
        Self::RiseTime,
        Self::Rate,
    ];

    /// The word for it, in case files and in names of quantities (`tension_n[wire|payload].mean`).
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mean => "mean",
            Self::Max => "max",
            Self::Min => "min",
            Self::Final => "final",
            Self::Travel => "travel",
            Self::TimeOfMax => "time_of_max",
            Self::TimeOfMin => "time_of_min",
            Self::SettlingTime => "settling_time",
            Self::RiseTime => "rise_time",
            Self::Rate => "rate",
        }
    }

    /// Unit of the statistic of a channel that has the unit `channel` ("N" gives "N", "s" or "N/s").
    #[must_use]
    pub fn unit(self, channel: &str) -> String {
        match self {
            Self::Mean | Self::Max | Self::Min | Self::Final | Self::Travel => channel.to_owned(),
            Self::TimeOfMax | Self::TimeOfMin | Self::SettlingTime | Self::RiseTime => {
                "s".to_owned()
            }
            Self::Rate => format!("{channel}/s"),
        }
    }
}

/// A published statement of trend, checked along a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trend {
    /// The statement, in words.
    pub name: String,
    /// The study it is checked along.
    pub study: String,
    /// Channel of the history.
    pub channel: String,
    /// What is taken of the channel.
    pub statistic: Statistic,
    /// Window of time \[s\].
    pub window_s: Option<[f64; 2]>,
    /// What the statistic does as the study's values grow.
    pub expect: Direction,
    /// Where it is printed.
    pub source: String,
    /// Why it is out of reach; the row then reads DIFFERS instead of FAIL.
    pub out_of_reach: Option<String>,
}

/// What a statistic does along a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// Grows at every step.
    Rises,
    /// Shrinks at every step.
    Falls,
}
