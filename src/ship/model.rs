//! A ship at a single-point mooring as the user words it: one struct a table of the file, one field a key.

mod motion;

use std::collections::BTreeMap;

use serde::Deserialize;

pub use motion::{Motion, MotionSource, SpectrumKind};

use crate::case::Mark;
use crate::reference::PublishedNumber;

/// Everything a ship file says.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ship {
    /// The ship, and what holds for it as a whole.
    #[serde(rename = "ship")]
    pub particulars: Particulars,
    /// The wind, and the ship's coefficients in it.
    pub wind: Option<Wind>,
    /// The current, and the ship's coefficients in it.
    pub current: Option<Current>,
    /// The waves' mean drift, and the ship's coefficients for it.
    pub drift: Option<Drift>,
    /// The line that holds the ship at its bow.
    pub mooring: Option<Mooring>,
    /// The ship's mass, and what the water adds to it.
    pub hull: Option<Hull>,
    /// The ship's motion in its sea.
    pub motion: Option<Motion>,
    /// The ship and its anchor line in time.
    pub coupled: Option<CoupledSettings>,
    /// The rope to a platform that follows the motion.
    pub rope: Option<Rope>,
    /// What the source printed of the motion.
    #[serde(default)]
    pub published: Vec<PublishedNumber>,
    /// Where the inputs come from that the source does not print.
    #[serde(default)]
    pub marks: BTreeMap<String, Mark>,
}

/// The ship, and what holds for it as a whole.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Particulars {
    /// One line.
    pub title: String,
    /// Where the data come from.
    #[serde(default)]
    pub source: String,
    /// A few sentences: what is missing in the source, what was decided.
    #[serde(default)]
    pub notes: String,
    /// Length over all \[m\].
    pub length_m: f64,
    /// Draught \[m\].
    pub draft_m: f64,
    /// Where the mooring holds the ship, forward of its centre, in shares of the length over all \[-\].
    #[serde(default = "arm")]
    pub arm_fraction: f64,
    /// Density of the water \[kg/m³\].
    #[serde(default = "sea_water")]
    pub water_density_kg_per_m3: f64,
    /// Density of the air \[kg/m³\].
    #[serde(default = "air")]
    pub air_density_kg_per_m3: f64,
    /// Gravity \[m/s²\].
    #[serde(default = "standard_gravity")]
    pub gravity_m_per_s2: f64,
}

impl Particulars {
    /// From the ship's centre forward to the mooring point \[m\]: ARM of eq. (2).
    #[must_use]
    pub fn arm(&self) -> f64 {
        self.arm_fraction * self.length_m
    }
}

/// The wind, and the ship's coefficients in it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Wind {
    /// Speed \[m/s\].
    pub speed_m_per_s: f64,
    /// Where it blows to, from +x towards +y \[deg\].
    pub towards_deg: f64,
    /// Area seen from ahead \[m²\].
    pub frontal_area_m2: f64,
    /// Area seen from the side \[m²\].
    pub lateral_area_m2: f64,
    /// Coefficients against the angle.
    #[serde(flatten)]
    pub coefficients: Coefficients,
}

/// The current, and the ship's coefficients in it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Current {
    /// Speed over the draught \[m/s\].
    pub speed_m_per_s: f64,
    /// Where it runs to, from +x towards +y \[deg\].
    pub towards_deg: f64,
    /// Coefficients against the angle.
    #[serde(flatten)]
    pub coefficients: Coefficients,
}

/// The waves' mean drift, and the ship's coefficients for it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Drift {
    /// Significant wave height \[m\].
    pub significant_height_m: f64,
    /// Where the waves run to, from +x towards +y \[deg\].
    pub towards_deg: f64,
    /// Coefficients against the angle.
    #[serde(flatten)]
    pub coefficients: Coefficients,
}

/// Coefficients of a load along the ship, across it, and in yaw, against the angle from where the bow points to where the
/// flow goes: 0 with the flow from astern. Either a table (`angle_deg`, `surge`, `sway`, `yaw`) or Fourier series.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
pub struct Coefficients {
    /// Angles of the table, rising from 0: up to 180, the other side by symmetry, or to less than 360 \[deg\].
    #[serde(default)]
    pub angle_deg: Vec<f64>,
    /// Coefficients forward \[-\].
    #[serde(default)]
    pub surge: Vec<f64>,
    /// Coefficients to port \[-\].
    #[serde(default)]
    pub sway: Vec<f64>,
    /// Coefficients in yaw, bow to port \[-\].
    #[serde(default)]
    pub yaw: Vec<f64>,
    /// What lies between the points of the table.
    #[serde(default)]
    pub interpolation: Interpolation,
    /// Amplitudes of cos(0), cos(α), cos(2α), ... forward \[-\].
    #[serde(default)]
    pub surge_cosines: Vec<f64>,
    /// Amplitudes of sin(α), sin(2α), ... to port \[-\].
    #[serde(default)]
    pub sway_sines: Vec<f64>,
    /// Amplitudes of sin(α), sin(2α), ... in yaw \[-\].
    #[serde(default)]
    pub yaw_sines: Vec<f64>,
}

/// What lies between the points of a table.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Interpolation {
    /// Straight lines.
    Linear,
    /// The cubic spline that is periodic with its first and second derivative.
    #[default]
    Cubic,
}

/// The line that holds the ship at its bow, from the anchor on a flat bed.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mooring {
    /// Length \[m\].
    pub length_m: f64,
    /// Weight in water, as mass \[kg/m\].
    pub wet_weight_kg_per_m: f64,
    /// Axial stiffness EA \[N\].
    pub ea_n: f64,
    /// Depth of the bed below still water \[m\].
    pub depth_m: f64,
    /// Height of the point that the ship holds the line by, above still water \[m\].
    #[serde(default)]
    pub fairlead_z_m: f64,
}

/// The ship's mass and what the water adds to it, about the ship's reference point: amidships, on the centre line, in the still
/// water line. Matrices are in SI units, in the order surge, sway, heave, roll, pitch, yaw: six numbers are the diagonal,
/// thirty-six the rows.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Hull {
    /// Mass \[kg\].
    pub mass_kg: f64,
    /// Radii of gyration in roll, pitch and yaw, about the centre of gravity \[m\].
    pub gyration_m: [f64; 3],
    /// Centre of gravity from the reference point, forward, to port, up \[m\].
    #[serde(default)]
    pub centre_m: [f64; 3],
    /// Added mass.
    #[serde(default)]
    pub added_mass_si: Vec<f64>,
    /// Damping, beside that of wind and current on the moving ship.
    #[serde(default)]
    pub damping_si: Vec<f64>,
    /// Restoring by water and weight, without the mooring.
    #[serde(default)]
    pub restoring_si: Vec<f64>,
}

/// The ship and its anchor line in time, both in one system of equations.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoupledSettings {
    /// Time that is followed \[s\].
    #[serde(default = "half_hour")]
    pub duration_s: f64,
    /// Step \[s\].
    #[serde(default = "tenth")]
    pub step_s: f64,
    /// Segments of the line.
    #[serde(default = "forty")]
    pub segments: usize,
    /// The waves grow smoothly from nothing over this time \[s\].
    #[serde(default = "minute")]
    pub ramp_s: f64,
    /// Statistics count from here on \[s\].
    #[serde(default = "five_minutes")]
    pub from_s: f64,
    /// The ship is let go turned by this about its fairlead \[deg\].
    #[serde(default)]
    pub start_yaw_deg: f64,
    /// Mass of the anchor line in air \[kg/m\].
    pub line_mass_kg_per_m: f64,
    /// Diameter of the anchor line, for drag and added mass \[m\].
    pub line_diameter_m: f64,
    /// Drag coefficient across the line \[-\].
    #[serde(default)]
    pub drag_normal: f64,
    /// Drag coefficient along the line \[-\].
    #[serde(default)]
    pub drag_tangential: f64,
    /// Added mass coefficient across the line \[-\].
    #[serde(default = "one")]
    pub added_mass_normal: f64,
}

/// The rope to a platform that follows the motion.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rope {
    /// The ropeway's file, from the folder of the ship's.
    pub ropeway: String,
    /// Where the platform lies from the hang point, from the bow to port \[deg\].
    pub bearing_deg: f64,
    /// Which motion the rope's end follows.
    #[serde(default)]
    pub follows: Follows,
    /// Records, of as many seeds, for the greatest tension to expect.
    #[serde(default = "ten")]
    pub records: usize,
}

/// Which motion of the ship its rope follows.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Follows {
    /// That of `[motion]`.
    #[default]
    Motion,
    /// That of the ship coupled with its anchor line.
    Coupled,
}

fn arm() -> f64 {
    0.48
}

fn sea_water() -> f64 {
    1025.0
}

fn air() -> f64 {
    1.225
}

fn standard_gravity() -> f64 {
    9.80665
}

fn ten() -> usize {
    10
}

fn half_hour() -> f64 {
    1800.0
}

fn tenth() -> f64 {
    0.1
}

fn forty() -> usize {
    40
}

fn minute() -> f64 {
    60.0
}

fn five_minutes() -> f64 {
    300.0
}

fn one() -> f64 {
    1.0
}
