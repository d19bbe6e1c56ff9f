//! Cycles counted by range and mean in memory that is fixed beforehand.
//!
//! Where a cycle lies outside, bins are merged in pairs until it does not, so that no cycle is lost and no bounds need be
//! known before a run; the price is width.

use super::rainflow::Cycle;
use super::turning_points::GREATEST;
use serde::{Deserialize, Serialize};

/// Why a histogram cannot be made or filled.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum HistogramError {
    /// A number of bins that cannot be merged in pairs.
    #[error(
        "a histogram of {range_bins} by {mean_bins} bins: both numbers are even and from 2 to 4096"
    )]
    Bins {
        /// Bins along the range.
        range_bins: usize,
        /// Bins along the mean.
        mean_bins: usize,
    },
    /// A width that is not positive.
    #[error("the first bins are {width} wide; a width is positive and at most 1e300")]
    Width {
        /// Stated width.
        width: f64,
    },
    /// A cycle that is none.
    #[error(
        "a cycle of range {range}, mean {mean} and count {count}: all are finite, range and count not negative"
    )]
    Cycle {
        /// Its range.
        range: f64,
        /// Its mean.
        mean: f64,
        /// Its count.
        count: f64,
    },
}

/// Which range stands for the cycles of a bin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RangeInBin {
    /// The lower edge: damage from below.
    Lower,
    /// The middle.
    Middle,
    /// The upper edge: damage from above.
    Upper,
}

fn are_bins(bins: usize) -> bool {
    (2..=4096).contains(&bins) && bins.is_multiple_of(2)
}

/// Counts by range, from zero, and mean.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CycleHistogram {
    /// By range, then by mean.
    counts: Vec<f64>,
    range_bins: usize,
    mean_bins: usize,
    range_width: f64,
    mean_width: f64,
    mean_low: f64,
}

impl CycleHistogram {
    /// Empty, with so many bins of range and mean and their first widths, in the unit of the series.
    ///
    /// # Errors
    /// Numbers of bins that are odd, zero or above 4096; widths that are not positive.
    pub fn new(
        (range_bins, range_width): (usize, f64),
        (mean_bins, mean_width): (usize, f64),
    ) -> Result<Self, HistogramError> {
        if !are_bins(range_bins) || !are_bins(mean_bins) {
            return Err(HistogramError::Bins {
                range_bins,
                mean_bins,
            });
        }
        for width in [range_width, mean_width] {
            if !(width > 0.0 && width <= GREATEST) {
                return Err(HistogramError::Width { width });
            }
        }
        Ok(Self {
            counts: vec![0.0; range_bins * mean_bins],
            range_bins,
            mean_bins,
            range_width,
            mean_width,
            mean_low: -0.5 * mean_width * mean_bins as f64,
        })
    }

    /// Adds a cycle.
    ///
    /// # Errors
    /// A cycle with a number that is not finite or beyond 1e300, or a negative range or count.
    pub fn add(&mut self, cycle: &Cycle) -> Result<(), HistogramError> {
        let (range, mean, count) = (cycle.range, cycle.mean, cycle.count);
        let is_good = (0.0..=2.0 * GREATEST).contains(&range)
            && (-GREATEST..=GREATEST).contains(&mean)
            && (0.0..=GREATEST).contains(&count);
        if !is_good {
            return Err(HistogramError::Cycle { range, mean, count });
        }
        while range >= self.range_width * self.range_bins as f64 {
            self.double_range();
        }
        while mean < self.mean_low {
            self.double_mean(true);
        }
        while mean >= self.mean_low + self.mean_width * self.mean_bins as f64 {
            self.double_mean(false);
        }
        let row = ((range / self.range_width) as usize).min(self.range_bins - 1);
        let column = (((mean - self.mean_low) / self.mean_width) as usize).min(self.mean_bins - 1);
        if let Some(bin) = self.counts.get_mut(row * self.mean_bins + column) {
            *bin += count;
        }
        Ok(())
    }

    fn double_range(&mut self) {
        let columns = self.mean_bins;
        self.merge(|row, column| (row / 2) * columns + column);
        self.range_width *= 2.0;
    }

    /// Doubles the width of the means' bins and puts the present ones into the lower or the upper half.
    fn double_mean(&mut self, downwards: bool) {
        let (columns, half) = (self.mean_bins, self.mean_bins / 2);
        let offset = if downwards { half } else { 0 };
        self.merge(|row, column| row * columns + column / 2 + offset);
        if downwards {
            self.mean_low -= self.mean_width * columns as f64;
        }
        self.mean_width *= 2.0;
    }

    fn merge(&mut self, place: impl Fn(usize, usize) -> usize) {
        let before = std::mem::replace(
            &mut self.counts,
            vec![0.0; self.range_bins * self.mean_bins],
        );
        for (index, count) in before.into_iter().enumerate() {
            let to = place(index / self.mean_bins, index % self.mean_bins);
            if let Some(bin) = self.counts.get_mut(to) {
                *bin += count;
            }
        }
    }

    /// Whether a state read from a file could be that of a histogram.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let are_bins = are_bins(self.range_bins) && are_bins(self.mean_bins);
        let widths = [self.range_width, self.mean_width];
        are_bins
            && self.counts.len() == self.range_bins * self.mean_bins
            && self
                .counts
                .iter()
                .all(|count| *count >= 0.0 && count.is_finite())
            && widths.iter().all(|width| *width > 0.0 && width.is_finite())
            && self.mean_low.is_finite()
    }

    /// Present widths of the bins of range and mean.
    #[must_use]
    pub fn widths(&self) -> (f64, f64) {
        (self.range_width, self.mean_width)
    }

    /// Sum of all counts.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.counts.iter().sum()
    }

    /// The bins that are not empty as cycles, with the mean of their middle and no times (zero).
    pub fn cycles(&self, at: RangeInBin) -> impl Iterator<Item = Cycle> + '_ {
        let within = match at {
            RangeInBin::Lower => 0.0,
            RangeInBin::Middle => 0.5,
            RangeInBin::Upper => 1.0,
        };
        let filled = self
            .counts
            .iter()
            .enumerate()
            .filter(|&(_, &count)| count > 0.0);
        filled.map(move |(index, &count)| {
            let (row, column) = (index / self.mean_bins, index % self.mean_bins);
            Cycle {
                range: self.range_width * (row as f64 + within),
                mean: self.mean_low + self.mean_width * (column as f64 + 0.5),
                count,
                start: 0.0,
                end: 0.0,
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fatigue::fixtures::{cycles_of, random_series};
    use crate::fatigue::rainflow::three_point;
    use crate::numerics::random::Random;

    #[test]
    fn bounds_the_moments_of_the_cycles() {
        let mut random = Random::new(11, 0);
        for _ in 0..100 {
            let mut histogram = CycleHistogram::new((64, 0.01), (8, 0.01)).unwrap();
            let cycles = three_point(&random_series(&mut random)).unwrap();
            cycles.iter().for_each(|c| histogram.add(c).unwrap());
            let cubes = |cycles: &mut dyn Iterator<Item = Cycle>| -> f64 {
                cycles.map(|c| c.count * c.range.powi(3)).sum()
            };
            let exact = cubes(&mut cycles.iter().copied());
            assert!(cubes(&mut histogram.cycles(RangeInBin::Lower)) <= exact);
            assert!(cubes(&mut histogram.cycles(RangeInBin::Upper)) >= exact);
            let counts: f64 = cycles.iter().map(|c| c.count).sum();
            assert_eq!(histogram.total(), counts);
            let sum: f64 = cycles.iter().map(|c| c.count * c.mean).sum();
            let binned: f64 = histogram
                .cycles(RangeInBin::Middle)
                .map(|c| c.count * c.mean)
                .sum();
            assert!((sum - binned).abs() <= 0.5 * histogram.widths().1 * counts + 1e-9);
            let width = histogram.widths().0;
            assert!(
                cycles.iter().all(|c| c.range < 64.0 * width),
                "all lie within"
            );
        }
    }

    #[test]
    fn extreme_cycles_find_their_bin() {
        let mut histogram = CycleHistogram::new((2, 1e-300), (2, 1e-300)).unwrap();
        for (range, mean) in [(0.0, 0.0), (2e300, 1e300), (1.0, -1e300)] {
            let cycle = Cycle {
                mean,
                ..cycles_of(range, 1)[0]
            };
            histogram.add(&cycle).unwrap();
        }
        assert_eq!(histogram.total(), 3.0);
        assert!(
            histogram
                .cycles(RangeInBin::Upper)
                .all(|c| c.range.is_finite() && c.mean.is_finite())
        );
    }

    #[test]
    fn a_stored_histogram_is_the_same() {
        let mut histogram = CycleHistogram::new((4, 1.0), (2, 1.0)).unwrap();
        histogram.add(&cycles_of(9.5, 1)[0]).unwrap();
        let text = serde_json::to_string(&histogram).unwrap();
        let read: CycleHistogram = serde_json::from_str(&text).unwrap();
        assert!(read.is_sound() && read == histogram);
        let cut = text.replacen("0.0,", "", 1);
        assert!(
            !serde_json::from_str::<CycleHistogram>(&cut)
                .unwrap()
                .is_sound()
        );
    }

    #[test]
    fn bad_ones_are_refused() {
        assert!(CycleHistogram::new((3, 1.0), (2, 1.0)).is_err());
        assert!(CycleHistogram::new((0, 1.0), (2, 1.0)).is_err());
        assert!(CycleHistogram::new((2, 0.0), (2, 1.0)).is_err());
        assert!(CycleHistogram::new((2, 1.0), (2, f64::NAN)).is_err());
        let mut histogram = CycleHistogram::new((2, 1.0), (2, 1.0)).unwrap();
        assert!(histogram.add(&cycles_of(f64::NAN, 1)[0]).is_err());
        assert!(histogram.add(&cycles_of(-1.0, 1)[0]).is_err());
        assert_eq!(histogram.total(), 0.0);
    }
}
