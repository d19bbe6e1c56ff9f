//! The ship in its sea: the records of its six motions and what they come to.

use std::path::Path;

use rayon::prelude::*;

use super::model::MotionSource;
use super::motion::record::MotionRecord;
use super::motion::wave_response::WaveResponse;
use super::motion::{MotionStatisticsError, ShipMotion, point};
use super::static_analysis::StaticAnalysis;
use crate::case::Diagnostic;
use crate::numerics::V3;
use crate::numerics::statistics::Statistics;
use crate::physics::sea::Moments;

/// The ship in its sea.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionAnalysis {
    /// The motions and their components.
    pub motions: ShipMotion,
    /// Their records: surge, sway, heave \[m\], roll, pitch, yaw \[rad\].
    pub records: Vec<MotionRecord>,
    /// Statistics of displacement, velocity and acceleration of each.
    pub statistics: Vec<[Statistics; 3]>,
    /// The sea that it answers, tested; absent where the motion is made to statistics.
    pub sea: Option<WaveRealisation>,
}

/// A sea: what is asked for, and what its record comes to.
#[derive(Debug, Clone, PartialEq)]
pub struct WaveRealisation {
    /// How the ship answers it.
    pub answer: WaveResponse,
    /// Moments of the spectrum.
    pub asked: Moments,
    /// Moments of the record of the elevation at the ship.
    pub made: Moments,
    /// Statistics of that record \[m\].
    pub elevation: Statistics,
}

/// Why there is no such motion.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MotionError {
    /// No motion has these statistics.
    #[error(transparent)]
    Motion(#[from] MotionStatisticsError),
    /// The file of responses.
    #[error("{0}")]
    File(Diagnostic),
    /// The ship has no heading.
    #[error(
        "the ship rests at no heading, so that the waves meet it at no angle; give motion.heading_deg"
    )]
    NoHeading,
}

impl MotionAnalysis {
    /// The motions of the file's seed; absent where the file has none. `folder` is that of the ship's file.
    ///
    /// # Errors
    /// [`MotionError`].
    #[must_use]
    pub fn of(statics: &StaticAnalysis, folder: &Path) -> Option<Result<Self, MotionError>> {
        statics.ship.motion.as_ref()?;
        Some(Self::new(statics, folder))
    }

    fn new(statics: &StaticAnalysis, folder: &Path) -> Result<Self, MotionError> {
        let settings = statics.ship.motion.as_ref().ok_or(MotionError::NoHeading)?;
        let answer = match settings.by {
            MotionSource::Statistics => None,
            MotionSource::Responses => {
                let told = settings.heading_deg.map(f64::to_radians);
                let rests = || {
                    statics
                        .governing()
                        .map(|equilibrium| equilibrium.yaw.heading)
                };
                let heading = told.or_else(rests).ok_or(MotionError::NoHeading)?;
                Some(WaveResponse::read(settings, heading, folder).map_err(MotionError::File)?)
            }
        };
        let motions = ShipMotion::new(settings, answer.as_ref(), settings.seed())?;
        let records = motions.records();
        let statistics = records
            .par_iter()
            .map(|r| [&r.x, &r.v, &r.a].map(|values| Statistics::of(values)))
            .collect();
        let sea = answer.map(|answer| {
            let record = MotionRecord::new(&motions.sea, 0.0, motions.step, motions.instants);
            let (elevation, rate) = (Statistics::of(&record.x), Statistics::of(&record.v));
            WaveRealisation {
                asked: answer.spectrum.moments(),
                made: Moments {
                    m0: elevation.deviation.powi(2),
                    m2: rate.deviation.powi(2),
                },
                elevation,
                answer,
            }
        });
        Ok(Self {
            motions,
            records,
            statistics,
            sea,
        })
    }

    /// How the ship answers its sea; absent where the motion is made to statistics.
    #[must_use]
    pub fn answer(&self) -> Option<&WaveResponse> {
        self.sea.as_ref().map(|sea| &sea.answer)
    }

    /// Displacements of a point at `arm` \[m\] in the axes of the ship, at every instant.
    #[must_use]
    pub fn point_displacements(&self, arm: &V3) -> Vec<V3> {
        let instants = 0..self.motions.instants;
        instants.map(|i| point(&self.records, arm, i)).collect()
    }
}
