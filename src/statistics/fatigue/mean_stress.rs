//! Ranges corrected to zero mean.

/// How the mean of a cycle acts on its range.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum MeanCorrection {
    /// Not at all: curves of mooring components are from tests at a usual mean (API RP 2SK, DNV-OS-E301).
    #[default]
    None,
    /// Goodman's line: `range / (1 - mean/strength)`, for curves from tests about zero mean.
    Goodman {
        /// Strength, in the unit of range and mean.
        strength: f64,
    },
}

/// Why a range cannot be corrected.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum MeanStressError {
    /// A strength that is not positive.
    #[error("Goodman's strength is {strength}; it should be positive and finite")]
    Strength {
        /// What it is.
        strength: f64,
    },
    /// A mean of the strength or more, where Goodman's line has no range left.
    #[error(
        "a mean of {mean} reaches the strength {strength}; Goodman's correction holds below it"
    )]
    MeanAboveStrength {
        /// Mean of the cycle.
        mean: f64,
        /// Strength.
        strength: f64,
    },
    /// A range or mean that is none.
    #[error("a cycle of range {range} and mean {mean}: both are finite, the range not negative")]
    Cycle {
        /// Its range.
        range: f64,
        /// Its mean.
        mean: f64,
    },
}

/// A range at zero mean that does the same damage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CorrectedRange {
    /// The range.
    pub range: f64,
    /// d ln(range) / d(mean) of the correction.
    pub mean_slope: f64,
}

impl MeanCorrection {
    /// Corrects a range. A mean below zero is left uncorrected, which is on the safe side.
    ///
    /// # Errors
    /// A range or mean that is not finite, a strength that is not positive, a mean of the strength or more.
    pub fn correct(&self, range: f64, mean: f64) -> Result<CorrectedRange, MeanStressError> {
        if !(range >= 0.0 && range.is_finite() && mean.is_finite()) {
            return Err(MeanStressError::Cycle { range, mean });
        }
        let unchanged = CorrectedRange {
            range,
            mean_slope: 0.0,
        };
        let Self::Goodman { strength } = *self else {
            return Ok(unchanged);
        };
        if !(strength > 0.0 && strength.is_finite()) {
            return Err(MeanStressError::Strength { strength });
        }
        if mean >= strength {
            return Err(MeanStressError::MeanAboveStrength { mean, strength });
        }
        if mean <= 0.0 {
            return Ok(unchanged);
        }
        let corrected = range * (strength / (strength - mean));
        if !corrected.is_finite() {
            return Err(MeanStressError::Cycle { range, mean });
        }
        Ok(CorrectedRange {
            range: corrected,
            mean_slope: 1.0 / (strength - mean),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_the_strength_doubles_the_range() {
        let goodman = MeanCorrection::Goodman { strength: 8.0 };
        let at = goodman.correct(3.0, 4.0).unwrap();
        assert_eq!((at.range, at.mean_slope), (6.0, 0.25));
        assert_eq!(goodman.correct(3.0, -4.0).unwrap().range, 3.0);
        assert_eq!(MeanCorrection::None.correct(3.0, 90.0).unwrap().range, 3.0);
    }

    #[test]
    fn where_it_does_not_apply() {
        let goodman = MeanCorrection::Goodman { strength: 8.0 };
        let above = MeanStressError::MeanAboveStrength {
            mean: 8.0,
            strength: 8.0,
        };
        assert_eq!(goodman.correct(3.0, 8.0), Err(above));
        assert!(goodman.correct(f64::NAN, 1.0).is_err() && goodman.correct(-1.0, 1.0).is_err());
        assert!(MeanCorrection::None.correct(1.0, f64::INFINITY).is_err());
        assert!(
            MeanCorrection::Goodman { strength: 0.0 }
                .correct(1.0, -1.0)
                .is_err()
        );
        assert!(goodman.correct(f64::MAX, 7.9).is_err(), "no infinite range");
    }
}
