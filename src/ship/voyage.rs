//! The ship in its sea: the records of its six motions and what they come to.

use std::path::Path;

use rayon::prelude::*;

use super::model::MotionBy;
use super::motion::record::Record;
use super::motion::responses::Answer;
use super::motion::{MotionError, SixMotions, point};
use super::rest::Rest;
use super::statistics::Statistics;
use crate::case::Diagnostic;
use crate::numerics::V3;
use crate::physics::sea::Moments;

/// The ship in its sea.
#[derive(Debug, Clone, PartialEq)]
pub struct Voyage {
    /// The motions and their components.
    pub motions: SixMotions,
    /// Their records: surge, sway, heave \[m\], roll, pitch, yaw \[rad\].
    pub records: Vec<Record>,
    /// Statistics of displacement, velocity and acceleration of each.
    pub statistics: Vec<[Statistics; 3]>,
    /// The sea that it answers, tested; absent where the motion is made to statistics.
    pub sea: Option<SeaTest>,
}

/// A sea: what is asked for, and what its record comes to.
#[derive(Debug, Clone, PartialEq)]
pub struct SeaTest {
    /// How the ship answers it.
    pub answer: Answer,
    /// Moments of the spectrum.
    pub asked: Moments,
    /// Moments of the record of the elevation at the ship.
    pub made: Moments,
    /// Statistics of that record \[m\].
    pub elevation: Statistics,
}

/// Why there is no such motion.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum VoyageError {
    /// No motion has these statistics.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// The file of responses.
    #[error("{0}")]
    File(Diagnostic),
    /// The ship has no heading.
    #[error(
        "the ship rests at no heading, so that the waves meet it at no angle; give motion.heading_deg"
    )]
    NoHeading,
}

impl Voyage {
    /// The motions of the file's seed; absent where the file has none. `folder` is that of the ship's file.
    ///
    /// # Errors
    /// [`VoyageError`].
    #[must_use]
    pub fn of(rest: &Rest, folder: &Path) -> Option<Result<Self, VoyageError>> {
        rest.ship.motion.as_ref()?;
        Some(Self::new(rest, folder))
    }

    fn new(rest: &Rest, folder: &Path) -> Result<Self, VoyageError> {
        let words = rest.ship.motion.as_ref().ok_or(VoyageError::NoHeading)?;
        let answer = match words.by {
            MotionBy::Statistics => None,
            MotionBy::Responses => {
                let told = words.heading_deg.map(f64::to_radians);
                let rests = || rest.chosen().map(|station| station.balance.heading);
                let heading = told.or_else(rests).ok_or(VoyageError::NoHeading)?;
                Some(Answer::read(words, heading, folder).map_err(VoyageError::File)?)
            }
        };
        let motions = SixMotions::new(words, answer.as_ref(), words.seed())?;
        let records = motions.records();
        let statistics = records
            .par_iter()
            .map(|r| [&r.x, &r.v, &r.a].map(|values| Statistics::of(values)))
            .collect();
        let sea = answer.map(|answer| {
            let record = Record::new(&motions.sea, 0.0, motions.step, motions.instants);
            let (elevation, rate) = (Statistics::of(&record.x), Statistics::of(&record.v));
            SeaTest {
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
    pub fn answer(&self) -> Option<&Answer> {
        self.sea.as_ref().map(|sea| &sea.answer)
    }

    /// Displacements of a point at `arm` \[m\] in the axes of the ship, at every instant.
    #[must_use]
    pub fn of_point(&self, arm: &V3) -> Vec<V3> {
        let instants = 0..self.motions.instants;
        instants.map(|i| point(&self.records, arm, i)).collect()
    }
}
