//! The six motions of a ship in a sea, and the motion of a point fixed to it.
//!
//! Made to have given statistics, motions in different degrees of freedom are independent of each other: their phases are
//! not known from statistics of each alone. Made from [`responses`], they belong to one sea. Axes of the ship: x forward,
//! y to port, z up; rotations by the right hand, of first order.

pub mod record;
pub mod spectral_band;
pub mod wave_response;

use rayon::prelude::*;

use self::record::MotionRecord;
use self::spectral_band::{MotionRms, SpectralBand, SpectralBandError, bands};
use self::wave_response::WaveResponse;
use super::model::Motion;
use crate::numerics::V3;
use crate::physics::sea::Component;

/// What is known of one degree of freedom.
#[derive(Debug, Clone, PartialEq)]
pub struct DegreeOfFreedom {
    /// Mean \[m or rad\].
    pub mean: f64,
    /// What the scatter about the mean is asked to be \[m or rad\].
    pub asked: MotionRms,
    /// The bands that have it.
    pub bands: Vec<SpectralBand>,
    /// The bands as regular components.
    pub components: Vec<Component>,
}

/// The six motions of a ship: surge, sway, heave, roll, pitch, yaw.
#[derive(Debug, Clone, PartialEq)]
pub struct ShipMotion {
    /// Each degree of freedom.
    pub degrees: [DegreeOfFreedom; 6],
    /// The waves at the ship's reference point; none where the motions are made to statistics.
    pub sea: Vec<Component>,
    /// Step of a record \[s\].
    pub step: f64,
    /// Instants of a record.
    pub instants: usize,
}

/// A degree of freedom whose statistics no motion has.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{why}")]
pub struct MotionStatisticsError {
    /// Which, 0 to 5.
    pub degree: usize,
    /// Why.
    pub why: String,
}

impl ShipMotion {
    /// The motions of a seed: the ship's answer to the sea of that seed where there is one, else made to statistics, which are
    /// the same for every seed while the records differ.
    ///
    /// # Errors
    /// [`MotionStatisticsError`] for statistics that no motion has.
    pub fn new(
        settings: &Motion,
        answer: Option<&WaveResponse>,
        seed: u64,
    ) -> Result<Self, MotionStatisticsError> {
        let sea = answer.map_or_else(Vec::new, |answer| answer.sea(settings.components, seed));
        let degrees = match answer {
            Some(answer) => answer.degrees(&sea),
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
            sea,
            step: settings.step_s,
            instants: settings.instants(),
        })
    }

    fn degree(
        settings: &Motion,
        degree: usize,
        seed: u64,
    ) -> Result<DegreeOfFreedom, MotionStatisticsError> {
        let (mean, rms) = settings.asked(degree);
        let square = rms.displacement.powi(2) - mean * mean;
        if square < 0.0 {
            return Err(MotionStatisticsError {
                degree,
                why: "the root mean square is less than the mean alone".to_owned(),
            });
        }
        let asked = MotionRms {
            displacement: square.sqrt(),
            ..rms
        };
        let bands = bands(asked, settings.slow_period_s).map_err(|why: SpectralBandError| {
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
            asked,
            bands,
            components,
        })
    }

    /// The records of all six, each summed in its own order whatever the number of threads.
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

/// Displacement of a point at `arm` \[m\] in the axes of the ship, at an instant of the six records.
#[must_use]
pub fn point(records: &[MotionRecord], arm: &V3, instant: usize) -> V3 {
    rigid_displacement(std::array::from_fn(|i| records[i].x[instant]), arm)
}

/// Displacement of a point at `arm` \[m\] by six motions: the shift, and the turn times the arm.
#[must_use]
pub fn rigid_displacement(motions: [f64; 6], arm: &V3) -> V3 {
    let q = |degree: usize| motions[degree];
    let (shift, turn) = (V3::new(q(0), q(1), q(2)), V3::new(q(3), q(4), q(5)));
    shift + turn.cross(arm)
}
