//! A ship at a single-point mooring as the user words it: one struct a table of the file, one field a key.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::motion::band::Scatter;
use crate::case::{Mark, Standing};

/// Everything a ship file says.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ship {
    /// The ship, and what holds for it as a whole.
    #[serde(rename = "ship")]
    pub about: About,
    /// The wind, and the ship's coefficients in it.
    pub wind: Option<Wind>,
    /// The current, and the ship's coefficients in it.
    pub current: Option<Current>,
    /// The waves' mean drift, and the ship's coefficients for it.
    pub drift: Option<Drift>,
    /// The line that holds the ship at its bow.
    pub mooring: Option<Mooring>,
    /// The ship's motion in its sea.
    pub motion: Option<Motion>,
    /// The rope to a platform that follows the motion.
    pub rope: Option<Rope>,
    /// What the source printed of the motion.
    #[serde(default)]
    pub published: Vec<Published>,
    /// Where the inputs come from that the source does not print.
    #[serde(default)]
    pub marks: BTreeMap<String, Mark>,
}

/// The ship, and what holds for it as a whole.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct About {
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

impl About {
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

/// The ship's motion in its sea, by the statistics of each degree of freedom.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// Seed of the records.
    #[serde(default = "seed")]
    pub seed: u32,
    /// Length of a record \[s\].
    #[serde(default = "three_hours")]
    pub duration_s: f64,
    /// Step of a record \[s\].
    #[serde(default = "quarter")]
    pub step_s: f64,
    /// Regular components of each band.
    #[serde(default = "hundred")]
    pub components: usize,
    /// Period of the slow motion at the mooring, where the statistics need one \[s\].
    #[serde(default = "slow")]
    pub slow_period_s: f64,
    /// The point that the rope hangs from, from the ship's reference point forward, to port, up \[m\].
    #[serde(default)]
    pub hang_point_m: [f64; 3],
    /// Mean of surge, sway, heave \[m\].
    #[serde(default)]
    pub translation_mean_m: [f64; 3],
    /// Mean of roll, pitch, yaw \[deg\].
    #[serde(default)]
    pub rotation_mean_deg: [f64; 3],
    /// Root mean square of surge, sway, heave about nothing, the mean counted in \[m\].
    pub translation_rms_m: [f64; 3],
    /// Root mean square of roll, pitch, yaw \[deg\].
    pub rotation_rms_deg: [f64; 3],
    /// Root mean square of their velocities \[m/s\].
    pub translation_velocity_rms_m_per_s: [f64; 3],
    /// Root mean square of their velocities \[deg/s\].
    pub rotation_velocity_rms_deg_per_s: [f64; 3],
    /// Root mean square of their accelerations \[m/s²\].
    pub translation_acceleration_rms_m_per_s2: [f64; 3],
    /// Root mean square of their accelerations \[deg/s²\].
    pub rotation_acceleration_rms_deg_per_s2: [f64; 3],
}

impl Motion {
    /// The seed as the generator takes it.
    #[must_use]
    pub fn seed(&self) -> u64 {
        u64::from(self.seed)
    }

    /// Mean and root mean squares of a degree of freedom, 0 to 5 \[m or rad\].
    #[must_use]
    pub fn asked(&self, degree: usize) -> (f64, Scatter) {
        let i = degree % 3;
        if degree < 3 {
            let scatter = Scatter {
                displacement: self.translation_rms_m[i],
                velocity: self.translation_velocity_rms_m_per_s[i],
                acceleration: self.translation_acceleration_rms_m_per_s2[i],
            };
            return (self.translation_mean_m[i], scatter);
        }
        let scatter = Scatter {
            displacement: self.rotation_rms_deg[i].to_radians(),
            velocity: self.rotation_velocity_rms_deg_per_s[i].to_radians(),
            acceleration: self.rotation_acceleration_rms_deg_per_s2[i].to_radians(),
        };
        (self.rotation_mean_deg[i].to_radians(), scatter)
    }
}

/// The rope to a platform that follows the motion.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rope {
    /// The ropeway's file, from the folder of the ship's.
    pub ropeway: String,
    /// Where the platform lies from the hang point, from the bow to port \[deg\].
    pub bearing_deg: f64,
    /// Records, of as many seeds, for the greatest tension to expect.
    #[serde(default = "ten")]
    pub records: usize,
}

/// A published value and how the ship is held against it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Published {
    /// What it is, in words.
    pub name: String,
    /// The quantity: `pitch.velocity.rms`.
    pub quantity: String,
    /// The published value, in the unit of the quantity.
    pub value: f64,
    /// Tolerance relative to the value \[-\]. One of the two tolerances is needed; the wider one counts.
    pub tolerance_rel: Option<f64>,
    /// Tolerance in the unit of the value.
    pub tolerance_abs: Option<f64>,
    /// Where it is printed.
    pub source: String,
    /// Standing of the inputs behind the computed value, at worst.
    pub inputs: Standing,
    /// True when an input was fitted to this very number: agreement is then no evidence.
    #[serde(default)]
    pub fitted: bool,
    /// Why the number is out of reach; the row then reads DIFFERS instead of FAIL.
    pub out_of_reach: Option<String>,
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

fn seed() -> u32 {
    1
}

fn three_hours() -> f64 {
    10_800.0
}

fn quarter() -> f64 {
    0.25
}

fn hundred() -> usize {
    100
}

fn slow() -> f64 {
    100.0
}

fn ten() -> usize {
    10
}
