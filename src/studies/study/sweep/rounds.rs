//! A sweep that draws the seeds of a sea only until its checks are settled.
//!
//! The seeds stand in the table of load cases, as many as may be needed at most. They are computed in rounds, of the first 5, 10, 20, ...
//! of every sea that is not settled, so that what is computed does not depend on the number of threads nor on resumes.

use std::sync::atomic::{AtomicBool, Ordering};

use super::folder::SweepFolder;
use super::{Sweep, SweepOutcomes, SweepProgress, SweepResults};
use crate::study::points::PointOutcome;
use crate::study::seas::{Look, SeaQuestion, StoredLoadCase, seas};

impl Sweep {
    /// Computes load cases as [`Self::compute`] does, of each sea only as many as its checks need to be settled. Load cases that were not
    /// needed have no outcome.
    pub fn compute_until_settled(
        &self,
        folder: &SweepFolder,
        question: &SeaQuestion,
        cancel: &AtomicBool,
        told: &(dyn Fn(SweepProgress) + Sync),
    ) -> SweepOutcomes {
        let (SweepResults::Line(ids) | SweepResults::InTime(ids)) = &self.results else {
            return self.compute(Some(folder), cancel, told);
        };
        let count = self.variation.points.len();
        let mut outcomes: Vec<Option<PointOutcome>> = vec![None; count];
        let mut runs: Vec<Option<StoredLoadCase>> = vec![None; count];
        let mut open: Vec<_> = seas(&self.variation, &question.scene)
            .into_iter()
            .enumerate()
            .collect();
        let (mut look, mut before) = (Look::FIRST, 0);
        loop {
            let of_round = open
                .iter()
                .flat_map(|(_, sea)| sea.load_cases.iter().take(look.runs));
            let wanted: Vec<usize> = of_round
                .copied()
                .filter(|index| outcomes[*index].is_none())
                .collect();
            let told = |progress: SweepProgress| {
                told(SweepProgress {
                    done: before + progress.done,
                    stored: before + progress.stored,
                    of: before + progress.of,
                });
            };
            for (index, outcome) in self.compute_some(Some(folder), &wanted, cancel, &told) {
                runs[index] = outcome.as_ref().and_then(StoredLoadCase::of_outcome);
                outcomes[index] = outcome;
            }
            before += wanted.len();
            if cancel.load(Ordering::Relaxed) {
                break;
            }
            open.retain(|(number, sea)| {
                sea.load_cases.len() > look.runs && !question.is_settled(*number, sea, &runs)
            });
            if open.is_empty() {
                break;
            }
            look = look.next();
        }
        SweepOutcomes::Runs(outcomes, ids.clone())
    }
}
