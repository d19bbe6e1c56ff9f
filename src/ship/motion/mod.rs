//! The six motions of a ship in a sea, made to have given statistics, and the motion of a point fixed to it.
//!
//! Axes of the ship: x forward, y to port, z up; rotations by the right hand, of first order. Motions in different degrees
//! of freedom are independent of each other: their phases are not known from statistics of each alone.

pub mod band;
pub mod record;
pub mod tables;

use rayon::prelude::*;

use self::band::{Band, BandError, Scatter, bands};
use self::record::Record;
use super::model::Motion;
use crate::linalg::V3;
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
    /// The motions of a seed. Their statistics are the same for every seed, the records differ.
    ///
    /// # Errors
    /// [`MotionError`] for statistics that no motion has.
    pub fn new(words: &Motion, seed: u64) -> Result<Self, MotionError> {
        let mut degrees = Vec::with_capacity(6);
        for degree in 0..6 {
            degrees.push(Self::degree(words, degree, seed)?);
        }
        let degrees = <[Degree; 6]>::try_from(degrees).map_err(|_| MotionError {
            degree: 0,
            why: "not six degrees of freedom".to_owned(),
        })?;
        Ok(Self {
            degrees,
            step: words.step_s,
            instants: instants(words),
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
        let duration = words.step_s * instants(words) as f64;
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

/// Instants of a record, one a step; the next would be the first again.
fn instants(words: &Motion) -> usize {
    (words.duration_s / words.step_s).round().max(1.0) as usize
}

/// Displacement of a point at `arm` \[m\] in the axes of the ship, at an instant of the six records.
#[must_use]
pub fn point(records: &[Record], arm: &V3, instant: usize) -> V3 {
    let q = |degree: usize| records[degree].x[instant];
    let (shift, turn) = (V3::new(q(0), q(1), q(2)), V3::new(q(3), q(4), q(5)));
    shift + turn.cross(arm)
}
