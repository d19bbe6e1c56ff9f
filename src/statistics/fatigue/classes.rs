//! Classes of equal width, to which the values of a series are rounded before counting.

use super::turning_points::{GREATEST, SeriesError};

/// Classes of equal width, to whose centres values are rounded before counting (ISO 12110-2: small ripples vanish).
///
/// The centres of the first and last class are the bounds, so `count` intervals have `count + 1` centres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Classes {
    low: f64,
    width: f64,
    count: usize,
}

impl Classes {
    /// So many intervals between two bounds.
    ///
    /// # Errors
    /// No interval, bounds that are not finite or do not rise.
    pub(super) fn new(low: f64, high: f64, count: usize) -> Result<Self, SeriesError> {
        let width = (high - low) / count as f64;
        let bounded = low.abs() <= GREATEST && high.abs() <= GREATEST;
        if count == 0 || !bounded || !(width.is_finite() && width > 0.0) {
            return Err(SeriesError::Classes { low, high, count });
        }
        Ok(Self { low, width, count })
    }

    /// So many intervals between the least and the greatest value.
    ///
    /// # Errors
    /// A value that is not finite; values that are all equal, or none.
    pub(super) fn of_values(values: &[f64], count: usize) -> Result<Self, SeriesError> {
        if let Some((index, &value)) = values.iter().enumerate().find(|(_, v)| !v.is_finite()) {
            return Err(SeriesError::Value { index, value });
        }
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self::new(low, high, count)
    }

    /// The class of a value, from zero; those outside belong to the first or last.
    #[must_use]
    pub(super) fn index(&self, value: f64) -> usize {
        // A cast of a float saturates, so that NaN and what lies below are in the first class.
        (((value - self.low) / self.width + 0.5).floor() as usize).min(self.count)
    }

    /// The centre of the class of a value.
    #[must_use]
    pub(super) fn centre(&self, value: f64) -> f64 {
        self.low + self.width * self.index(value) as f64
    }

    /// A series with every value at the centre of its class.
    #[must_use]
    pub(super) fn rounded(&self, values: &[f64]) -> Vec<f64> {
        values.iter().map(|&v| self.centre(v)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bad_classes_are_refused() {
        assert!(Classes::of_values(&[1.0, 1.0], 8).is_err() && Classes::of_values(&[], 8).is_err());
        assert!(
            Classes::new(0.0, 1.0, 0).is_err() && Classes::of_values(&[0.0, f64::NAN], 8).is_err()
        );
    }

    #[test]
    fn classes_round_to_their_centres() {
        let classes = Classes::new(0.0, 10.0, 5).unwrap();
        assert_eq!(
            classes.rounded(&[0.9, 1.1, 9.2, -3.0, 30.0]),
            [0.0, 2.0, 10.0, 0.0, 10.0]
        );
        assert_eq!(classes.index(5.0), 3, "half way belongs to the class above");
    }
}
