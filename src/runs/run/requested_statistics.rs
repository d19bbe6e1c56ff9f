//! The statistics that a run computes of its channels and of the whole line.

use super::Subject;
use super::line_statistics;
use crate::case::{
    Case, ChannelQuantity, ChannelSpec, LineQuantity, Method, QuantityId, Statistic,
};
use crate::checks::resolved::held_along;

/// What a number is taken of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StatisticSource {
    /// The channel of this index.
    Channel(usize),
    /// A quantity of a whole line, by its number.
    Line(usize, LineQuantity),
}

/// A statistic of a channel or of the whole line.
#[derive(Debug, Clone, PartialEq)]
pub struct RequestedStatistic {
    /// What it is taken of.
    pub of: StatisticSource,
    /// What is taken of it.
    pub statistic: Statistic,
    /// Over which window of time \[s\] or, of the whole line, which stretch \[m\]; absent: all of it.
    pub window: Option<[f64; 2]>,
    /// Which of several, of peaks and valleys.
    pub nth: Option<usize>,
}

/// What a run of this case summarises: the greatest, smallest, mean and last value of every channel, the extremes of
/// the whole line, those of what checks compare after the start that they leave out, and every statistic its published values and
/// trends ask for.
#[must_use]
pub fn requested(case: &Case, channels: &[ChannelSpec]) -> Vec<RequestedStatistic> {
    let mut list: Vec<RequestedStatistic> = of_channels(channels.len()).collect();
    list.extend(of_lines(1));
    // The start of a record over time is left out where the case says so.
    let moves = case.solver.method != Method::Static;
    let window = case.statistics.settled_window(case.solver.duration_s);
    let quantities = channels.iter().map(|channel| channel.id.quantity);
    list.extend(settled(quantities, window.filter(|_| moves)));
    let published = case.published.iter();
    let published = published
        .map(|p| QuantityId::new(p.channel.clone(), p.statistic, p.within()).numbered(p.nth));
    let trends = case.trend.iter();
    let trends =
        trends.map(|t| QuantityId::new(t.channel.clone(), t.statistic, t.within()).numbered(t.nth));
    let others = case.published.iter();
    let others = others.filter_map(|p| {
        let stretch = Some(p.by_stretch_m?);
        Some(QuantityId::new(p.channel.clone(), p.statistic, stretch).numbered(p.nth))
    });
    let held = held_along(&case.checks, &case.files, [""]);
    let all: Vec<QuantityId> = published.chain(others).chain(trends).chain(held).collect();
    let source = |subject: &Subject| match subject {
        Subject::Channel(id) => {
            let index = channels.iter().position(|channel| channel.id == *id);
            index.map(StatisticSource::Channel)
        }
        Subject::Line(quantity) => Some(StatisticSource::Line(0, *quantity)),
        _ => None,
    };
    add_stated(&mut list, &all, source);
    list
}

/// Adds the statistics that published values and trends of a file are of; what `source` knows no part of the run for is left out.
pub fn add_stated(
    list: &mut Vec<RequestedStatistic>,
    stated: &[QuantityId],
    source: impl Fn(&Subject) -> Option<StatisticSource>,
) {
    for id in stated {
        let QuantityId::Statistic {
            of,
            statistic,
            within,
            nth,
        } = id
        else {
            continue;
        };
        let Some(of) = source(of) else {
            continue;
        };
        let item = RequestedStatistic {
            of,
            statistic: *statistic,
            window: *within,
            nth: *nth,
        };
        if !list.contains(&item) {
            list.push(item);
        }
    }
}

/// The greatest, smallest, mean and last value of so many channels over the whole run.
pub fn of_channels(channels: usize) -> impl Iterator<Item = RequestedStatistic> {
    use Statistic::{Final, Max, Mean, Min};
    (0..channels).flat_map(|channel| {
        [Max, Min, Mean, Final].map(|s| whole(StatisticSource::Channel(channel), s))
    })
}

/// The extremes along so many lines.
pub fn of_lines(lines: usize) -> impl Iterator<Item = RequestedStatistic> {
    (0..lines).flat_map(|line| {
        line_statistics::ALWAYS
            .map(|(quantity, statistic)| whole(StatisticSource::Line(line, quantity), statistic))
    })
}

const fn whole(of: StatisticSource, statistic: Statistic) -> RequestedStatistic {
    RequestedStatistic {
        of,
        statistic,
        window: None,
        nth: None,
    }
}

/// The extremes of what checks compare within a window of time \[s\] that leaves out the start of a record.
pub fn settled(
    channels: impl Iterator<Item = ChannelQuantity>,
    window: Option<[f64; 2]>,
) -> impl Iterator<Item = RequestedStatistic> {
    let checked = channels.enumerate().filter(move |(_, quantity)| {
        window.is_some() && ChannelQuantity::CHECKED.contains(quantity)
    });
    checked.flat_map(move |(channel, _)| {
        [Statistic::Max, Statistic::Min].map(|statistic| RequestedStatistic {
            of: StatisticSource::Channel(channel),
            statistic,
            window,
            nth: None,
        })
    })
}
