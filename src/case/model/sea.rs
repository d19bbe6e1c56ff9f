//! Waves, and the surface of the water.

use serde::{Deserialize, Serialize};

/// Long-crested waves, regular or irregular, by Airy's linear theory.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Waves {
    /// Regular, or irregular from a spectrum.
    pub kind: WaveKind,
    /// Height of regular waves from trough to crest \[m\].
    pub height_m: Option<f64>,
    /// Period of regular waves \[s\].
    pub period_s: Option<f64>,
    /// Phase of regular waves \[deg\]: the surface over x = y = 0 is `H/2 cos(2πt/T + phase)`.
    #[serde(default)]
    pub phase_deg: f64,
    /// Significant height of irregular waves \[m\].
    pub significant_height_m: Option<f64>,
    /// Period of the spectrum's peak \[s\].
    pub peak_period_s: Option<f64>,
    /// The spectrum of irregular waves.
    #[serde(default)]
    pub spectrum: SpectrumName,
    /// Peak enhancement of a JONSWAP spectrum \[-\].
    #[serde(default = "gamma")]
    pub gamma: f64,
    /// Number of regular components that irregular waves are made of.
    #[serde(default = "components")]
    pub components: usize,
    /// Seed of the random frequencies and phases: the same seed, the same waves.
    #[serde(default = "seed")]
    pub seed: u64,
    /// Direction the waves run to, from +x towards +y \[deg\].
    #[serde(default)]
    pub direction_deg: f64,
    /// Depth of the sea \[m\]; absent: that of the sea bed, or deep water where there is none.
    pub depth_m: Option<f64>,
    /// The waves grow smoothly from nothing over this time \[s\].
    #[serde(default)]
    pub ramp_s: f64,
    /// How kinematics is carried up to the surface.
    #[serde(default)]
    pub stretching: StretchingName,
    /// How it falls with depth.
    #[serde(default)]
    pub decay: DecayName,
    /// Depth below which nothing moves, for the decays that end \[m\].
    #[serde(default = "decay_depth")]
    pub decay_depth_m: f64,
    /// What of the water's motion reaches the line.
    #[serde(default)]
    pub load: WaveLoadName,
    /// Where the height of the waves is recorded, x and y \[m\]; absent: over end B where it has a position, else over
    /// end A.
    pub gauge_m: Option<[f64; 2]>,
}

impl Waves {
    /// Regular waves of this height \[m\] and period \[s\] along x; all else as in a file that leaves it out.
    #[must_use]
    pub fn regular(height_m: f64, period_s: f64) -> Self {
        Self {
            kind: WaveKind::Regular,
            height_m: Some(height_m),
            period_s: Some(period_s),
            phase_deg: 0.0,
            significant_height_m: None,
            peak_period_s: None,
            spectrum: SpectrumName::default(),
            gamma: gamma(),
            components: components(),
            seed: seed(),
            direction_deg: 0.0,
            depth_m: None,
            ramp_s: 0.0,
            stretching: StretchingName::default(),
            decay: DecayName::default(),
            decay_depth_m: decay_depth(),
            load: WaveLoadName::default(),
            gauge_m: None,
        }
    }
}

pub(super) fn gamma() -> f64 {
    3.3
}

pub(super) fn components() -> usize {
    100
}

pub(super) fn seed() -> u64 {
    1
}

fn decay_depth() -> f64 {
    200.0
}

/// The kinds of waves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum WaveKind {
    /// One component.
    Regular,
    /// Many, from a spectrum.
    Irregular,
}

/// The spectra known by name.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SpectrumName {
    /// JONSWAP (Hasselmann et al. 1973).
    #[default]
    Jonswap,
    /// Pierson and Moskowitz 1964.
    PiersonMoskowitz,
}

/// How kinematics is carried up to the surface.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum StretchingName {
    /// The formula as it stands.
    None,
    /// Above still water as at it.
    #[default]
    Vertical,
    /// Still water moved to the surface (Wheeler 1970).
    Wheeler,
    /// Above still water in a straight line.
    Linear,
}

/// How the motion of the water falls with depth.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DecayName {
    /// Airy's theory.
    #[default]
    Airy,
    /// The same down to a depth, nothing below.
    AiryCut,
    /// The logarithm that ends at a depth.
    Logarithmic,
}

/// What of the water's motion reaches the line.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum WaveLoadName {
    /// Velocity and acceleration.
    #[default]
    Morison,
    /// The acceleration alone.
    Inertia,
}

/// Whether the line leaves the water.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum WaterSurface {
    /// All of the line counts as under water, at any height.
    #[default]
    Ignored,
    /// Above the surface the line has its weight in air, and no drag nor added mass.
    Crossed,
}
