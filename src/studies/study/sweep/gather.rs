//! The results of a sweep from its stored runs alone, which other processes computed.

use rayon::prelude::*;

use super::{Sweep, SweepError, SweepFolder, SweepOutcomes, SweepResults};
use crate::run::RunState;
use crate::run::store;

impl Sweep {
    /// The load cases without a run, by their places in the list; where `refused` says so without those that the case refuses.
    ///
    /// # Errors
    /// The runs cannot be listed.
    pub fn missing(&self, folder: &SweepFolder, refused: bool) -> Result<Vec<usize>, SweepError> {
        let taken = folder.places_taken(self.variation.points.len())?;
        let missing = taken.par_iter().enumerate().filter(|(_, taken)| !**taken);
        let missing = missing.map(|(index, _)| index);
        Ok(match refused {
            true => missing.collect(),
            false => missing
                .filter(|index| self.refusal(*index).is_none())
                .collect(),
        })
    }

    /// Deletes runs that were stopped or killed while a program computed the sweep by itself, so that their load cases are computed anew.
    ///
    /// # Errors
    /// One is being computed, or cannot be deleted.
    pub fn clear_stopped(&self, folder: &SweepFolder) -> Result<(), SweepError> {
        let taken = folder.places_taken(self.variation.points.len())?;
        let all = taken.par_iter().enumerate().filter(|(_, taken)| **taken);
        all.try_for_each(|(index, _)| {
            let dir = folder.run(index);
            let overrides = self.overrides(&self.variation.points[index].settings);
            let stopped = |state| matches!(state, RunState::Partial | RunState::Cancelled);
            match store::read_info(&dir) {
                Ok(info) if info.overrides == overrides && stopped(info.state) => {
                    if store::is_locked(&dir) {
                        return Err(SweepError::Busy(dir));
                    }
                    store::delete(&dir).map_err(SweepError::Run)
                }
                _ => Ok(()),
            }
        })
    }

    /// What became of the load cases: their runs as they are stored, and why others are refused. Nothing is computed, and nothing deleted.
    ///
    /// # Errors
    /// The runs cannot be listed, or the sweep stores none.
    pub fn gather(&self, folder: &SweepFolder) -> Result<SweepOutcomes, SweepError> {
        let (SweepResults::Line(ids) | SweepResults::InTime(ids)) = &self.results else {
            return Err(SweepError::AtRest);
        };
        let taken = folder.places_taken(self.variation.points.len())?;
        let outcomes = taken.par_iter().enumerate().map(|(index, taken)| {
            if !taken {
                return self.refusal(index).map(Err);
            }
            let overrides = self.overrides(&self.variation.points[index].settings);
            folder.kept(index, &overrides).transpose()
        });
        Ok(SweepOutcomes::Runs(outcomes.collect(), ids.clone()))
    }
}
