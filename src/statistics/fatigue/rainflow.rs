//! Rainflow cycles by the three-point rule: ASTM E1049-85 (2017), 5.4.4, with the residue as half cycles.

use super::turning_points::{Reversal, SeriesError, TurningPoints, alternate, places};
use serde::{Deserialize, Serialize};

/// A cycle, or half of one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// Difference of its two turning points, not negative, in the unit of the series.
    pub range: f64,
    /// Their mean.
    pub mean: f64,
    /// 1 for a closed cycle, 0.5 for a half cycle.
    pub count: f64,
    /// Time of its first turning point, s.
    pub start: f64,
    /// Time of its second, s.
    pub end: f64,
}

impl Cycle {
    /// Between two turning points.
    #[must_use]
    pub fn between(from: Reversal, to: Reversal, count: f64) -> Self {
        Self {
            range: (to.value - from.value).abs(),
            mean: 0.5 * (from.value + to.value),
            count,
            start: from.time,
            end: to.time,
        }
    }
}

/// The difference of two turning points.
pub(crate) fn range(a: Reversal, b: Reversal) -> f64 {
    (a.value - b.value).abs()
}

/// Room for turning points that wait for their cycle to close, so that usual series need no more.
const ROOM: usize = 64;

/// Counts the cycles of a series that comes value by value.
///
/// It keeps only the turning points whose cycles are still open; their ranges fall strictly, so that they are few.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ThreePointCounter {
    turning: TurningPoints,
    open: Vec<Reversal>,
}

impl Default for ThreePointCounter {
    fn default() -> Self {
        Self::new()
    }
}

impl ThreePointCounter {
    /// Before any value.
    #[must_use]
    pub fn new() -> Self {
        Self {
            turning: TurningPoints::new(),
            open: Vec::with_capacity(ROOM),
        }
    }

    /// Takes the next value at its time in s; every cycle that this completes goes to `found`.
    ///
    /// # Errors
    /// Those of [`TurningPoints::push`]; the series may go on as if the value had not come.
    pub fn push(
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
    pub fn is_sound(&self) -> bool {
        self.turning.is_sound() && alternate(&self.open)
    }

    /// Ends the series: cycles that its end completes, then the open ones as half cycles, in their order in time.
    pub fn finish(mut self, mut found: impl FnMut(Cycle)) {
        if let Some(end) = self.turning.end() {
            turn(&mut self.open, end, &mut found);
        }
        half_cycles(&self.open).for_each(found);
    }

    /// Number of turning points that are kept.
    #[must_use]
    pub fn open(&self) -> usize {
        self.open.len()
    }
}

/// Takes a turning point: while the last range X is not less than the one before, Y, counts Y; as half a cycle where it
/// holds the start.
fn turn(open: &mut Vec<Reversal>, reversal: Reversal, found: &mut impl FnMut(Cycle)) {
    open.push(reversal);
    while let [before @ .., first, second, last] = open.as_slice() {
        let (x, y) = (range(*second, *last), range(*first, *second));
        if x < y {
            break;
        }
        let holds_start = before.is_empty();
        let count = if holds_start { 0.5 } else { 1.0 };
        found(Cycle::between(*first, *second, count));
        if holds_start {
            open.remove(0);
        } else {
            let last = *last;
            open.truncate(open.len() - 3);
            open.push(last);
        }
    }
}

/// Neighbouring turning points as half cycles.
pub(crate) fn half_cycles(reversals: &[Reversal]) -> impl Iterator<Item = Cycle> {
    let pairs = reversals.iter().zip(reversals.iter().skip(1));
    pairs.map(|(&from, &to)| Cycle::between(from, to, 0.5))
}

/// Cycles of values at equal steps by the three-point rule; the place in the series stands for the time.
///
/// Closed cycles and half cycles come in the order in which they complete. No value, one, or equal ones have no cycles.
///
/// # Errors
/// A value that is not finite.
pub fn three_point(values: &[f64]) -> Result<Vec<Cycle>, SeriesError> {
    let mut counter = ThreePointCounter::new();
    let mut cycles = Vec::new();
    for (time, value) in places(values) {
        counter.push(time, value, |cycle| cycles.push(cycle))?;
    }
    counter.finish(|cycle| cycles.push(cycle));
    Ok(cycles)
}

#[cfg(test)]
mod tests;
