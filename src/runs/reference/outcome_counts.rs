//! Number of rows of each outcome.

use std::fmt;

use super::{Outcome, ValidationRow};

/// Number of rows of each outcome.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct OutcomeCounts {
    /// Within tolerance.
    pub pass: usize,
    /// Outside tolerance.
    pub fail: usize,
    /// Declared out of reach, and outside tolerance.
    pub differs: usize,
    /// Not judged, because an input was edited.
    pub edited: usize,
    /// Without a computed number.
    pub not_run: usize,
}

/// Counts outcomes.
#[must_use]
pub fn count_outcomes(rows: &[ValidationRow]) -> OutcomeCounts {
    let mut counts = OutcomeCounts::default();
    for row in rows {
        *match row.outcome {
            Outcome::Pass => &mut counts.pass,
            Outcome::Fail => &mut counts.fail,
            Outcome::Differs => &mut counts.differs,
            Outcome::Edited => &mut counts.edited,
            Outcome::NotRun => &mut counts.not_run,
        } += 1;
    }
    counts
}

impl OutcomeCounts {
    /// All rows.
    #[must_use]
    pub const fn total(&self) -> usize {
        self.pass + self.fail + self.differs + self.edited + self.not_run
    }

    /// True when no row is outside its tolerance and none is left without a number. Rows of edited inputs say
    /// nothing for or against.
    #[must_use]
    pub const fn holds(&self) -> bool {
        self.fail == 0 && self.not_run == 0
    }
}

impl fmt::Display for OutcomeCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            pass,
            fail,
            differs,
            edited,
            not_run,
        } = self;
        write!(
            f,
            "{} rows: {pass} PASS, {fail} FAIL, {differs} DIFFERS, ",
            self.total()
        )?;
        if *edited > 0 {
            write!(f, "{edited} EDITED, ")?;
        }
        write!(f, "{not_run} NOT RUN")
    }
}

impl std::ops::Add for OutcomeCounts {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            pass: self.pass + other.pass,
            fail: self.fail + other.fail,
            differs: self.differs + other.differs,
            edited: self.edited + other.edited,
            not_run: self.not_run + other.not_run,
        }
    }
}
