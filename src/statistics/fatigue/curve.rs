//! Fatigue curves: cycles to failure by the range of tension or stress.
//!
//! `log10 N = log10 K - c Lm - m log10 x`, where x is the range of tension over the reference strength (T-N curve) or the
//! range of nominal stress in MPa (S-N curve), and Lm the mean tension over the reference strength (API RP 2SK for wire
//! rope; c is zero elsewhere). Below a knee a second exponent holds (DNV-RP-C203, 2.4).

/// Why a curve cannot be made or used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CurveError {
    /// A quantity outside its bounds.
    #[error("{name} is {value}; it should be {bounds}")]
    Bounds {
        /// Its name.
        name: &'static str,
        /// What it is.
        value: f64,
        /// What it may be.
        bounds: &'static str,
    },
    /// A tension ratio or a mean load without the strength that it is related to.
    #[error("the curve needs a reference strength: {reason}")]
    NoStrength {
        /// What for.
        reason: &'static str,
    },
    /// A mean tension of the strength or more.
    #[error(
        "the mean tension {mean} N reaches the reference strength {strength} N; the curve holds below it"
    )]
    MeanAboveStrength {
        /// Mean tension, N.
        mean: f64,
        /// Reference strength, N.
        strength: f64,
    },
    /// A damage that is too great for a number.
    #[error(
        "a range of {range} N does more damage than a number can hold; check reference strength, area and units"
    )]
    Overflow {
        /// Range of tension, N.
        range: f64,
    },
}

/// Checks that a quantity lies in an interval.
pub(crate) fn check(
    name: &'static str,
    value: f64,
    interval: std::ops::RangeInclusive<f64>,
    bounds: &'static str,
) -> Result<f64, CurveError> {
    if interval.contains(&value) {
        Ok(value)
    } else {
        Err(CurveError::Bounds {
            name,
            value,
            bounds,
        })
    }
}

/// A second slope for small ranges, from a number of cycles on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Knee {
    /// Cycles to failure at the knee.
    pub cycles: f64,
    /// Exponent beyond.
    pub exponent: f64,
}

/// Cycles to failure by a range x without or with a unit (MPa).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// Exponent m.
    pub exponent: f64,
    /// Logarithm of the constant K, to base 10.
    pub log10_constant: f64,
    /// By how much a mean load of the whole reference strength lowers that logarithm.
    pub mean_slope: f64,
    /// Second slope.
    pub knee: Option<Knee>,
}

impl Law {
    /// `N x^m = 10^log10_constant`.
    #[must_use]
    pub const fn new(exponent: f64, log10_constant: f64) -> Self {
        Self {
            exponent,
            log10_constant,
            mean_slope: 0.0,
            knee: None,
        }
    }

    /// The same whose constant falls with the mean load, `log10 K = log10_constant - slope Lm`.
    #[must_use]
    pub const fn falling_with_mean(mut self, slope: f64) -> Self {
        self.mean_slope = slope;
        self
    }

    /// The same with another exponent beyond so many cycles.
    #[must_use]
    pub const fn with_knee(mut self, cycles: f64, exponent: f64) -> Self {
        self.knee = Some(Knee { cycles, exponent });
        self
    }

    /// Checks its numbers.
    ///
    /// # Errors
    /// An exponent outside 0.1 to 50, a constant outside 10^±100, a slope outside 0 to 50, a knee outside 1 to 10^15 cycles.
    pub fn checked(self) -> Result<Self, CurveError> {
        check(
            "the exponent m",
            self.exponent,
            0.1..=50.0,
            "from 0.1 to 50",
        )?;
        let constant = self.log10_constant;
        check(
            "log10 of the constant K",
            constant,
            -100.0..=100.0,
            "from -100 to 100",
        )?;
        check(
            "the slope of log10 K with the mean load",
            self.mean_slope,
            0.0..=50.0,
            "from 0 to 50",
        )?;
        if let Some(knee) = self.knee {
            check(
                "the number of cycles at the knee",
                knee.cycles,
                1.0..=1e15,
                "from 1 to 1e15",
            )?;
            check(
                "the exponent beyond the knee",
                knee.exponent,
                0.1..=50.0,
                "from 0.1 to 50",
            )?;
        }
        Ok(self)
    }

    /// Logarithm of the constant at a mean load over the reference strength.
    fn constant_at(&self, mean_ratio: f64) -> f64 {
        self.log10_constant - self.mean_slope * mean_ratio.max(0.0)
    }

    /// The parts of the law at a mean load: exponent, logarithm of the constant, and the logarithm of the x of the knee.
    #[must_use]
    pub fn parts(&self, mean_ratio: f64) -> LawParts {
        let constant = self.constant_at(mean_ratio);
        let small = self.knee.map(|knee| {
            let log10_x = (constant - knee.cycles.log10()) / self.exponent;
            let beyond = knee.cycles.log10() + knee.exponent * log10_x;
            (log10_x, (knee.exponent, beyond))
        });
        LawParts {
            large: (self.exponent, constant),
            small,
        }
    }
}

/// Exponents and logarithms of constants of a [`Law`] at a mean load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawParts {
    /// For large ranges.
    pub large: (f64, f64),
    /// Logarithm of the x of the knee; for ranges below it.
    pub small: Option<(f64, (f64, f64))>,
}

impl LawParts {
    /// Exponent and logarithm of the constant at a logarithm of x.
    #[must_use]
    pub fn at(&self, log10_x: f64) -> (f64, f64) {
        match self.small {
            Some((knee, beyond)) if log10_x < knee => beyond,
            _ => self.large,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_parts_meet_at_the_knee() {
        let law = Law::new(3.0, 11.0)
            .with_knee(1e6, 5.0)
            .falling_with_mean(2.0);
        for ratio in [0.0, 0.3, -1.0] {
            let parts = law.parts(ratio);
            let (knee, (exponent, constant)) = parts.small.unwrap();
            assert!((parts.large.1 - 3.0 * knee - 6.0).abs() < 1e-12);
            assert!((constant - exponent * knee - 6.0).abs() < 1e-12);
            assert_eq!(
                (parts.at(knee), parts.at(knee - 1e-9).0),
                (parts.large, 5.0)
            );
        }
        assert_eq!(law.parts(-1.0), law.parts(0.0));
    }

    #[test]
    fn bad_numbers_are_refused() {
        for bad in [
            Law::new(0.0, 1.0),
            Law::new(f64::NAN, 1.0),
            Law::new(3.0, 101.0),
        ] {
            assert!(bad.checked().is_err());
        }
        let law = Law::new(3.0, 2.5);
        assert!(law.with_knee(0.0, 5.0).checked().is_err());
        assert!(law.with_knee(1e6, f64::INFINITY).checked().is_err());
        let error = law.falling_with_mean(-1.0).checked().unwrap_err();
        assert!(
            error
                .to_string()
                .contains("is -1; it should be from 0 to 50")
        );
    }
}
