//! The channels and the lines of a run over all of it.

use crate::case::{ChannelId, QuantityId, Statistic, Subject};
use crate::run::Quantity;
use crate::run::observer::RunRecord;
use crate::run::requested_statistics::{RequestedStatistic, StatisticSource};

/// A channel of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelResult {
    /// Its name.
    pub id: ChannelId,
    /// Over the whole run.
    pub summary: ChannelSummary,
    /// Least and greatest value after the start that checks leave out; nothing where none is.
    pub settled: Option<[f64; 2]>,
    /// Errors of the least, greatest, mean and last value by the time steps; nothing where they are not estimated.
    pub time_error: Option<[f64; 4]>,
    /// The same by the mesh.
    pub mesh_error: Option<[f64; 4]>,
}

/// A channel over the whole run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChannelSummary {
    /// Least value at the steps and between them, and its time \[s\].
    pub least: (f64, f64),
    /// Greatest value at the steps and between them, and its time \[s\].
    pub greatest: (f64, f64),
    /// Mean over time.
    pub mean: f64,
    /// Last value.
    pub last: f64,
}

impl ChannelSummary {
    /// Least, greatest, mean and last value.
    #[must_use]
    pub fn numbers(&self) -> [f64; 4] {
        [self.least.0, self.greatest.0, self.mean, self.last]
    }
}

impl ChannelResult {
    /// All channels of a record.
    pub(super) fn of(record: &RunRecord) -> Vec<Self> {
        let channels = record.history.channels.iter().enumerate();
        channels
            .map(|(number, channel)| {
                let taken = |statistic, in_window: bool| {
                    let mut all = record.statistics.iter();
                    let found = all.find(|(wanted, _)| {
                        wanted.of == StatisticSource::Channel(number)
                            && wanted.statistic == statistic
                            && wanted.window.is_some() == in_window
                    });
                    found.and_then(|(_, value)| *value)
                };
                let whole = |statistic| taken(statistic, false).unwrap_or(f64::NAN);
                let least = taken(Statistic::Min, true);
                Self {
                    id: channel.id.clone(),
                    summary: ChannelSummary {
                        least: channel.trough,
                        greatest: channel.peak,
                        mean: whole(Statistic::Mean),
                        last: whole(Statistic::Final),
                    },
                    settled: least
                        .zip(taken(Statistic::Max, true))
                        .map(|(least, greatest)| [least, greatest]),
                    time_error: None,
                    mesh_error: None,
                }
            })
            .collect()
    }
}

/// The extremes along the lines of a record, without errors.
pub(super) fn along_lines(record: &RunRecord) -> Vec<Quantity> {
    let quantity = |(wanted, value): &(RequestedStatistic, Option<f64>)| {
        let StatisticSource::Line(number, quantity) = wanted.of else {
            return None;
        };
        let line = record.profiles.get(number)?;
        let of = Subject::along(quantity, &line.line);
        let id = QuantityId::new(of, wanted.statistic, wanted.window);
        Some(Quantity::new(id, (*value)?))
    };
    record.statistics.iter().filter_map(quantity).collect()
}
