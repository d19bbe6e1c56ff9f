//! Stored runs compared: inputs and settings that differ, every result with difference and error bars, channels, published values,
//! cost; difference curves and shapes at a common time.
//!
//! Every difference is from the first run. [`Comparison::of_runs`] only reads its runs;
//! `report::comparison` shows it.

mod agreement;
mod channels;
mod curves;
mod inputs;
mod results;
mod settings;
mod shapes;
mod validation;

pub use agreement::{Agreement, ResultChange, change, error_bar, is_beyond_error};
pub use channels::{ChannelExtremes, ComparedChannel};
pub use curves::{CurveDifference, difference, differences, points_less};
pub use inputs::{ComparedInput, InputValue};
pub use results::ComparedResult;
pub use settings::ComparedSetting;
pub use shapes::{common_times, distances, shape_at, shapes_at};
pub use validation::ComparedRow;

use crate::run::{Run, RunInfo, RunState};

/// Runs compared with the first of them. Every list of values has one entry a run, in the order of the runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// What each run is.
    pub runs: Vec<RunInfo>,
    /// Inputs that differ.
    pub inputs: Vec<ComparedInput>,
    /// Version, file and settings that differ.
    pub settings: Vec<ComparedSetting>,
    /// Work and cost, all of it.
    pub cost: Vec<ComparedSetting>,
    /// Every result that any of the runs has.
    pub results: Vec<ComparedResult>,
    /// Every channel that any of the runs has.
    pub channels: Vec<ComparedChannel>,
    /// Published values of the cases.
    pub validation: Vec<ComparedRow>,
    /// What the reader must know, with the letter of the run.
    pub notes: Vec<String>,
}

impl Comparison {
    /// Compares runs with the first of them.
    #[must_use]
    pub fn of_runs(runs: &[&Run]) -> Self {
        let infos: Vec<RunInfo> = runs.iter().map(|run| run.info.clone()).collect();
        let mut notes: Vec<String> = infos.iter().enumerate().filter_map(state).collect();
        let (inputs, unreadable) = inputs::compare(runs);
        notes.extend(unreadable);
        Self {
            inputs,
            settings: settings::differing(&infos),
            cost: settings::cost(&infos),
            results: results::compare(runs),
            channels: channels::compare(runs),
            validation: validation::compare(runs),
            runs: infos,
            notes,
        }
    }

    /// How many results there are of each agreement, those of all runs but the first together.
    #[must_use]
    pub fn tally(&self) -> Vec<(Agreement, usize)> {
        let all = || {
            let changes = self.results.iter().flat_map(|result| &result.changes);
            changes.filter_map(Option::as_ref)
        };
        let count = |agreement| all().filter(|change| change.agreement == agreement).count();
        let counts = Agreement::ALL.map(|agreement| (agreement, count(agreement)));
        counts.into_iter().filter(|(_, count)| *count > 0).collect()
    }
}

/// The letter of a run: A for the first; beyond Z its number.
#[must_use]
pub fn letter(index: usize) -> String {
    let letters = ('A'..='Z').nth(index);
    letters.map_or_else(|| format!("R{}", index + 1), String::from)
}

/// That a run is not complete, and why.
fn state((index, info): (usize, &RunInfo)) -> Option<String> {
    let why = match info.state {
        RunState::Done => return None,
        RunState::Partial => "is partial: it has no results of the whole run".to_owned(),
        RunState::Cancelled => "was cancelled before its end".to_owned(),
        RunState::Failed => {
            let why = info.failure.as_deref().unwrap_or("no reason was given");
            format!("failed: {why}")
        }
    };
    Some(format!("{} {why}", letter(index)))
}
