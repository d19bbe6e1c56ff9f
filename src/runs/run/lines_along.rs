//! Fatigue along the lines of a run.

use super::along::{AlongCount, FatigueSpot};
use super::observer::LineStep;
use crate::case::Case;
use crate::fatigue::spot::SpotCounter;
use crate::scene::Scene;

/// Counts cycles along lines, each by its number.
#[derive(Debug, Clone, Default)]
pub struct LinesAlong {
    lines: Vec<(usize, AlongCount)>,
}

impl LinesAlong {
    /// Of lines of these numbers.
    #[must_use]
    pub const fn new(lines: Vec<(usize, AlongCount)>) -> Self {
        Self { lines }
    }

    /// Of a case of a line; nothing where no check counts along it, or the line is at rest.
    #[must_use]
    pub fn of_case(case: &Case, scene: &Scene) -> Self {
        let count = AlongCount::of_case(case, scene);
        Self::new(count.into_iter().map(|count| (0, count)).collect())
    }

    /// Takes in an accepted step of a line; does not allocate.
    pub(super) fn step(&mut self, at: &LineStep<'_>) {
        for (number, count) in &mut self.lines {
            if *number == at.number {
                count.step(at.scene, at.time, at.state);
            }
        }
    }

    /// What is counted so far, line after line.
    pub(super) fn counters(&self) -> impl Iterator<Item = &SpotCounter> {
        self.lines.iter().flat_map(|(_, count)| count.counters())
    }

    /// Continues from what was counted so far, which is of as many places.
    pub(super) fn restore(&mut self, stored: &[SpotCounter]) {
        let mut left = stored;
        for (_, count) in &mut self.lines {
            let (own, rest) = left.split_at(count.counters().len());
            count.restore(own);
            left = rest;
        }
    }

    /// The damage at every place, and what could not be counted, in words; `arc` gives that of the nodes of a line \[m\].
    pub(super) fn finish<'a>(
        self,
        arc: impl Fn(usize) -> &'a [f64],
    ) -> (Vec<FatigueSpot>, Vec<String>) {
        let (mut found, mut missing) = (Vec::new(), Vec::new());
        for (number, count) in self.lines {
            let (spots, why) = count.finish(arc(number));
            found.extend(spots);
            missing.extend(why);
        }
        missing.dedup();
        (found, missing)
    }
}
