//! The ship in its sea: the records of its six motions and what they come to.

use rayon::prelude::*;

use super::model::Motion;
use super::motion::record::Record;
use super::motion::{MotionError, SixMotions, point};
use super::statistics::Statistics;
use crate::linalg::V3;

/// The ship in its sea.
#[derive(Debug, Clone, PartialEq)]
pub struct Voyage {
    /// The motions and their components.
    pub motions: SixMotions,
    /// Their records: surge, sway, heave \[m\], roll, pitch, yaw \[rad\].
    pub records: Vec<Record>,
    /// Statistics of displacement, velocity and acceleration of each.
    pub statistics: Vec<[Statistics; 3]>,
}

impl Voyage {
    /// The motions of the file's seed.
    ///
    /// # Errors
    /// [`MotionError`].
    pub fn new(words: &Motion) -> Result<Self, MotionError> {
        let motions = SixMotions::new(words, words.seed())?;
        let records = motions.records();
        let statistics = records
            .par_iter()
            .map(|r| [&r.x, &r.v, &r.a].map(|values| Statistics::of(values)))
            .collect();
        Ok(Self {
            motions,
            records,
            statistics,
        })
    }

    /// Displacements of a point at `arm` \[m\] in the axes of the ship, at every instant.
    #[must_use]
    pub fn of_point(&self, arm: &V3) -> Vec<V3> {
        let instants = 0..self.motions.instants;
        instants.map(|i| point(&self.records, arm, i)).collect()
    }
}
