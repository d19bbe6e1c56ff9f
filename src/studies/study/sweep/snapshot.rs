//! A stored sweep as it is at this moment, whoever computes it: read for a screen, without holding its folder.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use rayon::prelude::*;

use super::finer::is_round;
use super::{StoredSweep, Sweep, SweepFolder, SweepInfo, SweepOutcomes, SweepPlan, SweepResults};
use crate::case::QuantityId;
use crate::files::read;
use crate::files::shallow::shallow;
use crate::run::RunState;
use crate::study::points::PointOutcome;
use crate::study::seas::{SeaResults, StoredLoadCase};
use crate::study::vary::system::SystemOutcome;

/// Load cases without a run of a sweep that has ended, of which it is asked whether the case refuses them: each takes a parsing.
const MOST_ASKED: usize = 200;

/// A sweep that is stored, as its folder is named and as its `sweep.toml` says.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepEntry {
    /// Its folder.
    pub dir: PathBuf,
    /// What it is.
    pub info: SweepInfo,
}

/// A sweep with what has become of its load cases.
#[derive(Debug, Clone)]
pub struct SweepSnapshot {
    /// Its folder.
    pub dir: PathBuf,
    /// What is computed, and what is asked of it.
    pub plan: Arc<SweepPlan>,
    /// What became of the load cases.
    pub found: SnapshotOutcomes,
}

/// What has become of load cases, shared with older looks at the same sweep.
#[derive(Debug, Clone)]
pub enum SnapshotOutcomes {
    /// Runs; nothing of those that have none.
    Runs(Vec<Option<Arc<PointOutcome>>>, Vec<QuantityId>),
    /// Equilibria, with the results that checks need after those that are shown.
    AtRest(Arc<Vec<Option<SystemOutcome>>>, Vec<String>),
}

/// The sweeps of a case file right below a directory, the newest first. Searches for a limiting value are passed over: they hold no runs
/// of their own, and rounds of finer runs, which a sweep shows in the place of its own. What cannot be read is passed over too.
#[must_use]
pub fn stored_sweeps(root: &Path, case_file: &str) -> Vec<SweepEntry> {
    let Ok(inside) = fs::read_dir(root) else {
        return Vec::new();
    };
    let dirs: Vec<PathBuf> = inside.flatten().map(|item| item.path()).collect();
    let entry = |dir: PathBuf| {
        let text = read::run_text(&dir.join(super::folder::SWEEP)).ok()?;
        let info: SweepInfo = toml::from_str(shallow(&text)).ok()?;
        let is_of = info.case_file == case_file && info.window.is_none();
        is_of.then_some(SweepEntry { dir, info })
    };
    let found = dirs.into_iter();
    let found = found.filter(|dir| !is_hidden(dir) && !is_round(dir));
    let mut found: Vec<SweepEntry> = found.filter_map(entry).collect();
    // The names end with the time at which each began.
    found.sort_by(|a, b| b.dir.cmp(&a.dir));
    found
}

/// Folders about to appear.
fn is_hidden(dir: &Path) -> bool {
    dir.file_name()
        .is_some_and(|name| name.to_string_lossy().starts_with('.'))
}

impl SweepSnapshot {
    /// Reads a sweep and the runs that it has. Equilibria, which are not stored, are computed, until `cancel` is set.
    ///
    /// # Errors
    /// It is no sweep, was changed, or this version refuses it, in words.
    pub fn read(dir: &Path, cancel: &AtomicBool) -> Result<Self, String> {
        let (folder, stored): (SweepFolder, StoredSweep) =
            SweepFolder::open_part(dir).map_err(|error| error.to_string())?;
        let plan = SweepPlan::of_stored(stored).map_err(|error| error.to_string())?;
        let sweep = &plan.sweep;
        let found = match &sweep.results {
            SweepResults::AtRest(_) => {
                let found = sweep.compute_asked(None, &plan.question, cancel, &|_| {});
                let (outcomes, _) = found.map_err(|error| error.to_string())?;
                SnapshotOutcomes::of_outcomes(outcomes)
            }
            SweepResults::Line(ids) | SweepResults::InTime(ids) => {
                let none = vec![None; sweep.variation.points.len()];
                SnapshotOutcomes::Runs(sweep.renewed(&folder, &none)?, ids.clone())
            }
        };
        Ok(Self {
            dir: folder.dir().to_owned(),
            plan: Arc::new(plan),
            found,
        })
    }

    /// The sweep as a program has just computed it.
    #[must_use]
    pub fn computed(dir: &Path, plan: Arc<SweepPlan>, outcomes: SweepOutcomes) -> Self {
        Self {
            dir: dir.to_owned(),
            plan,
            found: SnapshotOutcomes::of_outcomes(outcomes),
        }
    }

    /// The sweep as it is now: runs that were done are not read again.
    ///
    /// # Errors
    /// The runs cannot be listed, in words.
    pub fn newer(&self) -> Result<Self, String> {
        let SnapshotOutcomes::Runs(known, ids) = &self.found else {
            return Ok(self.clone());
        };
        let folder = SweepFolder::open_part(&self.dir).map_err(|error| error.to_string())?;
        let found = self.plan.sweep.renewed(&folder.0, known)?;
        Ok(Self {
            found: SnapshotOutcomes::Runs(found, ids.clone()),
            ..self.clone()
        })
    }

    /// Load cases that have results.
    #[must_use]
    pub fn done(&self) -> usize {
        match &self.found {
            SnapshotOutcomes::Runs(runs, _) => runs.iter().filter(|run| is_done(run)).count(),
            SnapshotOutcomes::AtRest(all, _) => {
                let done = |found: &&Option<SystemOutcome>| matches!(found, Some(Ok(_)));
                all.iter().filter(done).count()
            }
        }
    }

    /// Load cases in all.
    #[must_use]
    pub fn load_cases(&self) -> usize {
        self.plan.sweep.variation.points.len()
    }

    /// What the load cases say together; of equilibria only where there are checks. Reads the records of all runs.
    #[must_use]
    pub fn answers(&self) -> Option<SeaResults> {
        let SweepPlan { sweep, question } = &*self.plan;
        match &self.found {
            SnapshotOutcomes::AtRest(outcomes, _) => {
                let names = question.rest_names();
                let asked = !question.checks.is_empty();
                asked.then(|| {
                    SeaResults::at_rest(&sweep.variation, outcomes, (names.as_slice(), question))
                })
            }
            SnapshotOutcomes::Runs(runs, _) => {
                let stored = runs
                    .iter()
                    .map(|run| run.as_ref().and_then(|run| StoredLoadCase::of_outcome(run)));
                let stored: Vec<Option<StoredLoadCase>> = stored.collect();
                Some(SeaResults::of_runs(&sweep.variation, &stored, question))
            }
        }
    }
}

impl SnapshotOutcomes {
    fn of_outcomes(outcomes: SweepOutcomes) -> Self {
        match outcomes {
            SweepOutcomes::Runs(runs, ids) => {
                let shared = runs.into_iter().map(|run| run.map(Arc::new));
                Self::Runs(shared.collect(), ids)
            }
            SweepOutcomes::AtRest(all, names) => Self::AtRest(Arc::new(all), names),
        }
    }
}

impl Sweep {
    /// The runs as they are stored now; those known to be done are kept.
    fn renewed(
        &self,
        folder: &SweepFolder,
        known: &[Option<Arc<PointOutcome>>],
    ) -> Result<Vec<Option<Arc<PointOutcome>>>, String> {
        let taken = folder.places_taken(known.len());
        let taken = taken.map_err(|error| error.to_string())?;
        let missing = taken.iter().filter(|taken| !**taken).count();
        let ask = folder.has_ended() && missing <= MOST_ASKED;
        let found = known.par_iter().zip(taken).enumerate();
        let found = found.map(|(index, (known, taken))| match (known, taken) {
            (Some(run), true) if is_done(known) => Some(Arc::clone(run)),
            (_, false) if ask => self.refusal(index).map(|why| Arc::new(Err(why))),
            (_, false) => None,
            (_, true) => {
                let overrides = self.overrides(&self.variation.points[index].settings);
                let run = folder.kept(index, &overrides).transpose();
                run.map(Arc::new)
            }
        });
        let mut found: Vec<Option<Arc<PointOutcome>>> = found.collect();
        for dir in folder.finer_rounds() {
            self.overlay(&dir, &mut found)?;
        }
        Ok(found)
    }

    /// Puts the runs of a round of finer ones in the place of those that they are finer than.
    fn overlay(&self, dir: &Path, found: &mut [Option<Arc<PointOutcome>>]) -> Result<(), String> {
        let (folder, stored) = SweepFolder::open_part(dir).map_err(|error| error.to_string())?;
        let round = SweepPlan::of_stored(stored).map_err(|error| error.to_string())?;
        let none = vec![None; round.sweep.variation.points.len()];
        let runs = round.sweep.renewed(&folder, &none)?;
        for (point, run) in round.sweep.variation.points.iter().zip(runs) {
            let mut own = self.variation.points.iter();
            let place = own.position(|own| own.settings == point.settings);
            if let Some(index) = place.filter(|_| is_done(&run)) {
                found[index] = run;
            }
        }
        Ok(())
    }
}

fn is_done(run: &Option<Arc<PointOutcome>>) -> bool {
    let done = |run: &Arc<PointOutcome>| {
        let run = run.as_ref().as_ref();
        run.is_ok_and(|run| run.info.state == RunState::Done)
    };
    run.as_ref().is_some_and(done)
}
