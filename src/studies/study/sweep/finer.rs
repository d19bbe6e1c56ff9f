//! Load cases whose verdict lies within the numerical error of their runs, computed again: on more segments, in shorter steps.
//!
//! Each round divides segments and steps in two, for the seas that are still open: what is computed follows from the results of the round
//! before, so that it depends neither on the number of threads nor on resumes. The runs of a round are a sweep of their own, beside the folder.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::{Sweep, SweepError, SweepFolder, SweepOutcomes, SweepProgress, SweepResults};
use crate::case::{Case, kind};
use crate::checks::utilisation::UtilisationVerdict;
use crate::run::accuracy::searchable::Searchable;
use crate::study::points::{BaseCase, reasons};
use crate::study::seas::{SeaQuestion, SeaResults};
use crate::study::studied;
use crate::study::vary::Variation;
use crate::system::SystemFile;
use crate::system::at_rest::SystemAtRest;
use crate::system::motion::system_in_time::SystemInTime;
use crate::system::solved::solve;

/// Load cases that were computed again.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FinerRound {
    /// How many times as many segments, and steps in the same time.
    pub finer: usize,
    /// The load cases, by their places in the list.
    pub load_cases: Vec<usize>,
}

impl SeaResults {
    /// The load cases of seas whose verdict by a check is open within the numerical error, whatever the sample. Where another place of a
    /// sea fails that check its verdict stands.
    #[must_use]
    pub fn open_by_error(&self) -> Vec<usize> {
        let mut open = BTreeSet::new();
        for check in &self.checks {
            let fails = |sea: usize| {
                let mut rows = check.rows.iter();
                rows.any(|row| {
                    row.sea == Some(sea) && row.used.verdict() == UtilisationVerdict::Fails
                })
            };
            let seas = check.rows.iter().filter(|row| row.used.is_open_by_error());
            let seas = seas.filter_map(|row| row.sea).filter(|sea| !fails(*sea));
            open.extend(seas.flat_map(|sea| self.seas[sea].load_cases.iter().copied()));
        }
        open.into_iter().collect()
    }
}

impl Sweep {
    /// Computes load cases as the question asks: seeds until the checks are settled, and finer runs where a verdict hangs on the
    /// numerical error. Says what was computed again.
    ///
    /// # Errors
    /// A round cannot be stored, or its keys cannot be set.
    pub fn compute_asked(
        &self,
        folder: Option<&SweepFolder>,
        question: &SeaQuestion,
        cancel: &AtomicBool,
        told: &(dyn Fn(SweepProgress) + Sync),
    ) -> Result<(SweepOutcomes, Vec<FinerRound>), SweepError> {
        let outcomes = match folder.filter(|_| question.statistics.until_settled) {
            Some(folder) => self.compute_until_settled(folder, question, cancel, told),
            None => self.compute(folder, cancel, told),
        };
        self.compute_finer(folder, question, outcomes, (cancel, told))
    }

    fn compute_finer(
        &self,
        folder: Option<&SweepFolder>,
        question: &SeaQuestion,
        mut outcomes: SweepOutcomes,
        (cancel, told): (&AtomicBool, &(dyn Fn(SweepProgress) + Sync)),
    ) -> Result<(SweepOutcomes, Vec<FinerRound>), SweepError> {
        // Equilibria are not stored.
        let folder = folder.filter(|_| !matches!(self.results, SweepResults::AtRest(_)));
        let mut rounds = Vec::new();
        for round in 1..=question.statistics.finer_runs {
            let answers = self.answers(&outcomes, question);
            let load_cases = answers.map_or_else(Vec::new, |found| found.open_by_error());
            if load_cases.is_empty() || cancel.load(Ordering::Relaxed) {
                break;
            }
            let finer = 1 << round;
            let Some(sweep) = self.finer(&load_cases, finer)? else {
                break;
            };
            let beside = folder
                .map(|folder| folder.beside(&name(round), &sweep.variation, sweep.results.names()));
            let beside = beside.transpose()?;
            let found = sweep.compute(beside.as_ref(), cancel, told);
            outcomes.replace(&load_cases, found);
            rounds.push(FinerRound { finer, load_cases });
        }
        Ok((outcomes, rounds))
    }

    /// The same of some load cases, so many times as fine; nothing where no mesh and no step is to be finer.
    fn finer(&self, load_cases: &[usize], finer: usize) -> Result<Option<Self>, SweepError> {
        let base = &self.variation.base;
        let keys = self.finer_keys(finer).map_err(SweepError::Finer)?;
        if keys.is_empty() {
            return Ok(None);
        }
        let mut text = base.text.clone();
        for (key, value) in &keys {
            let set = match &self.results {
                SweepResults::Line(_) => kind::put::<Case>(&text, key, value),
                _ => kind::put::<SystemFile>(&text, key, value),
            };
            text = set.map_err(|faults| SweepError::Finer(reasons(&faults)))?;
        }
        let set = keys.iter().map(|(key, value)| format!("{key}={value}"));
        let of = &self.variation;
        let points = load_cases.iter().map(|index| of.points[*index].clone());
        let variation = Variation {
            base: BaseCase {
                text,
                overrides: base.overrides.iter().cloned().chain(set).collect(),
                ..base.clone()
            },
            keys: of.keys.clone(),
            points: points.collect(),
            probability: None,
            is_grid: false,
        };
        Ok(Some(Self {
            variation,
            ..self.clone()
        }))
    }

    /// The keys that make the scene so many times as fine, with their values.
    fn finer_keys(&self, finer: usize) -> Result<Vec<(String, String)>, String> {
        let base = &self.variation.base;
        match &self.results {
            SweepResults::Line(_) => base.request(&[])?.case.finer_keys(finer),
            SweepResults::InTime(_) => {
                let solved = solve(studied::read(base, &[])?.content);
                let solved = solved.map_err(|why| why.problem)?;
                let solver = solved.file.as_run().cloned().unwrap_or_default();
                SystemInTime::new(Arc::new(solved), solver).finer_keys(finer)
            }
            SweepResults::AtRest(_) => {
                SystemAtRest::new(studied::read(base, &[])?.content).finer_keys(finer)
            }
        }
    }
}

/// What the folder of a round is called behind the name of its sweep.
fn name(round: usize) -> String {
    format!("{FINER}{round}")
}

const FINER: &str = "finer-";

/// Whether a folder is of a round of another sweep, beside it.
pub(super) fn is_round(dir: &Path) -> bool {
    let name = dir.file_name().and_then(|name| name.to_str());
    let parts = name.and_then(|name| name.rsplit_once(&format!("-{FINER}")));
    parts.is_some_and(|(of, round)| {
        round.parse::<usize>().is_ok() && SweepFolder::is_one(&dir.with_file_name(of))
    })
}

impl SweepFolder {
    /// The folders of the rounds that are stored, in their order.
    pub(super) fn finer_rounds(&self) -> impl Iterator<Item = PathBuf> {
        let dirs = (1..).map(|round| self.dir_beside(&name(round)));
        dirs.take_while(|dir| Self::is_one(dir))
    }
}

impl SweepOutcomes {
    /// Puts what became of these load cases in the place of what did before; what did not begin or failed leaves it.
    fn replace(&mut self, load_cases: &[usize], found: Self) {
        match (self, found) {
            (Self::Runs(all, _), Self::Runs(found, _)) => put(all, load_cases, found),
            (Self::AtRest(all, _), Self::AtRest(found, _)) => put(all, load_cases, found),
            _ => {}
        }
    }
}

fn put<T>(
    all: &mut [Option<Result<T, String>>],
    load_cases: &[usize],
    found: Vec<Option<Result<T, String>>>,
) {
    for (index, outcome) in load_cases.iter().zip(found) {
        if let Some(Ok(_)) = &outcome {
            all[*index] = outcome;
        }
    }
}
