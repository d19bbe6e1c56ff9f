//! One published statement held against a run.

use std::fmt;

use crate::case::{At, Direction, Standing, StudyValue};

/// One published statement held against a run: a value, or a trend.
#[derive(Debug, Clone, PartialEq)]
pub struct ValidationRow {
    /// What it is, in words.
    pub name: String,
    /// The point of a study it belongs to; absent: the case as it stands (and for trends).
    pub at: Option<At>,
    /// The point of a study that it is a change from; absent where it is no change.
    pub from: Option<At>,
    /// The point of a study that it is a ratio to; absent where it is none.
    pub by: Option<At>,
    /// Where it is printed.
    pub source: String,
    /// The published value; absent for trends.
    pub published: Option<f64>,
    /// What the run gives; absent when not run, and for trends.
    pub computed: Option<f64>,
    /// Unit of every number here.
    pub unit: String,
    /// Estimated numerical error of the computed value; absent when not estimated.
    pub error: Option<f64>,
    /// Computed less published.
    pub difference: Option<f64>,
    /// Greatest difference that passes; absent for trends.
    pub tolerance: Option<f64>,
    /// How it stands.
    pub outcome: Outcome,
    /// Standing of the inputs behind the computed value, at worst; absent for trends.
    pub inputs: Option<Standing>,
    /// True when an input was fitted to this very number: agreement is then no evidence.
    pub fitted: bool,
    /// What the inputs make of an agreement; absent where they were not calibrated.
    pub basis: Option<CalibrationBasis>,
    /// Why it differs or was not run; and what else the reader must know.
    pub reason: Option<String>,
    /// For a trend: what is expected and the numbers along the study.
    pub trend: Option<TrendLine>,
    /// For a curve: its points beside what the run gives.
    pub overlay: Option<Overlay>,
}

/// A published curve beside a run, over the times of the run; without a run, as it is published.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    /// The channel it is of.
    pub channel: String,
    /// Unit of the values; empty without a run.
    pub unit: String,
    /// Times \[s\] and values that are published.
    pub published: Vec<(f64, f64)>,
    /// Times \[s\] and values of the run.
    pub computed: Vec<(f64, f64)>,
}

/// What an agreement is worth when inputs were calibrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CalibrationBasis {
    /// An input was fitted to this very number.
    Fitted,
    /// An input was fitted to another published value of the same quantity.
    FittedNearby,
    /// Inputs were calibrated, but on other quantities.
    Prediction,
}

impl CalibrationBasis {
    /// A sentence for it.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Fitted => "An input was fitted to this very number: agreement is no evidence.",
            Self::FittedNearby => {
                "An input was fitted to another published value of this quantity: agreement is no evidence."
            }
            Self::Prediction => {
                "Inputs were calibrated, but on other quantities: this one is a prediction."
            }
        }
    }
}

/// A statistic along a study.
#[derive(Debug, Clone, PartialEq)]
pub struct TrendLine {
    /// What the source says it does as the study's values grow.
    pub expect: Direction,
    /// The key that is varied.
    pub key: String,
    /// The numbers, in the order of growing values.
    pub points: Vec<TrendPoint>,
}

/// A statistic at one value of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct TrendPoint {
    /// Value of the study's key, in its unit.
    pub value: StudyValue,
    /// What the run gives; absent when not run.
    pub computed: Option<f64>,
    /// Its estimated numerical error; absent when not estimated.
    pub error: Option<f64>,
}

/// How a row stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Within its tolerance; for a trend: it does as stated.
    Pass,
    /// Outside its tolerance.
    Fail,
    /// Outside its tolerance, and the case says beforehand why the number is out of reach.
    Differs,
    /// There is no run, or the run does not hold the number.
    NotRun,
}

impl Outcome {
    /// The word for it: `PASS`, `FAIL`, `DIFFERS`, `NOT RUN`.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Pass => "PASS",
            Self::Fail => "FAIL",
            Self::Differs => "DIFFERS",
            Self::NotRun => "NOT RUN",
        }
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}
