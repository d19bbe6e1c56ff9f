//! What a sample or a question must be for the statistics of extremes to answer.

/// Why a sample has no fit, a question no answer, or a record no peaks.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ExtremesError {
    /// Fewer values than the method needs.
    #[error("{found} values are too few: give {least} or more")]
    TooFew {
        /// Values given.
        found: usize,
        /// Values needed.
        least: usize,
    },
    /// A value that is no finite number, or values further apart than a number can hold.
    #[error("value {index} is not finite, or too far from the others: give finite numbers")]
    NotFinite {
        /// Its place, from zero.
        index: usize,
    },
    /// All values are the same, so they have no scale.
    #[error("all values are {0}: a fit needs two different values or more")]
    Constant(f64),
    /// A value at or below the location of a law that has values above it only.
    #[error(
        "value {value} is not above the location {location}: leave it out or lower the location"
    )]
    NotAbove {
        /// The value.
        value: f64,
        /// Location, the lower end of the law.
        location: f64,
    },
    /// A probability, level or ratio outside its range.
    #[error("{name} is {value}: give a number {range}")]
    OutOfRange {
        /// What it is.
        name: &'static str,
        /// As given.
        value: f64,
        /// The range in words.
        range: &'static str,
    },
    /// Times of a record that do not rise, or are not as many as its values.
    #[error("times must be finite and rise, one for each value; time {0} does not")]
    Times(usize),
    /// The likelihood has no maximum inside the parameters of the law.
    #[error(
        "the likelihood of the {0} law has no maximum for these values: give more values or a lower threshold"
    )]
    NoMaximum(&'static str),
    /// The expected greatest value of a law of shape one or above is infinite.
    #[error("the expected greatest value is infinite for a shape of {0}: ask for a quantile")]
    InfiniteMean(f64),
    /// The likelihood does not fall enough to bound the quantity, or resampled fits failed.
    #[error(
        "the values do not bound the quantity at this level: give more values or a lower level"
    )]
    Unbounded,
    /// The method of interval is not defined for the law.
    #[error(
        "an exact conditional interval exists for the Gumbel and Weibull laws only: use profile likelihood or bootstrap"
    )]
    NotLocationScale,
}

/// Values that are finite and as many as this.
pub(super) fn check_finite(values: &[f64], least: usize) -> Result<(), ExtremesError> {
    if values.len() < least {
        let found = values.len();
        return Err(ExtremesError::TooFew { found, least });
    }
    match values.iter().position(|v| !v.is_finite()) {
        Some(index) => Err(ExtremesError::NotFinite { index }),
        None => Ok(()),
    }
}

/// Least and greatest of finite values that are not all the same.
pub(super) fn check_spread(values: &[f64], least: usize) -> Result<(f64, f64), ExtremesError> {
    check_finite(values, least)?;
    let (mut low, mut high, mut at) = (f64::INFINITY, f64::NEG_INFINITY, 0);
    for (index, v) in values.iter().enumerate() {
        low = low.min(*v);
        if *v > high {
            (high, at) = (*v, index);
        }
    }
    let range = high - low;
    if !range.is_finite() {
        return Err(ExtremesError::NotFinite { index: at });
    }
    // A range below the rounding of the values has no digit of a scale.
    if range <= 1e-13 * low.abs().max(high.abs()) || range < 1e-290 {
        return Err(ExtremesError::Constant(low));
    }
    Ok((low, high))
}

/// A number inside an open range.
pub(super) fn check_inside(
    name: &'static str,
    value: f64,
    (low, high): (f64, f64),
    range: &'static str,
) -> Result<(), ExtremesError> {
    if value > low && value < high {
        Ok(())
    } else {
        Err(ExtremesError::OutOfRange { name, value, range })
    }
}

/// A confidence level or a probability, between 0 and 1.
pub(super) fn check_probability(name: &'static str, value: f64) -> Result<(), ExtremesError> {
    check_inside(name, value, (0.0, 1.0), "between 0 and 1, both excluded")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bad_samples_are_named() {
        let few = ExtremesError::TooFew { found: 1, least: 2 };
        assert_eq!(check_spread(&[1.0], 2), Err(few));
        assert_eq!(
            check_spread(&[1.0, f64::NAN], 2),
            Err(ExtremesError::NotFinite { index: 1 })
        );
        assert_eq!(
            check_spread(&[7.0, 7.0], 2),
            Err(ExtremesError::Constant(7.0))
        );
        assert_eq!(
            check_spread(&[-1.7e308, 1.7e308], 2),
            Err(ExtremesError::NotFinite { index: 1 })
        );
        assert_eq!(check_spread(&[3.0, -1.0, 2.0], 2), Ok((-1.0, 3.0)));
        assert!(
            check_probability("level", f64::NAN).is_err()
                && check_probability("level", 1.0).is_err()
        );
    }
}
