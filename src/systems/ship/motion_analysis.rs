//! Motion analysis of a ship: records of its six motions and their statistics.

use std::path::Path;

use rayon::prelude::*;

use super::model::MotionSource;
use super::motion::record::MotionRecord;
use super::motion::wave_response::WaveResponse;
use super::motion::{MotionStatisticsError, ShipMotion, point_displacement};
use super::static_analysis::StaticAnalysis;
use crate::case::Diagnostic;
use crate::numerics::V3;
use crate::numerics::statistics::Statistics;
use crate::physics::sea::Moments;

/// The six motions of a ship.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionAnalysis {
    /// The motions as regular components.
    pub motion: ShipMotion,
    /// Their records: surge, sway, heave \[m\], roll, pitch, yaw \[rad\].
    pub records: Vec<MotionRecord>,
    /// Statistics of displacement, velocity and acceleration of each.
    pub statistics: Vec<[Statistics; 3]>,
    /// The waves that the ship responds to; absent for motions by published statistics.
    pub waves: Option<WaveRealisation>,
}

/// A realisation of a sea state against its target.
#[derive(Debug, Clone, PartialEq)]
pub struct WaveRealisation {
    /// Response of the ship.
    pub response: WaveResponse,
    /// Moments of the spectrum.
    pub target: Moments,
    /// Moments of the record of the elevation at the ship.
    pub realised: Moments,
    /// Statistics of that record \[m\].
    pub elevation: Statistics,
}

/// Why there is no motion.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MotionError {
    /// No motion has the given statistics.
    #[error(transparent)]
    Statistics(#[from] MotionStatisticsError),
    /// The RAO file is invalid.
    #[error("{0}")]
    File(Diagnostic),
    /// The ship has no equilibrium heading.
    #[error(
        "without a stable equilibrium heading the relative wave direction is undefined; give motion.heading_deg"
    )]
    NoHeading,
}

impl MotionAnalysis {
    /// The motions of the file's seed; absent without `[motion]`. `folder` is that of the ship's file.
    ///
    /// # Errors
    /// [`MotionError`].
    #[must_use]
    pub fn of_statics(
        statics: &StaticAnalysis,
        folder: &Path,
    ) -> Option<Result<Self, MotionError>> {
        statics.ship.motion.as_ref()?;
        Some(Self::new(statics, folder))
    }

    fn new(statics: &StaticAnalysis, folder: &Path) -> Result<Self, MotionError> {
        let settings = statics.ship.motion.as_ref().ok_or(MotionError::NoHeading)?;
        let response = match settings.by {
            MotionSource::Statistics => None,
            MotionSource::Responses => {
                let given = settings.heading_deg.map(f64::to_radians);
                let equilibrium = || statics.governing().map(|one| one.yaw.heading);
                let heading = given.or_else(equilibrium).ok_or(MotionError::NoHeading)?;
                Some(WaveResponse::read(settings, heading, folder).map_err(MotionError::File)?)
            }
        };
        let motion = ShipMotion::new(settings, response.as_ref(), settings.seed())?;
        let records = motion.records();
        let statistics = records
            .par_iter()
            .map(|r| [&r.x, &r.v, &r.a].map(|values| Statistics::of_values(values)))
            .collect();
        let waves = response.map(|response| WaveRealisation::new(response, &motion));
        Ok(Self {
            motion,
            records,
            statistics,
            waves,
        })
    }

    /// Response of the ship to waves; absent for motions by published statistics.
    #[must_use]
    pub fn response(&self) -> Option<&WaveResponse> {
        self.waves.as_ref().map(|waves| &waves.response)
    }

    /// Displacements of a point at `arm` \[m\] in ship axes, at every instant.
    #[must_use]
    pub fn point_displacements(&self, arm: &V3) -> Vec<V3> {
        let instants = 0..self.motion.instants;
        instants
            .map(|i| point_displacement(&self.records, arm, i))
            .collect()
    }
}

impl WaveRealisation {
    fn new(response: WaveResponse, motion: &ShipMotion) -> Self {
        let record = MotionRecord::new(&motion.waves, 0.0, motion.step, motion.instants);
        let (elevation, rate) = (
            Statistics::of_values(&record.x),
            Statistics::of_values(&record.v),
        );
        Self {
            target: response.spectrum.moments(),
            realised: Moments {
                m0: elevation.deviation.powi(2),
                m2: rate.deviation.powi(2),
            },
            elevation,
            response,
        }
    }
}
