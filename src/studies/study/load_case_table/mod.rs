//! The load cases of a sweep as a table for a screen: the axes that they span, results with their numerical errors, what became of each.
//!
//! Plain data, made once behind the screen. A [`HeatMap`] of two axes follows from it by a walk over the load cases.

mod axes;
mod heat_map;

use std::path::PathBuf;

pub use axes::LoadCaseAxis;
pub use heat_map::{HeatCell, HeatMap, HeatMapChoice, Reduction};

use crate::case::QuantityId;
use crate::run::RunState;
use crate::study::points::PointOutcome;
use crate::study::seas::{CheckResult, SeaResults};
use crate::study::sweep::{SnapshotOutcomes, SweepSnapshot};
use crate::study::vary::system::SystemOutcome;
use crate::system::quantities::unit;

/// The load cases of a sweep.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoadCaseTable {
    /// What differs among the load cases.
    pub axes: Vec<LoadCaseAxis>,
    /// The results.
    pub columns: Vec<LoadCaseColumn>,
    /// What became of each load case.
    pub states: Vec<LoadCaseState>,
    /// The directory of the run of each load case; nothing of those without one.
    pub dirs: Vec<Option<PathBuf>>,
    /// Probability of each load case, where it is known.
    pub probability: Option<Vec<f64>>,
}

/// A result at all load cases.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoadCaseColumn {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Its value at each load case; nothing where there is none.
    pub values: Vec<Option<ResultValue>>,
}

/// A result at a load case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResultValue {
    /// Its value, in the unit of the column.
    pub value: f64,
    /// Its numerical error, in the same unit; nothing where it was not estimated.
    pub error: Option<f64>,
}

/// What became of a load case.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum LoadCaseState {
    /// It has no run.
    #[default]
    Open,
    /// Its run has begun and is not done: it is being computed, or was stopped.
    Begun,
    /// It is done.
    Done,
    /// Its computation failed, for this reason.
    Failed(String),
    /// The case refuses it, or its run cannot be read, for this reason.
    Refused(String),
}

impl LoadCaseState {
    /// Its word.
    #[must_use]
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Open => "not computed",
            Self::Begun => "not done",
            Self::Done => "done",
            Self::Failed(_) => "failed",
            Self::Refused(_) => "refused",
        }
    }

    /// Why there are no results, where there is a reason.
    #[must_use]
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::Failed(why) | Self::Refused(why) => Some(why),
            _ => None,
        }
    }

    fn of_run(outcome: &PointOutcome) -> Self {
        match outcome {
            Err(why) => Self::Refused(why.clone()),
            Ok(run) => match run.info.state {
                RunState::Done => Self::Done,
                RunState::Failed => Self::Failed(run.failure().unwrap_or_default().to_owned()),
                RunState::Cancelled | RunState::Partial => Self::Begun,
            },
        }
    }
}

impl LoadCaseTable {
    /// The load cases of a sweep as it is.
    #[must_use]
    pub fn of_snapshot(snapshot: &SweepSnapshot) -> Self {
        let variation = &snapshot.plan.sweep.variation;
        let mut table = Self {
            axes: axes::axes(variation),
            probability: variation.probability.clone(),
            ..Self::default()
        };
        match &snapshot.found {
            SnapshotOutcomes::Runs(runs, ids) => {
                let found = || runs.iter().map(|run| run.as_deref());
                table.states = found()
                    .map(|run| run.map_or_else(LoadCaseState::default, LoadCaseState::of_run))
                    .collect();
                table.dirs = found().map(|run| run?.as_ref().ok()?.dir.clone()).collect();
                let column = |id: &QuantityId| LoadCaseColumn {
                    name: id.to_string(),
                    unit: id.unit(),
                    values: found()
                        .map(|run| {
                            let found = run?.as_ref().ok()?.result(id)?;
                            Some(ResultValue {
                                value: found.value,
                                error: found.error_estimate(),
                            })
                        })
                        .collect(),
                };
                table.columns = ids.iter().map(column).collect();
            }
            SnapshotOutcomes::AtRest(all, names) => {
                table.states = all.iter().map(at_rest).collect();
                table.dirs = vec![None; all.len()];
                let columns = names.iter().enumerate();
                table.columns = columns
                    .map(|(place, name)| LoadCaseColumn {
                        name: name.clone(),
                        unit: unit(name).to_owned(),
                        values: all.iter().map(|found| rest_value(found, place)).collect(),
                    })
                    .collect();
            }
        }
        table
    }

    /// Load cases that have results.
    #[must_use]
    pub fn done(&self) -> usize {
        let states = self.states.iter();
        states
            .filter(|state| **state == LoadCaseState::Done)
            .count()
    }

    /// Load cases that have ended without results.
    #[must_use]
    pub fn failed(&self) -> usize {
        let states = self.states.iter();
        states.filter(|state| state.reason().is_some()).count()
    }

    /// What is set at a load case, in words.
    #[must_use]
    pub fn words(&self, load_case: usize) -> String {
        let axes = self.axes.iter();
        let words = axes.filter_map(|axis| Some(axis.words(axis.place(load_case)?)));
        words.collect::<Vec<_>>().join(", ")
    }
}

/// The share of its limit that each check uses, as results of the load cases: of each the greatest of its sea. Checks of all seas
/// together, such as fatigue, have none.
#[must_use]
pub fn used_columns(results: &SeaResults, load_cases: usize) -> Vec<LoadCaseColumn> {
    let column = |check: &CheckResult| {
        let mut of_seas: Vec<Option<ResultValue>> = vec![None; results.seas.len()];
        for row in &check.rows {
            let Some(slot) = row.sea.and_then(|sea| of_seas.get_mut(sea)) else {
                continue;
            };
            let used = &row.used;
            let error = |[low, high]: [f64; 2]| f64::max(high - used.value, used.value - low);
            if slot.is_none_or(|known| known.value < used.value) {
                *slot = Some(ResultValue {
                    value: used.value,
                    error: used.numerical.map(error),
                });
            }
        }
        let mut values = vec![None; load_cases];
        for (sea, used) in results.seas.iter().zip(&of_seas) {
            for load_case in &sea.load_cases {
                if let Some(value) = values.get_mut(*load_case) {
                    *value = *used;
                }
            }
        }
        let any = of_seas.iter().any(Option::is_some);
        any.then(|| LoadCaseColumn {
            name: format!("used: {}", check.check.name),
            unit: String::new(),
            values,
        })
    };
    results.checks.iter().filter_map(column).collect()
}

fn at_rest(found: &Option<SystemOutcome>) -> LoadCaseState {
    match found {
        None => LoadCaseState::Open,
        Some(Ok(_)) => LoadCaseState::Done,
        Some(Err(why)) => LoadCaseState::Refused(why.clone()),
    }
}

fn rest_value(found: &Option<SystemOutcome>, place: usize) -> Option<ResultValue> {
    let point = found.as_ref()?.as_ref().ok()?;
    let result = point.results.get(place)?.as_ref().ok()?;
    Some(ResultValue {
        value: result.value,
        error: result.error,
    })
}
