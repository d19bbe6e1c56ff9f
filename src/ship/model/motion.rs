//! The words of a ship's motion.

use serde::Deserialize;

use crate::ship::motion::spectral_band::MotionRms;

/// The ship's motion in its sea: made to statistics, or its answer to the waves.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// What the motion is made from.
    #[serde(default)]
    pub by: MotionSource,
    /// Seed of the records.
    #[serde(default = "seed")]
    pub seed: u32,
    /// Length of a record \[s\].
    #[serde(default = "three_hours")]
    pub duration_s: f64,
    /// Step of a record \[s\].
    #[serde(default = "quarter")]
    pub step_s: f64,
    /// Regular components: of each band of a statistic, or of the sea.
    #[serde(default = "hundred")]
    pub components: usize,
    /// The point that the rope hangs from, from the ship's reference point forward, to port, up \[m\].
    #[serde(default)]
    pub hang_point_m: [f64; 3],
    /// Period of the slow motion at the mooring, where the statistics need one \[s\].
    #[serde(default = "slow")]
    pub slow_period_s: f64,
    /// Mean of surge, sway, heave \[m\].
    #[serde(default)]
    pub translation_mean_m: [f64; 3],
    /// Mean of roll, pitch, yaw \[deg\].
    #[serde(default)]
    pub rotation_mean_deg: [f64; 3],
    /// Root mean square of surge, sway, heave about nothing, the mean counted in \[m\].
    #[serde(default)]
    pub translation_rms_m: [f64; 3],
    /// Root mean square of roll, pitch, yaw \[deg\].
    #[serde(default)]
    pub rotation_rms_deg: [f64; 3],
    /// Root mean square of their velocities \[m/s\].
    #[serde(default)]
    pub translation_velocity_rms_m_per_s: [f64; 3],
    /// Root mean square of their velocities \[deg/s\].
    #[serde(default)]
    pub rotation_velocity_rms_deg_per_s: [f64; 3],
    /// Root mean square of their accelerations \[m/s²\].
    #[serde(default)]
    pub translation_acceleration_rms_m_per_s2: [f64; 3],
    /// Root mean square of their accelerations \[deg/s²\].
    #[serde(default)]
    pub rotation_acceleration_rms_deg_per_s2: [f64; 3],
    /// The file of the ship's responses, from the folder of the ship's.
    #[serde(default)]
    pub responses: String,
    /// Spectrum of the waves.
    #[serde(default)]
    pub spectrum: SpectrumKind,
    /// Significant wave height \[m\].
    #[serde(default)]
    pub significant_height_m: f64,
    /// Peak period of the waves \[s\].
    #[serde(default)]
    pub peak_period_s: f64,
    /// Peak enhancement of a JONSWAP spectrum \[-\].
    #[serde(default = "gamma")]
    pub gamma: f64,
    /// Where the waves run to, from +x towards +y \[deg\].
    #[serde(default)]
    pub waves_towards_deg: f64,
    /// Where the bow points, from +x towards +y; absent: the heading at which the ship rests \[deg\].
    pub heading_deg: Option<f64>,
}

/// What a motion is made from.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum MotionSource {
    /// Root mean squares of each degree of freedom.
    #[default]
    Statistics,
    /// Responses to a sea.
    Responses,
}

/// The spectra there are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SpectrumKind {
    /// JONSWAP.
    #[default]
    Jonswap,
    /// Pierson-Moskowitz.
    #[serde(rename = "pierson-moskowitz")]
    PiersonMoskowitz,
}

impl Motion {
    /// The seed as the generator takes it.
    #[must_use]
    pub fn seed(&self) -> u64 {
        u64::from(self.seed)
    }

    /// Instants of a record, one a step; the next would be the first again.
    #[must_use]
    pub fn instants(&self) -> usize {
        (self.duration_s / self.step_s).round().max(1.0) as usize
    }

    /// Mean and root mean squares of a degree of freedom, 0 to 5 \[m or rad\].
    #[must_use]
    pub fn target(&self, degree: usize) -> (f64, MotionRms) {
        let i = degree % 3;
        if degree < 3 {
            let rms = MotionRms {
                displacement: self.translation_rms_m[i],
                velocity: self.translation_velocity_rms_m_per_s[i],
                acceleration: self.translation_acceleration_rms_m_per_s2[i],
            };
            return (self.translation_mean_m[i], rms);
        }
        let rms = MotionRms {
            displacement: self.rotation_rms_deg[i].to_radians(),
            velocity: self.rotation_velocity_rms_deg_per_s[i].to_radians(),
            acceleration: self.rotation_acceleration_rms_deg_per_s2[i].to_radians(),
        };
        (self.rotation_mean_deg[i].to_radians(), rms)
    }
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

fn gamma() -> f64 {
    3.3
}
