//! What an audit found.

use std::ops::Range;

/// What a finding is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Topic {
    /// The system itself: no equilibrium, an unstable one.
    Equilibrium,
    /// What in the file contradicts itself.
    Contradiction,
    /// The state that a run starts from.
    Start,
    /// The time step.
    Step,
    /// The division into segments.
    Mesh,
    /// A setting that does not do what it seems to.
    Setting,
}

impl Topic {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Equilibrium => "equilibrium",
            Self::Contradiction => "contradiction",
            Self::Start => "start",
            Self::Step => "time step",
            Self::Mesh => "segments",
            Self::Setting => "setting",
        }
    }
}

/// One finding.
#[derive(Debug, Clone, PartialEq)]
pub struct AuditFinding {
    /// What it is about.
    pub topic: Topic,
    /// The part or setting meant, such as `line 3` or `dtM`.
    pub subject: String,
    /// The bytes of the file that it is about; nothing for what the file does not say.
    pub span: Option<Range<usize>>,
    /// What was found, with its figures.
    pub what: String,
    /// What to do.
    pub remedy: String,
    /// The figure, what it would be, and their unit.
    pub figure: Option<FindingFigure>,
}

/// A figure of a finding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FindingFigure {
    /// What it is.
    pub value: f64,
    /// What it should be, or may be at most.
    pub reference: f64,
    /// Unit of both.
    pub unit: &'static str,
}

impl AuditFinding {
    /// A finding without a place or figure.
    #[must_use]
    pub fn new(
        topic: Topic,
        subject: impl Into<String>,
        what: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self {
            topic,
            subject: subject.into(),
            span: None,
            what: what.into(),
            remedy: remedy.into(),
            figure: None,
        }
    }

    /// The same at these bytes.
    #[must_use]
    pub fn at(mut self, span: &Range<usize>) -> Self {
        self.span = Some(span.clone());
        self
    }

    /// The same with a figure.
    #[must_use]
    pub fn figure(mut self, value: f64, reference: f64, unit: &'static str) -> Self {
        self.figure = Some(FindingFigure {
            value,
            reference,
            unit,
        });
        self
    }
}
