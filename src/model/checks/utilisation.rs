//! How much of a limit a load uses, with both errors of the load, and the verdict that these leave.

/// A load with its errors: the numerical one of the runs, and that of the sample of the sea.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Its value, in its unit.
    pub value: f64,
    /// How far the runs may be off, in the same unit; nothing where it was not estimated.
    pub numerical: Option<f64>,
    /// The interval of the sample, in the same unit; nothing where there is no sample, such as at rest.
    pub sample: Option<[f64; 2]>,
}

/// A share of a limit that is used, 1 at the limit \[-\], with what each error alone and both together make of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Utilisation {
    /// Its value.
    pub value: f64,
    /// By the numerical error alone: least and greatest; nothing where that was not estimated.
    pub numerical: Option<[f64; 2]>,
    /// By the sample alone.
    pub sample: Option<[f64; 2]>,
    /// By both at once.
    pub both: [f64; 2],
}

/// What a utilisation says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum UtilisationVerdict {
    /// It stays below the limit, with both errors.
    Passes,
    /// The limit lies within the errors.
    Open,
    /// It is above the limit, with both errors.
    Fails,
}

impl UtilisationVerdict {
    /// Its word.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Passes => "passes",
            Self::Open => "not settled",
            Self::Fails => "fails",
        }
    }
}

impl Estimate {
    /// A value without errors.
    #[must_use]
    pub const fn exact(value: f64) -> Self {
        Self {
            value,
            numerical: None,
            sample: None,
        }
    }

    /// The utilisation by this load, which a monotone function of the load gives: rising for an upper limit, falling for a lower one.
    #[must_use]
    pub fn utilisation(&self, of: impl Fn(f64) -> f64) -> Utilisation {
        let ordered = |[a, b]: [f64; 2]| if a <= b { [a, b] } else { [b, a] };
        let range = |low: f64, high: f64| ordered([of(low), of(high)]);
        let error = self.numerical.unwrap_or(0.0);
        let [low, high] = self.sample.unwrap_or([self.value; 2]);
        Utilisation {
            value: of(self.value),
            numerical: self
                .numerical
                .map(|error| range(self.value - error, self.value + error)),
            sample: self.sample.map(|[low, high]| range(low, high)),
            both: range(low - error, high + error),
        }
    }
}

impl Utilisation {
    /// Whether no sample could settle it: wherever the sample's interval has the value, the limit lies within the numerical error.
    #[must_use]
    pub fn needs_finer_runs(&self) -> bool {
        let (Some([low, high]), Some([from, to])) = (self.numerical, self.sample) else {
            return false;
        };
        let (above, below) = (high - self.value, self.value - low);
        from + above > 1.0 && to - below <= 1.0
    }

    /// Whether it is open by its numerical error, whatever the sample.
    #[must_use]
    pub fn is_open_by_error(&self) -> bool {
        let is_of_error = self.sample.is_none() || self.needs_finer_runs();
        self.verdict() == UtilisationVerdict::Open && is_of_error
    }

    /// What it says.
    #[must_use]
    pub fn verdict(&self) -> UtilisationVerdict {
        match self.both {
            [_, high] if high <= 1.0 => UtilisationVerdict::Passes,
            [low, _] if low > 1.0 => UtilisationVerdict::Fails,
            _ => UtilisationVerdict::Open,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOAD: Estimate = Estimate {
        value: 2.0,
        numerical: Some(0.1),
        sample: Some([1.8, 2.4]),
    };

    #[test]
    fn errors_go_through_and_are_not_added_where_stated_alone() {
        let upper = LOAD.utilisation(|load| load / 4.0);
        assert_eq!(upper.value, 0.5);
        let near = |found: [f64; 2], wanted: [f64; 2]| {
            let off = (found[0] - wanted[0]).abs() + (found[1] - wanted[1]).abs();
            assert!(off < 1e-12, "{found:?} {wanted:?}");
        };
        near(upper.numerical.unwrap(), [0.475, 0.525]);
        near(upper.sample.unwrap(), [0.45, 0.6]);
        near(upper.both, [0.425, 0.625]);
        // A lower limit turns the ends round.
        let lower = LOAD.utilisation(|load| 1.0 / load);
        near(lower.sample.unwrap(), [1.0 / 2.4, 1.0 / 1.8]);
        near(lower.both, [1.0 / 2.5, 1.0 / 1.7]);
    }

    #[test]
    fn a_verdict_is_open_where_the_limit_lies_within_the_errors() {
        let at = |limit: f64| LOAD.utilisation(|load| load / limit).verdict();
        assert_eq!(at(2.51), UtilisationVerdict::Passes);
        assert_eq!(at(2.45), UtilisationVerdict::Open);
        assert_eq!(at(1.75), UtilisationVerdict::Open);
        assert_eq!(at(1.69), UtilisationVerdict::Fails);
        let exact = Estimate::exact(1.0).utilisation(|load| load);
        assert_eq!(exact.verdict(), UtilisationVerdict::Passes);
        assert_eq!(exact.both, [1.0, 1.0]);
    }

    #[test]
    fn no_seeds_settle_what_lies_within_the_numerical_error() {
        let at = |limit: f64, numerical: f64| {
            let load = Estimate {
                numerical: Some(numerical),
                ..LOAD
            };
            load.utilisation(|load| load / limit).needs_finer_runs()
        };
        // The sample is from 1.8 to 2.4.
        assert!(!at(2.1, 0.1));
        assert!(at(2.1, 0.5));
        assert!(!at(4.0, 0.5));
    }

    #[test]
    fn a_load_that_leaves_its_limit_behind_is_never_half_counted() {
        // Bend radius towards zero, clearance below: the share grows without bound, and stays a number that compares.
        let used = |least: f64| {
            if least > 0.0 {
                1.0 / least
            } else {
                f64::INFINITY
            }
        };
        let load = Estimate {
            value: 0.1,
            numerical: Some(0.2),
            sample: None,
        };
        let found = load.utilisation(used);
        assert_eq!(found.both[1], f64::INFINITY);
        assert_eq!(found.verdict(), UtilisationVerdict::Fails);
    }
}
