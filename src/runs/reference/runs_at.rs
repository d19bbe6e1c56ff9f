//! The results of runs of a line case by name, at the points of its studies.

use super::stated::{ComparedRun, ResultsAt, ended};
use crate::case::{ChannelId, LineQuantity, Statistic, StudyPoint};
use crate::published::ComputedNumber;
use crate::run::{Channel, Profile, Quantity, QuantityId, Run, Subject, along_line};

/// What gives the run of a point.
pub(super) type RunLookup<'l, 'r> = dyn Fn(Option<&StudyPoint>) -> Option<&'r Run> + 'l;

/// The runs of a case at points of its studies.
pub(super) struct RunsAt<'l, 'r>(pub &'l RunLookup<'l, 'r>);

impl ResultsAt for RunsAt<'_, '_> {
    fn unit(&self, name: &str) -> String {
        let id = name.parse::<QuantityId>();
        id.map_or_else(|_| String::new(), |id| id.unit())
    }

    fn number(&self, at: Option<&StudyPoint>, name: &str) -> Result<ComputedNumber, String> {
        let run = self.0(at).ok_or_else(|| NOT_RUN.to_owned())?;
        let id = name.parse::<QuantityId>().map_err(|why| why.to_string())?;
        find(run, &id).map(Quantity::computed)
    }

    fn run(&self, at: Option<&StudyPoint>) -> Result<ComparedRun<'_>, String> {
        let run = self.0(at).ok_or_else(|| NOT_RUN.to_owned())?;
        ComparedRun::of_run(run)
    }
}

/// Why a row has no number, where nothing was computed at its point.
pub const NOT_RUN: &str = "This variant of the case has not been run.";

/// The number in a run, or why it is not there.
fn find<'r>(run: &'r Run, id: &QuantityId) -> Result<&'r Quantity, String> {
    ended(run.info.state, run.info.failure.as_deref())?;
    let found = run.summary.iter().find(|q| q.id == *id);
    let quantity = found.ok_or_else(|| missing(run, id))?;
    if quantity.value.is_finite() {
        Ok(quantity)
    } else {
        Err(format!("The run gives no finite value for `{id}`."))
    }
}

fn missing(run: &Run, id: &QuantityId) -> String {
    let (subject, _) = id.parts();
    match &subject {
        _ if let Some((quantity, line)) = subject.line_quantity() => {
            along(run, (quantity, line), id)
        }
        Subject::Channel(channel) if run.history.channels.iter().all(|c| c.id != *channel) => {
            no_channel(run, channel)
        }
        _ => format!("The summary of the run does not hold `{id}`."),
    }
}

/// Why a number along a line is missing.
fn along(run: &Run, (quantity, line): (LineQuantity, &str), id: &QuantityId) -> String {
    let none = Profile::default();
    let known = run.profiles.iter().find(|profile| profile.line == line);
    let profile = match known {
        None if !run.profiles.is_empty() => return format!("The run has no line `{line}`."),
        known => known.unwrap_or(&none),
    };
    if quantity.of_bending() && !profile.bends() {
        return format!("Nothing bends in this run, so it has no `{id}`.");
    }
    too_few(profile, quantity, id)
        .unwrap_or_else(|| format!("The summary of the run does not hold `{id}`."))
}

/// Why there is no n-th peak or valley, where there are fewer.
fn too_few(profile: &Profile, quantity: LineQuantity, id: &QuantityId) -> Option<String> {
    let QuantityId::Statistic {
        statistic,
        within,
        nth,
        ..
    } = id
    else {
        return None;
    };
    let name = quantity.name();
    let count = |statistic| along_line(profile, quantity, statistic, *within, None);
    let (count, what) = match statistic {
        Statistic::Peak => (count(Statistic::Peaks)?, "peaks"),
        Statistic::Valley => (
            count(Statistic::Turns)? - count(Statistic::Peaks)?,
            "valleys",
        ),
        _ => return None,
    };
    nth.is_some_and(|nth| nth as f64 > count)
        .then(|| format!("`{name}` has {count} {what} there, so there is no `{id}`."))
}

fn no_channel(run: &Run, channel: &ChannelId) -> String {
    let known: Vec<String> = run.history.channels.iter().map(Channel::name).collect();
    format!(
        "The run has no channel `{channel}`; it has {}.",
        known.join(", ")
    )
}
