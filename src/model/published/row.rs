//! The comparison of one published statement with a run.

use std::fmt;

use crate::case::{ChannelId, Direction, Evidence, Provenance, StudyPoint, StudyValue};

/// A row of the validation table: a published value, trend or curve compared with a run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ValidationRow {
    /// What it is, in words.
    pub name: String,
    /// The point of a study it belongs to; absent for the case without a study, and for trends.
    pub at: Option<StudyPoint>,
    /// The point of a study that it is a change from; absent where it is no change.
    pub from: Option<StudyPoint>,
    /// The point of a study that it is a ratio to; absent where it is none.
    pub by: Option<StudyPoint>,
    /// Where it is printed.
    pub source: String,
    /// The published value; absent for trends.
    pub published: Option<f64>,
    /// The computed value; absent when not run, and for trends.
    pub computed: Option<f64>,
    /// Unit of every number here.
    pub unit: String,
    /// Estimated numerical error of the computed value; absent when not estimated.
    pub error: Option<f64>,
    /// Computed less published.
    pub difference: Option<f64>,
    /// Greatest difference that passes; absent for trends.
    pub tolerance: Option<f64>,
    /// The outcome.
    pub outcome: Outcome,
    /// Provenance of the inputs behind the computed value, at worst; absent for trends.
    pub inputs: Option<Provenance>,
    /// What an agreement is worth.
    pub kind: RowKind,
    /// What else the file says of it.
    pub note: Option<String>,
    /// Why the tolerance is what it is; absent where the file states no reason, and for trends.
    pub tolerance_reason: Option<String>,
    /// How far an agreement is evidence; absent where no input was calibrated.
    pub basis: Option<CalibrationBasis>,
    /// Whether it is of trials of its file alone.
    pub of_trials: bool,
    /// Why it differs or was not run; and what else the reader must know.
    pub reason: Option<String>,
    /// For a trend: what is expected and the numbers along the study.
    pub trend: Option<TrendLine>,
    /// For a curve: its points beside what the run gives.
    pub overlay: Option<CurveOverlay>,
}

impl ValidationRow {
    /// How far it is off, in tolerances; absent for trends and rows without a number.
    #[must_use]
    pub fn in_tolerances(&self) -> Option<f64> {
        let tolerance = self.tolerance.filter(|tolerance| *tolerance > 0.0)?;
        Some(self.difference?.abs() / tolerance)
    }

    /// A row without a computed value, which reads NOT RUN.
    pub fn not_run(name: &str, source: &str, unit: String) -> Self {
        Self {
            name: name.to_owned(),
            source: source.to_owned(),
            unit,
            ..Self::default()
        }
    }

    /// The row with the reason that its file states for all tolerances, where it has a tolerance and no reason of its own.
    #[must_use]
    pub fn with_common_reason(mut self, reason: Option<&str>) -> Self {
        if self.tolerance.is_some() && self.tolerance_reason.is_none() {
            self.tolerance_reason = reason.map(str::to_owned);
        }
        self
    }
}

/// What an agreement of a row is worth as evidence.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum RowKind {
    /// A number computed from inputs none of which was fitted to it.
    #[default]
    Predicted,
    /// A statement of how a number changes along a study.
    Trend,
    /// A formula worked out beside the source.
    ClosedForm,
    /// An input was fitted to this number or to another print of it: agreement is no evidence.
    Fitted,
    /// An input, or an exact consequence of inputs: agreement is no evidence.
    Echoed,
}

impl RowKind {
    /// All kinds.
    pub const ALL: [Self; 5] = [
        Self::Predicted,
        Self::Trend,
        Self::ClosedForm,
        Self::Fitted,
        Self::Echoed,
    ];

    /// The word for it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Predicted => "predicted",
            Self::Trend => "trend",
            Self::ClosedForm => "closed form",
            Self::Fitted => "fitted",
            Self::Echoed => "echoed",
        }
    }

    /// True where an agreement says something about the source.
    #[must_use]
    pub const fn is_evidence(self) -> bool {
        matches!(self, Self::Predicted | Self::Trend)
    }
}

impl From<Evidence> for RowKind {
    fn from(evidence: Evidence) -> Self {
        match evidence {
            Evidence::Predicted => Self::Predicted,
            Evidence::Fitted => Self::Fitted,
            Evidence::Echoed => Self::Echoed,
            Evidence::ClosedForm => Self::ClosedForm,
        }
    }
}

/// A published curve beside a run, over the times of the run; without a run, as it is published.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveOverlay {
    /// The channel it is of.
    pub channel: ChannelId,
    /// Unit of the values; empty without a run.
    pub unit: &'static str,
    /// Times \[s\] and values that are published.
    pub published: Vec<(f64, f64)>,
    /// Times \[s\] and values of the run.
    pub computed: Vec<(f64, f64)>,
}

/// How far an agreement is evidence when inputs were calibrated.
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

/// The outcome of a comparison.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Outcome {
    /// Within its tolerance; for a trend: it does as stated.
    Pass,
    /// Outside its tolerance.
    Fail,
    /// Outside its tolerance, and the case says beforehand why the number is out of reach.
    Differs,
    /// Not judged: an input is not the one that the published value is for.
    Edited,
    /// There is no run, or the run does not hold the number.
    #[default]
    NotRun,
}

impl Outcome {
    /// The word for it: `PASS`, `FAIL`, `DIFFERS`, `EDITED`, `NOT RUN`.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Pass => "PASS",
            Self::Fail => "FAIL",
            Self::Differs => "DIFFERS",
            Self::Edited => "EDITED",
            Self::NotRun => "NOT RUN",
        }
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}
