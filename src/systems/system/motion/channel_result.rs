//! The channels of a run over all of it.

use crate::case::{ChannelId, QuantityId, Statistic, Subject};
use crate::run::{Channel, Quantity};

/// A channel of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelResult {
    /// Its name.
    pub id: ChannelId,
    /// Over the whole run.
    pub summary: RunChannelSummary,
    /// Least and greatest value after the start that checks leave out; nothing where none is.
    pub settled: Option<[f64; 2]>,
    /// Errors of the least, greatest, mean and last value by the time steps; nothing where they are not estimated.
    pub time_error: Option<[f64; 4]>,
    /// The same by the mesh.
    pub mesh_error: Option<[f64; 4]>,
}

/// A channel over the whole run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunChannelSummary {
    /// Least value at the steps and between them, and its time \[s\].
    pub least: (f64, f64),
    /// Greatest value at the steps and between them, and its time \[s\].
    pub greatest: (f64, f64),
    /// Mean over time.
    pub mean: f64,
    /// Last value.
    pub last: f64,
}

impl RunChannelSummary {
    /// Least, greatest, mean and last value.
    #[must_use]
    pub fn numbers(&self) -> [f64; 4] {
        [self.least.0, self.greatest.0, self.mean, self.last]
    }
}

/// The statistics of every channel: least, greatest, mean and last value.
pub const STATISTICS: [Statistic; 4] = [
    Statistic::Min,
    Statistic::Max,
    Statistic::Mean,
    Statistic::Final,
];

impl ChannelResult {
    /// Of a channel, by the single numbers of its run that are of it.
    pub(super) fn of_channel(channel: &Channel, own: &[&Quantity]) -> Self {
        let of_statistic = |wanted: Statistic, in_window: bool| {
            let is = |q: &&&Quantity| {
                matches!(&q.id, QuantityId::Statistic { statistic, within, .. }
                    if *statistic == wanted && within.is_some() == in_window)
            };
            own.iter().find(is).copied()
        };
        let whole = STATISTICS.map(|statistic| of_statistic(statistic, false));
        let value = |found: Option<&Quantity>| found.map_or(f64::NAN, |q| q.value);
        let errors = |of: fn(&Quantity) -> Option<f64>| {
            let mut errors = [0.0; STATISTICS.len()];
            for (error, found) in errors.iter_mut().zip(whole) {
                *error = of(found?)?;
            }
            Some(errors)
        };
        let settled = [Statistic::Min, Statistic::Max].map(|of| of_statistic(of, true));
        let [least, greatest] = settled.map(|found| found.map(|q| q.value));
        Self {
            id: channel.id.clone(),
            summary: RunChannelSummary {
                least: channel.trough,
                greatest: channel.peak,
                mean: value(whole[2]),
                last: value(whole[3]),
            },
            settled: least
                .zip(greatest)
                .map(|(least, greatest)| [least, greatest]),
            time_error: errors(|q| q.time_error),
            mesh_error: errors(|q| q.mesh_error),
        }
    }

    /// All channels of a run, by its single numbers.
    pub(super) fn all(channels: &[Channel], summary: &[Quantity]) -> Vec<Self> {
        let mut by_name: std::collections::HashMap<String, Vec<&Quantity>> =
            std::collections::HashMap::new();
        for quantity in summary {
            if let QuantityId::Statistic {
                of: Subject::Channel(id),
                ..
            } = &quantity.id
            {
                by_name.entry(id.to_string()).or_default().push(quantity);
            }
        }
        let own = |channel: &Channel| by_name.get(&channel.id.to_string());
        let result = |channel| Self::of_channel(channel, own(channel).map_or(&[], Vec::as_slice));
        channels.iter().map(result).collect()
    }
}
