//! What the divided lines of a search cost, and when it is given up.

use super::{Search, SystemError};
use crate::system::balance::{Balance, UnsolvedLine};

/// Newton iterations of a divided line, by its segments, that a search may take: seconds. Without an equilibrium near by, a line takes
/// thousands of iterations for every place that its ends are tried at.
const MOST_WORK: u64 = 15_000_000;

impl Search<'_> {
    /// The line that took more work than the search is given, if one has.
    pub(super) fn too_much_work(&self) -> Option<SystemError> {
        let work = self.work.borrow();
        let line = work.iter().position(|work| *work > MOST_WORK)?;
        Some(SystemError::TooMuchWork {
            line,
            work: work[line],
            steps: self.steps,
        })
    }

    /// Counts the work of the divided lines of an evaluation.
    pub(super) fn count_work(&self, evaluated: &Result<Balance, UnsolvedLine>) {
        let segments = |line: usize| {
            let divided = self.network.lines[line].discretised.as_ref();
            divided.map_or(0, |divided| divided.segments() as u64)
        };
        let mut work = self.work.borrow_mut();
        match evaluated {
            Ok(balance) => {
                for (index, line) in balance.lines.iter().enumerate() {
                    let divided = line.discretised.as_ref();
                    let iterations = divided.map_or(0, |divided| divided.found.iterations);
                    work[index] += iterations * segments(index);
                }
            }
            Err(UnsolvedLine {
                line, iterations, ..
            }) => work[*line] += iterations * segments(*line),
        }
    }
}
