//! The statistics that a run computes of its channels and of the whole line.

use super::Subject;
use super::line_statistics;
use crate::case::{Case, ChannelQuantity, ChannelSpec, LineQuantity, Method, Statistic};

/// What a number is taken of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StatisticSource {
    /// The channel of this index.
    Channel(usize),
    /// A quantity of the whole line.
    Line(LineQuantity),
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
    use Statistic::{Final, Max, Mean, Min};
    let whole = |of, statistic| RequestedStatistic {
        of,
        statistic,
        window: None,
        nth: None,
    };
    let mut list: Vec<RequestedStatistic> = (0..channels.len())
        .flat_map(|channel| {
            [Max, Min, Mean, Final].map(|s| whole(StatisticSource::Channel(channel), s))
        })
        .collect();
    list.extend(
        line_statistics::ALWAYS
            .map(|(quantity, statistic)| whole(StatisticSource::Line(quantity), statistic)),
    );
    list.extend(settled(case, channels));
    let published = case
        .published
        .iter()
        .map(|p| (&p.channel, p.statistic, p.within(), p.nth));
    let trends = case
        .trend
        .iter()
        .map(|t| (&t.channel, t.statistic, t.within(), t.nth));
    let others = case.published.iter();
    let others = others.filter_map(|p| {
        let stretch = Some(p.by_stretch_m?);
        Some((&p.channel, p.statistic, stretch, p.nth))
    });
    for (subject, statistic, window, nth) in published.chain(others).chain(trends) {
        let of = match subject {
            Subject::Channel(id) => {
                let index = channels.iter().position(|channel| channel.id == *id);
                index.map(StatisticSource::Channel)
            }
            Subject::Line(quantity) => Some(StatisticSource::Line(*quantity)),
            _ => None,
        };
        let Some(of) = of else {
            continue;
        };
        let item = RequestedStatistic {
            of,
            statistic,
            window,
            nth,
        };
        if !list.contains(&item) {
            list.push(item);
        }
    }
    list
}

/// The extremes of what checks compare after `statistics.from_s`, where that leaves out the start of a record over time.
fn settled<'a>(
    case: &Case,
    channels: &'a [ChannelSpec],
) -> impl Iterator<Item = RequestedStatistic> + 'a {
    let moves = case.solver.method != Method::Static;
    let window = case.statistics.settled_window(case.solver.duration_s);
    let window = window.filter(|_| moves);
    let checked = channels.iter().enumerate().filter(move |(_, channel)| {
        window.is_some() && ChannelQuantity::CHECKED.contains(&channel.id.quantity)
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
