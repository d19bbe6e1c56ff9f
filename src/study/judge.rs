//! A trial held against what must come out: computed and right, refused with a reason, or wrong.

use super::hard::{Computed, Hard};
use crate::case::{Case, Trial};
use crate::reference::{self, ValidationRow};
use crate::run::{Run, RunState, Settings, Work};

/// How a trial came out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Every number within its tolerance.
    Ok,
    /// Not computed, and the reason told.
    Refused,
    /// A number outside its tolerance, or one where none may be.
    Wrong,
}

impl Outcome {
    /// The word for it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Ok => "OK",
            Self::Refused => "REFUSED",
            Self::Wrong => "WRONG",
        }
    }
}

/// A number of a trial.
#[derive(Debug, Clone, PartialEq)]
pub struct Number {
    /// What it is.
    pub name: String,
    /// What must come out.
    pub expected: f64,
    /// What came out; absent where the run does not hold it.
    pub computed: Option<f64>,
    /// How far off it may be.
    pub tolerance: f64,
    /// Unit of all three.
    pub unit: String,
    /// Where the expected number is from.
    pub source: String,
}

impl Number {
    /// How far off it is, as a share of what it may be.
    pub(super) fn share(&self) -> f64 {
        let off = self
            .computed
            .map_or(f64::INFINITY, |value| value - self.expected);
        off.abs() / self.tolerance
    }

    fn is_right(&self) -> bool {
        self.computed
            .is_some_and(|value| (value - self.expected).abs() <= self.tolerance)
    }
}

/// A trial and how it came out.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Title of the case.
    pub case: String,
    /// File of the case.
    pub file: String,
    /// Name of the trial.
    pub trial: String,
    /// The settings it ran with; absent where the case was refused before it ran.
    pub settings: Option<Settings>,
    /// The work it took.
    pub work: Work,
    /// How it came out.
    pub outcome: Outcome,
    /// Why it was refused, or what is wrong.
    pub reason: Option<String>,
    /// Whether being refused is what must come out.
    pub to_be_refused: bool,
    /// Its numbers; none where it was refused.
    pub numbers: Vec<Number>,
}

impl Finding {
    /// Whether the trial came out as it must: right where it is to be computed, refused where it is to be refused.
    #[must_use]
    pub fn is_as_expected(&self) -> bool {
        match self.outcome {
            Outcome::Ok => !self.to_be_refused,
            Outcome::Refused => self.to_be_refused,
            Outcome::Wrong => false,
        }
    }
}

/// Holds a trial against what must come out; `other` is the run whose numbers must come out again.
pub(super) fn finding(
    hard: &Hard,
    trial: &Trial,
    computed: &Computed,
    other: Option<&Run>,
) -> Finding {
    let run = computed.as_ref().ok();
    let done = run.filter(|run| run.info.state == RunState::Done);
    let refusal = match computed {
        Err(reason) => Some(reason.clone()),
        Ok(run) => run.info.failure.clone(),
    };
    let numbers = done.map_or_else(Vec::new, |run| numbers(hard, trial, run, other));
    let untold = trial.told.as_ref().filter(|words| {
        let warned = |run: &Run| run.info.warnings.iter().any(|w| w.contains(words.as_str()));
        done.is_some_and(|run| !warned(run))
    });
    let (outcome, reason) = match untold {
        Some(words) => {
            let why = format!("It must be told of (`{words}`), and was not.");
            (Outcome::Wrong, Some(why))
        }
        None => judge(trial, refusal, done.is_some(), &numbers),
    };
    Finding {
        case: hard.case.case.title.clone(),
        file: hard.file.clone(),
        trial: trial.name.clone(),
        settings: run.map(|run| run.info.settings.clone()),
        work: run.map_or_else(Work::default, |run| run.info.work),
        outcome,
        reason,
        to_be_refused: trial.refused.is_some(),
        numbers,
    }
}

fn judge(
    trial: &Trial,
    refusal: Option<String>,
    done: bool,
    numbers: &[Number],
) -> (Outcome, Option<String>) {
    let off: Vec<&str> = numbers
        .iter()
        .filter(|n| !n.is_right())
        .map(|n| n.name.as_str())
        .collect();
    match (&trial.refused, refusal) {
        (Some(words), Some(reason)) if !reason.contains(words.as_str()) => {
            let why = format!("It must be refused for another reason (`{words}`) than: {reason}");
            (Outcome::Wrong, Some(why))
        }
        (_, Some(reason)) => (Outcome::Refused, Some(reason)),
        (Some(words), None) if done => {
            let why = format!("It must be refused (`{words}`), and was computed.");
            (Outcome::Wrong, Some(why))
        }
        (_, None) if !done => (Outcome::Refused, Some("It was stopped.".to_owned())),
        _ if numbers.is_empty() => (
            Outcome::Wrong,
            Some("There is no number to hold it against.".to_owned()),
        ),
        _ if off.is_empty() => (Outcome::Ok, None),
        _ => (
            Outcome::Wrong,
            Some(format!("Outside the tolerance: {}.", off.join(", "))),
        ),
    }
}

/// The numbers a trial is held against: those of the closed form, or those of another trial.
fn numbers(hard: &Hard, trial: &Trial, run: &Run, other: Option<&Run>) -> Vec<Number> {
    let of = |run: &Run| rows(&hard.case, trial, run);
    let here = of(run);
    match (&trial.same_as, other) {
        (None, _) => here.into_iter().filter_map(by_closed_form).collect(),
        (Some(name), Some(other)) => {
            let pairs = here.into_iter().zip(of(other));
            let share = trial.same_rel.unwrap_or(0.0);
            pairs
                .filter_map(|(row, twin)| by_twin(row, &twin, share, name))
                .collect()
        }
        (Some(_), None) => Vec::new(),
    }
}

/// The published values that a trial names; without names, those of the case as it stands.
fn rows(case: &Case, trial: &Trial, run: &Run) -> Vec<ValidationRow> {
    let all = reference::rows(case, &|_| Some(run));
    let wanted = |row: &ValidationRow| match &trial.rows {
        Some(names) => names.contains(&row.name),
        None => row.at.is_none(),
    };
    all.into_iter().filter(wanted).collect()
}

fn by_closed_form(row: ValidationRow) -> Option<Number> {
    Some(Number {
        expected: row.published?,
        computed: row.computed,
        tolerance: row.tolerance?,
        name: row.name,
        unit: row.unit,
        source: row.source,
    })
}

fn by_twin(row: ValidationRow, twin: &ValidationRow, share: f64, name: &str) -> Option<Number> {
    let expected = twin.computed?;
    Some(Number {
        expected,
        computed: row.computed,
        tolerance: share * expected.abs(),
        name: row.name,
        unit: row.unit,
        source: format!("trial \"{name}\""),
    })
}

/// Trials counted by outcome.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Tally {
    /// Right.
    pub ok: usize,
    /// Refused with a reason, as must be.
    pub refused: usize,
    /// Refused with a reason where a number was to come out.
    pub refused_too_much: usize,
    /// Wrong.
    pub wrong: usize,
}

/// Counts trials by outcome.
#[must_use]
pub fn tally(findings: &[Finding]) -> Tally {
    let mut tally = Tally::default();
    for finding in findings {
        *match finding.outcome {
            Outcome::Ok => &mut tally.ok,
            Outcome::Refused if finding.to_be_refused => &mut tally.refused,
            Outcome::Refused => &mut tally.refused_too_much,
            Outcome::Wrong => &mut tally.wrong,
        } += 1;
    }
    tally
}

impl Tally {
    /// True when every trial came out as it must.
    #[must_use]
    pub const fn holds(&self) -> bool {
        self.wrong == 0 && self.refused_too_much == 0
    }
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            ok,
            refused,
            refused_too_much,
            wrong,
        } = self;
        let all = ok + refused + refused_too_much + wrong;
        write!(
            f,
            "{all} trials: {ok} OK, {} REFUSED",
            refused + refused_too_much
        )?;
        if *refused_too_much > 0 {
            write!(f, " ({refused_too_much} of them to be computed)")?;
        }
        write!(f, ", {wrong} WRONG")
    }
}
