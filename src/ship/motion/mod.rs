//! The six motions of a ship in a sea, and the motion of a point fixed to it.
//!
//! Made to have given statistics, motions in different degrees of freedom are independent of each other: their phases are
//! not known from statistics of each alone. Made from [`responses`], they belong to one sea. Axes of the ship: x forward,
//! y to port, z up; rotations by the right hand, of first order.

pub mod band;
pub mod record;
pub mod responses;
pub mod tables;

use rayon::prelude::*;

use self::band::{Band, BandError, Scatter, bands};
use self::record::Record;
use self::responses::Answer;
use super::model::Motion;
use crate::numerics::V3;
use crate::physics::sea::Component;

/// What is known of one degree of freedom.
#[derive(Debug, Clone, PartialEq)]
pub struct Degree {
    /// Mean \[m or rad\].
    pub mean: f64,
    /// What the scatter about the mean is asked to be \[m or rad\].
    pub asked: Scatter,
    /// The bands that have it.
    pub bands: Vec<Band>,
    /// The bands as regular components.
    pub components: Vec<Component>,
}

/// The six motions of a ship: surge, sway, heave, roll, pitch, yaw.
#[derive(Debug, Clone, PartialEq)]
pub struct SixMotions {
    /// Each degree of freedom.
    pub degrees: [Degree; 6],
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
pub struct MotionError {
    /// Which, 0 to 5.
    pub degree: usize,
    /// Why.
    pub why: String,
}

impl SixMotions {
    /// The motions of a seed: the ship's answer to the sea of that seed where there is one, else made to statistics, which are
    /// the same for every seed while the records differ.
    ///
    /// # Errors
    /// [`MotionError`] for statistics that no motion has.
    pub fn new(words: &Motion, answer: Option<&Answer>, seed: u64) -> Result<Self, MotionError> {
        let sea = answer.map_or_else(Vec::new, |answer| answer.sea(words.components, seed));
        let degrees = match answer {
            Some(answer) => answer.degrees(&sea),
            None => (0..6)
                .map(|degree| Self::degree(words, degree, seed))
                .collect::<Result<_, _>>()?,
        };
        let degrees = <[Degree; 6]>::try_from(degrees).map_err(|_| MotionError {
            degree: 0,
            why: "not six degrees of freedom".to_owned(),
        })?;
        Ok(Self {
            degrees,
            sea,
            step: words.step_s,
            instants: words.instants(),
        })
    }

    fn degree(words: &Motion, degree: usize, seed: u64) -> Result<Degree, MotionError> {
        let (mean, rms) = words.asked(degree);
        let square = rms.displacement.powi(2) - mean * mean;
        if square < 0.0 {
            return Err(MotionError {
                degree,
                why: "the root mean square is less than the mean alone".to_owned(),
            });
        }
        let asked = Scatter {
            displacement: square.sqrt(),
            ..rms
        };
        let bands = bands(asked, words.slow_period_s).map_err(|why: BandError| MotionError {
            degree,
            why: why.to_string(),
        })?;
        let streams = bands.iter().zip(2 * degree as u64..);
        let duration = words.step_s * words.instants() as f64;
        let components = streams
            .flat_map(|(band, stream)| band.components(words.components, duration, seed, stream))
            .collect();
        Ok(Degree {
            mean,
            asked,
            bands,
            components,
        })
    }

    /// The records of all six, each summed in its own order whatever the number of threads.
    #[must_use]
    pub fn records(&self) -> Vec<Record> {
        let each = self.degrees.par_iter();
        each.map(|d| Record::new(&d.components, d.mean, self.step, self.instants))
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
pub fn point(records: &[Record], arm: &V3, instant: usize) -> V3 {
    displaced(std::array::from_fn(|i| records[i].x[instant]), arm)
}

/// Displacement of a point at `arm` \[m\] by six motions: the shift, and the turn times the arm.
#[must_use]
pub fn displaced(motions: [f64; 6], arm: &V3) -> V3 {
    let q = |degree: usize| motions[degree];
    let (shift, turn) = (V3::new(q(0), q(1), q(2)), V3::new(q(3), q(4), q(5)));
    shift + turn.cross(arm)
}
