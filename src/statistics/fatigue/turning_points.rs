//! Turning points (reversals) of a series: its start, its local extremes, its end.

use serde::{Deserialize, Serialize};

/// Greatest magnitude of a value, so that ranges, sums and doubled bins stay finite.
pub const GREATEST: f64 = 1e300;

/// Why a series cannot be counted.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SeriesError {
    /// A value is NaN, infinite or beyond [`GREATEST`].
    #[error(
        "value {index} of the series is {value}; values are finite and at most 1e300 in magnitude"
    )]
    Value {
        /// Place in the series, from zero.
        index: usize,
        /// What stands there.
        value: f64,
    },
    /// A time is not finite or does not come after the one before.
    #[error(
        "time {index} of the series is {time} s; times are finite and rise from each value to the next"
    )]
    Time {
        /// Place in the series, from zero.
        index: usize,
        /// What stands there, s.
        time: f64,
    },
    /// Times and values differ in number.
    #[error("the series has {times} times and {values} values; it needs one time for each value")]
    Lengths {
        /// Number of times.
        times: usize,
        /// Number of values.
        values: usize,
    },
    /// Classes without width, or none.
    #[error(
        "{count} classes from {low} to {high}: there is one class at least, and the upper bound exceeds the lower"
    )]
    Classes {
        /// Lower bound.
        low: f64,
        /// Upper bound.
        high: f64,
        /// Number of intervals.
        count: usize,
    },
}

/// A turning point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Reversal {
    /// When the value is first reached, s; on a plateau that is its first value.
    pub time: f64,
    /// Value, in the unit of the series.
    pub value: f64,
}

impl Reversal {
    pub(crate) fn is_sound(&self) -> bool {
        self.time.is_finite() && self.value.is_finite() && self.value.abs() <= GREATEST
    }
}

/// Whether turning points wait in an order that a series could leave: times and directions alternate.
pub(crate) fn alternate(reversals: &[Reversal]) -> bool {
    let rises = |a: &Reversal, b: &Reversal| b.value > a.value;
    let steps = reversals.windows(2).all(|w| match w {
        [a, b] => a.time < b.time && a.value != b.value,
        _ => true,
    });
    let turns = reversals.windows(3).all(|w| match w {
        [a, b, c] => rises(a, b) != rises(b, c),
        _ => true,
    });
    reversals.iter().all(Reversal::is_sound) && steps && turns
}

/// Finds the turning points of a series that comes value by value, in constant memory.
///
/// The first value is a turning point, and so is the last unless all are equal. Equal neighbours count as one; a plateau is
/// a turning point where the series leaves it to the side from which it came.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TurningPoints {
    /// The value that may turn out to be a turning point.
    candidate: Option<Reversal>,
    /// Whether the series rises to the candidate; `None` as long as all values are equal.
    rises: Option<bool>,
    last_time: Option<f64>,
    seen: usize,
}

impl TurningPoints {
    /// Before any value.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes the next value at its time in s; returns a turning point if this value shows one.
    ///
    /// # Errors
    /// A value or time that is not finite, or a time that does not rise. The series may go on as if it had not come.
    pub fn push(&mut self, time: f64, value: f64) -> Result<Option<Reversal>, SeriesError> {
        self.check(time, value)?;
        self.last_time = Some(time);
        self.seen += 1;
        let next = Reversal { time, value };
        let Some(candidate) = self.candidate else {
            self.candidate = Some(next);
            return Ok(Some(next));
        };
        if value == candidate.value {
            return Ok(None);
        }
        let rises = value > candidate.value;
        let turned = self.rises.is_some_and(|before| before != rises);
        self.rises = Some(rises);
        self.candidate = Some(next);
        Ok(turned.then_some(candidate))
    }

    fn check(&self, time: f64, value: f64) -> Result<(), SeriesError> {
        let index = self.seen;
        if !(value.is_finite() && value.abs() <= GREATEST) {
            return Err(SeriesError::Value { index, value });
        }
        if !time.is_finite() || self.last_time.is_some_and(|last| time <= last) {
            return Err(SeriesError::Time { index, time });
        }
        Ok(())
    }

    /// The end of the series so far as a turning point: `None` of no value and where all are equal.
    #[must_use]
    pub fn end(&self) -> Option<Reversal> {
        self.candidate.filter(|_| self.rises.is_some())
    }

    /// Whether a state read from a file could be that of a series.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        match (self.candidate, self.last_time) {
            (None, None) => self.seen == 0 && self.rises.is_none(),
            (Some(candidate), Some(last)) => {
                let is_turned = self.rises.is_some();
                candidate.is_sound()
                    && last.is_finite()
                    && candidate.time <= last
                    && self.seen > usize::from(is_turned)
            }
            _ => false,
        }
    }

    /// Number of values taken.
    #[must_use]
    pub fn seen(&self) -> usize {
        self.seen
    }
}

/// Turning points of a series; `times` in s.
///
/// # Errors
/// Lengths that differ; a value or time that is not finite; times that do not rise.
pub fn turning_points(times: &[f64], values: &[f64]) -> Result<Vec<Reversal>, SeriesError> {
    if times.len() != values.len() {
        let (times, values) = (times.len(), values.len());
        return Err(SeriesError::Lengths { times, values });
    }
    collect(times.iter().copied().zip(values.iter().copied()))
}

/// Turning points of values at equal steps; the place in the series, from zero, stands for the time.
///
/// # Errors
/// A value that is not finite.
pub fn turning_points_of(values: &[f64]) -> Result<Vec<Reversal>, SeriesError> {
    collect(places(values))
}

/// Values with their places as times.
pub(crate) fn places(values: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    values.iter().enumerate().map(|(i, &v)| (i as f64, v))
}

fn collect(series: impl Iterator<Item = (f64, f64)>) -> Result<Vec<Reversal>, SeriesError> {
    let mut finder = TurningPoints::new();
    let mut found = Vec::new();
    for (time, value) in series {
        found.extend(finder.push(time, value)?);
    }
    found.extend(finder.end());
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(series: &[f64]) -> Vec<f64> {
        let found = turning_points_of(series).unwrap();
        found.iter().map(|r| r.value).collect()
    }

    #[test]
    fn start_extremes_and_end() {
        assert_eq!(
            values(&[0.0, 1.0, 3.0, 2.0, -1.0, 4.0]),
            [0.0, 3.0, -1.0, 4.0]
        );
        assert_eq!(values(&[2.0, 1.0]), [2.0, 1.0]);
        assert_eq!(values(&[7.0]), [7.0]);
        assert!(values(&[]).is_empty());
        assert_eq!(values(&[5.0; 4]), [5.0]);
    }

    #[test]
    fn plateaus_count_once_at_their_first_value() {
        let series = [1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 0.0, 0.0];
        assert_eq!(values(&series), [1.0, 3.0, 0.0]);
        let found = turning_points_of(&series).unwrap();
        let times: Vec<f64> = found.iter().map(|r| r.time).collect();
        assert_eq!(times, [0.0, 4.0, 6.0]);
    }

    #[test]
    fn bad_series_are_refused() {
        let value = turning_points_of(&[0.0, f64::NAN]).unwrap_err();
        assert!(matches!(value, SeriesError::Value { index: 1, .. }));
        assert!(turning_points_of(&[1e301]).is_err());
        let time = turning_points(&[0.0, 0.0], &[1.0, 2.0]).unwrap_err();
        assert_eq!(
            time,
            SeriesError::Time {
                index: 1,
                time: 0.0
            }
        );
        assert!(turning_points(&[0.0], &[1.0, 2.0]).is_err());
        assert!(turning_points(&[f64::INFINITY], &[1.0]).is_err());
    }

    #[test]
    fn a_refused_value_leaves_the_series_as_it_was() {
        let mut finder = TurningPoints::new();
        finder.push(0.0, 1.0).unwrap();
        let before = finder.clone();
        assert!(finder.push(1.0, f64::INFINITY).is_err() && finder.push(0.0, 2.0).is_err());
        assert_eq!(finder, before);
    }
}
