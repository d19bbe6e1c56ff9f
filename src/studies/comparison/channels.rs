//! Extremes of channels over every step, and how far their histories are apart.

use super::curves::{CurveDifference, difference};
use crate::case::ChannelId;
use crate::run::{Channel, Run};

/// A channel in each run.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedChannel {
    /// What identifies it.
    pub id: ChannelId,
    /// Its extremes in each run; absent where a run has no such channel.
    pub extremes: Vec<Option<ChannelExtremes>>,
    /// Each run's history less that of the first run; absent for the first run itself and where either is missing.
    pub differences: Vec<Option<CurveDifference>>,
}

/// Extremes of a channel over every step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChannelExtremes {
    /// Greatest value and its time \[s\].
    pub max: (f64, f64),
    /// Smallest value and its time \[s\].
    pub min: (f64, f64),
}

/// Every channel that any of the runs has, in the order in which the runs have them.
pub(super) fn compare(runs: &[&Run]) -> Vec<ComparedChannel> {
    let mut ids: Vec<&ChannelId> = Vec::new();
    for channel in runs.iter().flat_map(|run| &run.history.channels) {
        if !ids.contains(&&channel.id) {
            ids.push(&channel.id);
        }
    }
    ids.into_iter().map(|id| compared(runs, id)).collect()
}

fn compared(runs: &[&Run], id: &ChannelId) -> ComparedChannel {
    let extremes = runs.iter().map(|run| {
        let found = run.history.channels.iter().find(|c| c.id == *id);
        found.map(|channel: &Channel| ChannelExtremes {
            max: channel.peak,
            min: channel.trough,
        })
    });
    let others = runs.iter().skip(1);
    let differences = others.map(|run| difference(&runs[0].history, &run.history, id));
    ComparedChannel {
        id: id.clone(),
        extremes: extremes.collect(),
        differences: std::iter::once(None).chain(differences).collect(),
    }
}
