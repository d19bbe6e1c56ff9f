//! The six motions of a ship in waves, and the displacement of a point fixed to it.
//!
//! Motions by published statistics are independent of each other in different degrees of freedom: their statistics do not
//! determine their phases. Motions by [`wave_response`] respond to one sea. Ship axes: x forward, y to port, z up; right-handed
//! rotations of first order.

pub mod rao_file;
pub mod record;
pub mod spectral_band;
pub mod wave_response;

use rayon::prelude::*;

use self::record::MotionRecord;
use self::spectral_band::{MotionRms, SpectralBand, SpectralBandError, fit_bands};
use self::wave_response::WaveResponse;
use super::model::MotionSettings;
use crate::numerics::V3;
use crate::physics::sea::Component;

/// A degree of freedom.
#[derive(Debug, Clone, PartialEq)]
pub struct DegreeOfFreedom {
    /// Mean \[m or rad\].
    pub mean: f64,
    /// Target root mean squares about the mean \[m or rad\].
    pub target: MotionRms,
    /// Spectral bands with these root mean squares.
    pub bands: Vec<SpectralBand>,
    /// Regular components.
    pub components: Vec<Component>,
}

impl DegreeOfFreedom {
    /// Target root mean square of displacement about zero (`rate` 0), velocity (1) or acceleration (2).
    #[must_use]
    pub fn target_rms(&self, rate: usize) -> f64 {
        match rate {
            0 => self.target.displacement.hypot(self.mean),
            1 => self.target.velocity,
            _ => self.target.acceleration,
        }
    }
}

/// The six motions of a ship: surge, sway, heave, roll, pitch, yaw.
#[derive(Debug, Clone, PartialEq)]
pub struct ShipMotion {
    /// Each degree of freedom.
    pub degrees: [DegreeOfFreedom; 6],
    /// The waves at the ship's reference point; none for motions by published statistics.
    pub waves: Vec<Component>,
    /// Step of a record \[s\].
    pub step: f64,
    /// Instants of a record.
    pub instants: usize,
}

/// Statistics of a degree of freedom that no motion has.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{why}")]
pub struct MotionStatisticsError {
    /// Degree of freedom, 0 to 5.
    pub degree: usize,
    /// Why.
    pub why: String,
}

impl ShipMotion {
    /// The motions of a seed: the response to the waves of that seed, or motions by published statistics, which are the same
    /// for every seed while the records differ.
    ///
    /// # Errors
    /// [`MotionStatisticsError`] for statistics that no motion has.
    pub fn new(
        settings: &MotionSettings,
        response: Option<&WaveResponse>,
        seed: u64,
    ) -> Result<Self, MotionStatisticsError> {
        let waves = response.map_or_else(Vec::new, |response| {
            response.waves(settings.components, seed)
        });
        let degrees = match response {
            Some(response) => response.degrees(&waves),
            None => (0..6)
                .map(|degree| Self::degree(settings, degree, seed))
                .collect::<Result<_, _>>()?,
        };
        let degrees =
            <[DegreeOfFreedom; 6]>::try_from(degrees).map_err(|_| MotionStatisticsError {
                degree: 0,
                why: "not six degrees of freedom".to_owned(),
            })?;
        Ok(Self {
            degrees,
            waves,
            step: settings.step_s,
            instants: settings.instants(),
        })
    }

    fn degree(
        settings: &MotionSettings,
        degree: usize,
        seed: u64,
    ) -> Result<DegreeOfFreedom, MotionStatisticsError> {
        let (mean, rms) = settings.target(degree);
        let square = rms.displacement.powi(2) - mean * mean;
        if square < 0.0 {
            return Err(MotionStatisticsError {
                degree,
                why: "the root mean square, which includes the mean, is less than the mean"
                    .to_owned(),
            });
        }
        let target = MotionRms {
            displacement: square.sqrt(),
            ..rms
        };
        let bands =
            fit_bands(target, settings.slow_period_s).map_err(|why: SpectralBandError| {
                MotionStatisticsError {
                    degree,
                    why: why.to_string(),
                }
            })?;
        let streams = bands.iter().zip(2 * degree as u64..);
        let duration = settings.step_s * settings.instants() as f64;
        let components = streams
            .flat_map(|(band, stream)| band.components(settings.components, duration, seed, stream))
            .collect();
        Ok(DegreeOfFreedom {
            mean,
            target,
            bands,
            components,
        })
    }

    /// The records of all six, the same for any number of threads.
    #[must_use]
    pub fn records(&self) -> Vec<MotionRecord> {
        let each = self.degrees.par_iter();
        each.map(|d| MotionRecord::new(&d.components, d.mean, self.step, self.instants))
            .collect()
    }

    /// Time of an instant \[s\].
    #[must_use]
    pub fn time(&self, instant: usize) -> f64 {
        self.step * instant as f64
    }
}

/// Displacement of a point at `arm` \[m\] in ship axes, at an instant of the six records.
#[must_use]
pub fn point_displacement(records: &[MotionRecord], arm: &V3, instant: usize) -> V3 {
    rigid_displacement(std::array::from_fn(|i| records[i].x[instant]), arm)
}

/// Displacement of a point at `arm` \[m\] by six motions: translation plus rotation × arm.
#[must_use]
pub fn rigid_displacement(motions: [f64; 6], arm: &V3) -> V3 {
    let q = |degree: usize| motions[degree];
    let (translation, rotation) = (V3::new(q(0), q(1), q(2)), V3::new(q(3), q(4), q(5)));
    translation + rotation.cross(arm)
}
