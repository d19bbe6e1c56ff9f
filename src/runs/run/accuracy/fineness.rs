//! How fine mesh and steps are on a level of the search.

use super::super::companions::Coarsening;
use super::searchable::Searchable;

/// Mesh and steps of a level.
#[derive(Debug, Clone, PartialEq)]
pub struct Fineness {
    /// Segments of every part that is divided by itself.
    pub segments: Vec<usize>,
    /// Length of the steps by that which would be taken.
    pub steps: f64,
}

/// Segments and steps of the first level, by those of the file. Runs much coarser than this agree with each other although none is
/// right.
pub(super) const COARSEST: usize = 16;

impl Fineness {
    /// That of the first level, or this many times finer where that does not come to its end.
    pub(super) fn first(own: &impl Searchable, finer: usize) -> Self {
        let coarsest = (COARSEST / finer).max(1);
        let mut mesh = coarsest;
        while mesh > 1 && !own.keeps_its_places(mesh) {
            mesh /= 2;
        }
        let mut steps = coarsest as f64;
        // A step may err by the size of the line at most.
        while steps > 1.0 && own.steps().tolerance * steps.powi(3) > 1.0 {
            steps /= 2.0;
        }
        let segments = own.segments().into_iter().zip(own.fewest());
        Self {
            segments: segments
                .map(|(segments, fewest)| segments.div_ceil(mesh).max(fewest))
                .collect(),
            steps,
        }
    }

    /// That of the file as it is set.
    pub(super) fn as_set(own: &impl Searchable) -> Self {
        Self {
            segments: own.segments(),
            steps: 1.0,
        }
    }

    /// What a run as fine as this takes, by another of the same \[-\].
    pub(super) fn work(&self) -> f64 {
        self.segments.iter().sum::<usize>().max(1) as f64 / self.steps
    }

    /// Twice as fine in this.
    pub(super) fn finer(&self, what: Coarsening) -> Self {
        let mut finer = self.clone();
        match what {
            Coarsening::Steps => finer.steps *= 0.5,
            Coarsening::Mesh => finer.segments.iter_mut().for_each(|n| *n *= 2),
        }
        finer
    }

    /// How many times as many segments as these the part has that has the most more.
    #[must_use]
    pub fn finest_by(&self, own: &[usize]) -> f64 {
        let parts = own.iter().zip(&self.segments);
        let finer = parts.map(|(own, now)| *now as f64 / *own as f64);
        finer.fold(0.0, f64::max)
    }
}
