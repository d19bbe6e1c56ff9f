//! Rainflow cycles by the four-point rule: ISO 12110-2; Amzallag, Gerey, Robert and Bahuaud, Int. J. Fatigue 16 (1994) 287.
//!
//! Its closed cycles do not depend on how what remains, the residue, is treated; that is chosen afterwards.

use super::rainflow::{Cycle, half_cycles, range};
use super::turning_points::{Reversal, SeriesError, TurningPoints, alternate, places};
use serde::{Deserialize, Serialize};

/// Room for the residue, so that usual series need no more.
const ROOM: usize = 128;

/// Counts the closed cycles of a series that comes value by value; it keeps only the residue so far, whose ranges rise and
/// then fall.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FourPointCounter {
    turning: TurningPoints,
    open: Vec<Reversal>,
}

impl Default for FourPointCounter {
    fn default() -> Self {
        Self::new()
    }
}

impl FourPointCounter {
    /// Before any value.
    #[must_use]
    pub(super) fn new() -> Self {
        Self {
            turning: TurningPoints::new(),
            open: Vec::with_capacity(ROOM),
        }
    }

    /// Takes the next value at its time in s; every cycle that this closes goes to `found`.
    ///
    /// # Errors
    /// Those of [`TurningPoints::push`]; the series may go on as if the value had not come.
    pub(super) fn push(
        &mut self,
        time: f64,
        value: f64,
        mut found: impl FnMut(Cycle),
    ) -> Result<(), SeriesError> {
        if let Some(reversal) = self.turning.push(time, value)? {
            turn(&mut self.open, reversal, &mut found);
        }
        Ok(())
    }

    /// Whether a state read from a file could be that of a series.
    #[must_use]
    pub(super) fn is_sound(&self) -> bool {
        self.turning.is_sound() && alternate(&self.open)
    }

    /// Ends the series; what its end closes goes to `found`.
    pub(super) fn finish(mut self, mut found: impl FnMut(Cycle)) -> Residue {
        if let Some(end) = self.turning.end() {
            turn(&mut self.open, end, &mut found);
        }
        Residue(self.open)
    }
}

/// Takes a turning point: of the last four, the middle two are a cycle where their range exceeds neither neighbour's.
fn turn(open: &mut Vec<Reversal>, reversal: Reversal, found: &mut impl FnMut(Cycle)) {
    open.push(reversal);
    while let [.., first, second, third, last] = open.as_slice() {
        let inner = range(*second, *third);
        if inner > range(*first, *second) || inner > range(*third, *last) {
            break;
        }
        found(Cycle::between(*second, *third, 1.0));
        let last = *last;
        open.truncate(open.len() - 3);
        open.push(last);
    }
}

/// The turning points that belong to no closed cycle.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Residue(Vec<Reversal>);

impl Residue {
    /// Its turning points, in their order in time.
    #[must_use]
    pub(super) fn reversals(&self) -> &[Reversal] {
        &self.0
    }

    /// Its ranges as half cycles: with these the count is that of ASTM E1049-85, 5.4.4.
    pub(super) fn half_cycles(&self) -> impl Iterator<Item = Cycle> {
        half_cycles(&self.0)
    }

    /// The cycles that close when the series repeats: the residue after itself, counted again. A turning point at the joint
    /// that is none of the joined series is left out, so that the range from least to greatest is always among them.
    ///
    /// A start or end time may lie in the first or the second repetition; both are given in the time of the series.
    #[must_use]
    pub(super) fn closed_by_repeating(&self) -> Vec<Cycle> {
        let mut counter = FourPointCounter::new();
        let mut cycles = Vec::new();
        let twice = self.0.iter().chain(&self.0);
        for (place, reversal) in twice.enumerate() {
            // The counter sees places as times; they rise also over the joint.
            let pushed = counter.push(place as f64, reversal.value, |c| cycles.push(c));
            debug_assert!(pushed.is_ok(), "a residue has only finite values");
        }
        let _ = counter.finish(|cycle| cycles.push(cycle));
        for cycle in &mut cycles {
            cycle.start = self.time_at(cycle.start);
            cycle.end = self.time_at(cycle.end);
        }
        cycles
    }

    /// The time of a place in the residue twice over.
    fn time_at(&self, place: f64) -> f64 {
        let place = place as usize % self.0.len().max(1);
        self.0.get(place).map_or(0.0, |reversal| reversal.time)
    }
}

/// Closed cycles and residue of a series.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FourPointCount {
    /// Closed cycles in the order in which they close, each counted once.
    pub(super) cycles: Vec<Cycle>,
    /// What remains.
    pub(super) residue: Residue,
}

impl FourPointCount {
    /// All cycles of the series repeated for ever, for one repetition.
    #[must_use]
    pub(super) fn repeating(mut self) -> Vec<Cycle> {
        self.cycles.extend(self.residue.closed_by_repeating());
        self.cycles
    }

    /// All cycles, the residue as half cycles.
    #[must_use]
    pub(super) fn with_half_cycles(mut self) -> Vec<Cycle> {
        self.cycles.extend(self.residue.half_cycles());
        self.cycles
    }
}

/// Cycles of values at equal steps by the four-point rule; the place in the series stands for the time.
///
/// # Errors
/// A value that is not finite.
pub(super) fn four_point(values: &[f64]) -> Result<FourPointCount, SeriesError> {
    let mut counter = FourPointCounter::new();
    let mut cycles = Vec::new();
    for (time, value) in places(values) {
        counter.push(time, value, |cycle| cycles.push(cycle))?;
    }
    let residue = counter.finish(|cycle| cycles.push(cycle));
    Ok(FourPointCount { cycles, residue })
}

#[cfg(test)]
mod tests;
