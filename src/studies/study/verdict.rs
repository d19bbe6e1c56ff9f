//! The verdict on a trial: computed within tolerance, refused with a reason, or wrong.

use super::hard_cases::{HardCase, TrialRun};
use super::tried::ComputedTrial;
use crate::case::Trial;
use crate::reference::ValidationRow;
use crate::run::{Settings, Work};

/// The outcome of a trial.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TrialOutcome {
    /// Every number within its tolerance.
    Ok,
    /// Not computed, with the reason.
    Refused,
    /// A number outside its tolerance, or one where none may be.
    Wrong,
}

impl TrialOutcome {
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
pub struct CheckedNumber {
    /// What it is.
    pub name: String,
    /// Expected value.
    pub expected: f64,
    /// Computed value; absent where the run does not hold it.
    pub computed: Option<f64>,
    /// Greatest difference allowed.
    pub tolerance: f64,
    /// Unit of all three.
    pub unit: String,
    /// Source of the expected value.
    pub source: String,
}

impl CheckedNumber {
    /// Difference over tolerance.
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

/// A trial with its outcome.
#[derive(Debug, Clone, PartialEq)]
pub struct TrialVerdict {
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
    /// Its outcome.
    pub outcome: TrialOutcome,
    /// Why it was refused, or what is wrong.
    pub reason: Option<String>,
    /// Whether a refusal is expected.
    pub expect_refusal: bool,
    /// Its numbers; none where it was refused.
    pub numbers: Vec<CheckedNumber>,
}

impl TrialVerdict {
    /// Whether the outcome is the expected one.
    #[must_use]
    pub fn is_as_expected(&self) -> bool {
        match self.outcome {
            TrialOutcome::Ok => !self.expect_refusal,
            TrialOutcome::Refused => self.expect_refusal,
            TrialOutcome::Wrong => false,
        }
    }
}

/// Compares a trial with its expected result; `other` is the one whose numbers it must reproduce.
pub(super) fn verdict(
    hard: &HardCase,
    trial: &Trial,
    computed: &TrialRun,
    other: Option<&ComputedTrial>,
) -> TrialVerdict {
    let run = computed.as_ref().ok();
    let done = run.filter(|run| run.is_done);
    let refusal = match computed {
        Err(reason) => Some(reason.clone()),
        Ok(run) => run.failure.clone(),
    };
    let numbers = done.map_or_else(Vec::new, |run| numbers(trial, run, other));
    let unwarned = trial.told.as_ref().filter(|words| {
        let warned = |run: &ComputedTrial| run.warnings.iter().any(|w| w.contains(words.as_str()));
        done.is_some_and(|run| !warned(run))
    });
    let (outcome, reason) = match unwarned {
        Some(words) => {
            let why = format!("A warning (`{words}`) is expected, and there is none.");
            (TrialOutcome::Wrong, Some(why))
        }
        None => outcome_of(trial, refusal, done.is_some(), &numbers),
    };
    TrialVerdict {
        case: hard.title.clone(),
        file: hard.file.clone(),
        trial: trial.name.clone(),
        settings: run.map(|run| run.settings.clone()),
        work: run.map_or_else(Work::default, |run| run.work),
        outcome,
        reason,
        expect_refusal: trial.refused.is_some(),
        numbers,
    }
}

fn outcome_of(
    trial: &Trial,
    refusal: Option<String>,
    done: bool,
    numbers: &[CheckedNumber],
) -> (TrialOutcome, Option<String>) {
    let off: Vec<&str> = numbers
        .iter()
        .filter(|n| !n.is_right())
        .map(|n| n.name.as_str())
        .collect();
    match (&trial.refused, refusal) {
        (Some(words), Some(reason)) if !reason.contains(words.as_str()) => {
            let why =
                format!("A refusal for another reason (`{words}`) is expected, not: {reason}");
            (TrialOutcome::Wrong, Some(why))
        }
        (_, Some(reason)) => (TrialOutcome::Refused, Some(reason)),
        (Some(words), None) if done => {
            let why = format!("A refusal (`{words}`) is expected, and it was computed.");
            (TrialOutcome::Wrong, Some(why))
        }
        (_, None) if !done => (TrialOutcome::Refused, Some("It was stopped.".to_owned())),
        _ if numbers.is_empty() => (
            TrialOutcome::Wrong,
            Some("There is no expected number to compare with.".to_owned()),
        ),
        _ if off.is_empty() => (TrialOutcome::Ok, None),
        _ => (
            TrialOutcome::Wrong,
            Some(format!("Outside the tolerance: {}.", off.join(", "))),
        ),
    }
}

/// The expected numbers of a trial: those of the closed form, or those of another trial.
fn numbers(
    trial: &Trial,
    run: &ComputedTrial,
    other: Option<&ComputedTrial>,
) -> Vec<CheckedNumber> {
    let here = rows(trial, run);
    match (&trial.same_as, other) {
        (None, _) => here.cloned().filter_map(by_closed_form).collect(),
        (Some(name), Some(other)) => {
            let pairs = here.cloned().zip(rows(trial, other));
            let share = trial.same_rel.unwrap_or(0.0);
            pairs
                .filter_map(|(row, twin)| by_twin(row, twin, share, name))
                .collect()
        }
        (Some(_), None) => Vec::new(),
    }
}

/// The published values that a trial names; without names, those of the file itself.
fn rows<'r>(trial: &Trial, run: &'r ComputedTrial) -> impl Iterator<Item = &'r ValidationRow> {
    run.rows.iter().filter(|row| match &trial.rows {
        Some(names) => names.contains(&row.name),
        None => row.at.is_none() && !row.of_trials,
    })
}

fn by_closed_form(row: ValidationRow) -> Option<CheckedNumber> {
    Some(CheckedNumber {
        expected: row.published?,
        computed: row.computed,
        tolerance: row.tolerance?,
        name: row.name,
        unit: row.unit,
        source: row.source,
    })
}

fn by_twin(
    row: ValidationRow,
    twin: &ValidationRow,
    share: f64,
    name: &str,
) -> Option<CheckedNumber> {
    let expected = twin.computed?;
    Some(CheckedNumber {
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
pub struct TrialTally {
    /// Right.
    pub ok: usize,
    /// Refused with a reason, as expected.
    pub refused: usize,
    /// Refused with a reason where a number is expected.
    pub refused_too_much: usize,
    /// Wrong.
    pub wrong: usize,
}

/// Counts trials by outcome.
#[must_use]
pub fn tally(findings: &[TrialVerdict]) -> TrialTally {
    let mut tally = TrialTally::default();
    for finding in findings {
        *match finding.outcome {
            TrialOutcome::Ok => &mut tally.ok,
            TrialOutcome::Refused if finding.expect_refusal => &mut tally.refused,
            TrialOutcome::Refused => &mut tally.refused_too_much,
            TrialOutcome::Wrong => &mut tally.wrong,
        } += 1;
    }
    tally
}

impl TrialTally {
    /// True when every outcome is the expected one.
    #[must_use]
    pub const fn holds(&self) -> bool {
        self.wrong == 0 && self.refused_too_much == 0
    }
}

impl std::fmt::Display for TrialTally {
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
