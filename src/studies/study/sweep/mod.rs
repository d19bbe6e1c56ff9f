//! A sweep: a case or a system of lines computed at all of its load cases, each run stored, so that a sweep that was stopped goes on.
//!
//! The results of a load case do not depend on the others nor on the number of threads: each is a run of its own, and a run that is
//! stored is not computed again. A sweep is a [`Variation`] whose points are the load cases. One program computes all of them
//! ([`Sweep::compute`]), or many compute a [`SweepPart`] each and one gathers ([`Sweep::gather`]), as the tasks of [`slurm`] do.

mod finer;
mod folder;
mod gather;
mod load_cases;
mod part;
mod plan;
mod results;
mod rounds;
mod runs;
pub mod slurm;
mod snapshot;
mod tasks;

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use serde::{Deserialize, Serialize};

pub use finer::FinerRound;
pub use folder::{StoredSweep, SweepError, SweepFolder, SweepInfo};
pub use load_cases::{SweepKind, load_cases, without_load_cases};
pub use part::{PartDone, SweepPart};
pub use plan::{PlanChoices, PlanError, SweepPlan};
pub use results::SweepResults;
pub use snapshot::{SnapshotOutcomes, SweepEntry, SweepSnapshot, stored_sweeps};

use super::points::{self, PointOutcome, Setting, side_by_side};
use super::studied::Studied;
use super::study_job::StudyJob;
use super::vary::Variation;
use super::vary::system::{self, SystemOutcome};
use crate::case::{Case, QuantityId};
use crate::run::store;
use crate::system::SystemFile;

/// What is computed: the load cases, and which results are shown.
#[derive(Debug, Clone)]
pub struct Sweep {
    /// The case and its load cases.
    pub variation: Variation,
    /// The results.
    pub results: SweepResults,
    /// Further results of a system at rest, which checks need; they follow those that are shown.
    pub needed: Vec<String>,
}

/// What became of the load cases; nothing of those that did not begin.
#[derive(Debug)]
pub enum SweepOutcomes {
    /// Runs.
    Runs(Vec<Option<PointOutcome>>, Vec<QuantityId>),
    /// Equilibria of a system.
    AtRest(Vec<Option<SystemOutcome>>, Vec<String>),
}

/// How far a sweep is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct SweepProgress {
    /// Load cases that are done.
    pub done: usize,
    /// Of which the runs were stored before.
    pub stored: usize,
    /// Load cases in all.
    pub of: usize,
}

impl Sweep {
    /// Computes the load cases side by side on the threads of the caller's pool, and stores their runs beside the folder where one is
    /// given. A load case that fails stops no other, unless its run cannot be stored, which sets `cancel`. Once that is set no further one
    /// begins.
    pub fn compute(
        &self,
        folder: Option<&SweepFolder>,
        cancel: &AtomicBool,
        told: &(dyn Fn(SweepProgress) + Sync),
    ) -> SweepOutcomes {
        let ids = match &self.results {
            SweepResults::AtRest(names) => {
                let told = |done, of| {
                    told(SweepProgress {
                        done,
                        stored: 0,
                        of,
                    });
                };
                let all: Vec<String> = names.iter().chain(&self.needed).cloned().collect();
                let found = system::compute(&self.variation, &all, cancel, &told);
                return SweepOutcomes::AtRest(found, names.clone());
            }
            SweepResults::Line(ids) | SweepResults::InTime(ids) => ids,
        };
        let all: Vec<usize> = (0..self.variation.points.len()).collect();
        let found = self.compute_some(folder, &all, cancel, told);
        SweepOutcomes::Runs(
            found.into_iter().map(|(_, outcome)| outcome).collect(),
            ids.clone(),
        )
    }

    /// Computes some load cases: each with what became of it, in their order.
    pub fn compute_some(
        &self,
        folder: Option<&SweepFolder>,
        wanted: &[usize],
        cancel: &AtomicBool,
        told: &(dyn Fn(SweepProgress) + Sync),
    ) -> Vec<(usize, Option<PointOutcome>)> {
        let progress = |done, of, stored| told(SweepProgress { done, stored, of });
        let mut known = folder.map_or_else(BTreeMap::new, |folder| self.stored(folder, wanted));
        let count = known.len();
        let left = wanted
            .iter()
            .copied()
            .filter(|index| !known.contains_key(index));
        let left: Vec<usize> = left.collect();
        let compute = |index: usize| {
            let dir = folder.map(|folder| folder.run(index));
            points::outcome(self.job(index)?, dir.as_deref(), cancel)
        };
        if let Some(folder) = folder {
            store::remove_left_beside(folder.dir());
        }
        progress(count, wanted.len(), count);
        let computed = side_by_side(left.clone(), cancel, compute, |done, of, _, _| {
            progress(count + done, count + of, count);
        });
        for (index, outcome) in left.into_iter().zip(computed) {
            if let Some(outcome) = outcome {
                known.insert(index, outcome);
            }
        }
        wanted
            .iter()
            .map(|index| (*index, known.remove(index)))
            .collect()
    }

    /// The load cases whose runs are stored, or whose place is taken.
    fn stored(&self, folder: &SweepFolder, wanted: &[usize]) -> BTreeMap<usize, PointOutcome> {
        let found = wanted.iter().filter_map(|&index| {
            let point = self.variation.points.get(index)?;
            let overrides = self.overrides(&point.settings);
            Some((index, folder.stored(index, &overrides).transpose()?))
        });
        found.collect()
    }

    /// The run of a load case.
    fn job(&self, index: usize) -> Result<StudyJob, String> {
        let settings = &self.variation.points[index].settings;
        match &self.results {
            SweepResults::InTime(_) => SystemFile::variant(&self.variation.base, settings),
            _ => Case::variant(&self.variation.base, settings),
        }
    }

    fn overrides(&self, settings: &[Setting]) -> Vec<String> {
        let set = settings.iter().map(Setting::as_override);
        self.variation
            .base
            .overrides
            .iter()
            .cloned()
            .chain(set)
            .collect()
    }
}
