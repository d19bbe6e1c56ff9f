//! Statistics of channels computed while a run goes on, without its history: means, extremes, times. They are those of every
//! accepted step and of what lies between, whatever is written. Statistics that need a value known only at the end (the last
//! value, the mean) read the rows of the record a second time, from a [`SpillBuffer`].

use serde::{Deserialize, Serialize};

use super::requested_statistics::{RequestedStatistic, StatisticSource};
use super::spill_buffer::SpillBuffer;
use super::step_interval::{Arc, StepInterval};
use super::{Channel, Profile, cycles, line_statistics};
use crate::case::Statistic;

/// Takes in every step and every row of the record, and computes the requested statistics at the end.
#[derive(Debug)]
pub(super) struct ChannelStatistics {
    wanted: Vec<RequestedStatistic>,
    /// One for each channel and window that any of them is of.
    series: Vec<WindowSamples>,
    /// The time of the last step \[s\].
    end: f64,
    warnings: Vec<String>,
}

/// A channel within a window of time.
#[derive(Debug)]
struct WindowSamples {
    channel: usize,
    window: Option<[f64; 2]>,
    summary: Option<SampleSummary>,
    samples: Option<SpillBuffer>,
}

/// A channel after one reading; samples and extremes are (value, time).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct SampleSummary {
    first: (f64, f64),
    last: (f64, f64),
    low: (f64, f64),
    high: (f64, f64),
    /// Integral over time.
    area: f64,
}

/// What is known of a channel within a window, in a checkpoint.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct ChannelSummary {
    #[serde(skip_serializing_if = "Option::is_none")]
    summary: Option<SampleSummary>,
}

impl ChannelStatistics {
    /// For these numbers.
    pub(super) fn new(wanted: Vec<RequestedStatistic>) -> Self {
        let mut series: Vec<WindowSamples> = Vec::new();
        for w in &wanted {
            let StatisticSource::Channel(channel) = w.of else {
                continue;
            };
            let samples = reads_twice(w.statistic).then(SpillBuffer::default);
            let same = |s: &&mut WindowSamples| s.channel == channel && s.window == w.window;
            match series.iter_mut().find(same) {
                Some(known) => known.samples = known.samples.take().or(samples),
                None => series.push(WindowSamples {
                    channel,
                    window: w.window,
                    summary: None,
                    samples,
                }),
            }
        }
        Self {
            wanted,
            series,
            end: f64::NEG_INFINITY,
            warnings: Vec::new(),
        }
    }

    /// Takes in what lies between two steps.
    pub(super) fn interval(&mut self, between: &StepInterval<'_>) {
        self.end = between.time()[1];
        for series in &mut self.series {
            if series.channel >= between.channels() {
                continue;
            }
            if let Some(arc) = between.channel(series.channel).within(series.window) {
                match &mut series.summary {
                    Some(summary) => summary.add(&arc),
                    none => *none = Some(SampleSummary::of_arc(&arc)),
                }
            }
        }
    }

    /// Takes in a row. Samples for which there is no room on disk are dropped, with their statistics and a warning.
    pub(super) fn row(&mut self, time: f64, values: &[f64]) {
        self.end = self.end.max(time);
        for series in &mut self.series {
            let Some(value) = values.get(series.channel).copied() else {
                continue;
            };
            if !within(series.window, time) {
                continue;
            }
            // The start, or the single state of a line at rest.
            let first = || SampleSummary::at((value, time));
            series.summary.get_or_insert_with(first);
            let kept = series
                .samples
                .as_mut()
                .map(|samples| samples.push(time, value));
            if let Some(Err(error)) = kept {
                series.samples = None;
                self.warnings.push(format!(
                    "settling times, rise times and mean peaks are incomplete: there is no room on disk for their samples ({error})"
                ));
            }
        }
    }

    /// How many channels and windows it is of.
    pub(super) fn series(&self) -> usize {
        self.series.len()
    }

    /// What is known of each series, for a checkpoint.
    pub(super) fn summaries(&self) -> Vec<ChannelSummary> {
        let known = |series: &WindowSamples| ChannelSummary {
            summary: series.summary,
        };
        self.series.iter().map(known).collect()
    }

    /// Continues from a checkpoint.
    pub(super) fn restore(&mut self, known: &[ChannelSummary], time: f64) {
        for (series, known) in self.series.iter_mut().zip(known) {
            series.summary = known.summary;
        }
        self.end = time;
    }

    /// The statistics, and warnings. A statistic is `None` where its window holds no output time, the run ended before the
    /// window does, or nothing of the kind was recorded. Extremes over a whole run are those of every step, from `channels`.
    pub(super) fn finish(
        self,
        channels: &[Channel],
        profiles: &[Profile],
    ) -> (Vec<(RequestedStatistic, Option<f64>)>, Vec<String>) {
        let number = |w: &RequestedStatistic| match w.of {
            StatisticSource::Channel(index) => self.over_time(index, channels.get(index)?, w),
            StatisticSource::Line(number, quantity) => {
                let profile = profiles.get(number)?;
                line_statistics::evaluate(profile, quantity, w.statistic, w.window, w.nth)
            }
        };
        let statistics = self.wanted.iter().map(|w| (w.clone(), number(w)));
        (statistics.collect(), self.warnings)
    }

    fn over_time(
        &self,
        index: usize,
        channel: &Channel,
        wanted: &RequestedStatistic,
    ) -> Option<f64> {
        let same = |s: &&WindowSamples| s.channel == index && s.window == wanted.window;
        let series = self.series.iter().find(same)?;
        if wanted
            .window
            .is_some_and(|[_, to]| self.end < to - slop(to))
        {
            return None;
        }
        let summary = series.summary?;
        let (greatest, smallest) = match wanted.window {
            None => (channel.peak, channel.trough),
            Some(_) => (summary.high, summary.low),
        };
        let span = summary.last.1 - summary.first.1;
        match wanted.statistic {
            Statistic::Mean => Some(summary.mean()),
            Statistic::Max => Some(greatest.0),
            Statistic::Min => Some(smallest.0),
            Statistic::Final => Some(summary.last.0),
            Statistic::Travel => Some(summary.first.0 - smallest.0),
            Statistic::TimeOfMax => Some(greatest.1),
            Statistic::TimeOfMin => Some(smallest.1),
            Statistic::Rate => {
                (span > 0.0).then(|| (summary.last.0 - summary.first.0).abs() / span)
            }
            Statistic::SettlingTime => summary.settling_time(series.samples.as_ref()?),
            Statistic::RiseTime => summary.rise_time(series.samples.as_ref()?),
            Statistic::MeanPeak => summary.mean_extreme(series.samples.as_ref()?, f64::max),
            Statistic::MeanTrough => summary.mean_extreme(series.samples.as_ref()?, f64::min),
            Statistic::ArcOfMax
            | Statistic::ArcOfMin
            | Statistic::GreatestFall
            | Statistic::Turns
            | Statistic::Peaks
            | Statistic::Peak
            | Statistic::Valley => None,
        }
    }
}

/// Whether a statistic needs a second reading of the samples.
pub(super) fn reads_twice(statistic: Statistic) -> bool {
    use Statistic::{MeanPeak, MeanTrough, RiseTime, SettlingTime};
    matches!(statistic, SettlingTime | RiseTime | MeanPeak | MeanTrough)
}

/// Output times are products of roundings: a window's edge belongs to it.
fn slop(to: f64) -> f64 {
    1e-9 * to.abs().max(1.0)
}

fn within(window: Option<[f64; 2]>, time: f64) -> bool {
    window.is_none_or(|[from, to]| time >= from - slop(to) && time <= to + slop(to))
}

impl SampleSummary {
    fn at(sample: (f64, f64)) -> Self {
        Self {
            first: sample,
            last: sample,
            low: sample,
            high: sample,
            area: 0.0,
        }
    }

    fn of_arc(arc: &Arc) -> Self {
        let mut summary = Self::at(arc.first());
        summary.add(arc);
        summary
    }

    fn add(&mut self, arc: &Arc) {
        self.area += arc.integral();
        self.last = arc.last();
        let (high, low) = (arc.greatest(), arc.smallest());
        if high.0 > self.high.0 {
            self.high = high;
        }
        if low.0 < self.low.0 {
            self.low = low;
        }
    }

    /// Mean over time; of no time, the value there.
    fn mean(&self) -> f64 {
        let span = self.last.1 - self.first.1;
        if span > 0.0 {
            self.area / span
        } else {
            self.first.0
        }
    }

    /// First time after which every value stays within 2 % of the whole range from the last one.
    fn settling_time(&self, samples: &SpillBuffer) -> Option<f64> {
        let band = 0.02 * (self.high.0 - self.low.0);
        let outside = |value: f64| (value - self.last.0).abs() - band;
        let mut settled = self.first.1;
        let mut before = None;
        let read = samples.each(|time, value| {
            let here = (time, outside(value));
            if let Some(before) = before.filter(|(_, y)| *y > 0.0) {
                settled = crossing(before, here);
            }
            before = Some(here);
        });
        read.ok().map(|()| settled)
    }

    /// First time at which nine tenths of the way from the first to the last value are made.
    fn rise_time(&self, samples: &SpillBuffer) -> Option<f64> {
        let way = self.last.0 - self.first.0;
        if way == 0.0 {
            return Some(self.first.1);
        }
        let missing = |value: f64| 0.9 - (value - self.first.0) / way;
        let mut risen = None;
        let mut before = None;
        let read = samples.each(|time, value| {
            let here = (time, missing(value));
            if risen.is_none() && here.1 <= 0.0 {
                risen = Some(before.map_or(time, |before| crossing(before, here)));
            }
            before = Some(here);
        });
        read.ok().and(risen)
    }

    /// Mean of the extremes that `pick` takes of whole cycles.
    fn mean_extreme(&self, samples: &SpillBuffer, pick: fn(f64, f64) -> f64) -> Option<f64> {
        let range = self.high.0 - self.low.0;
        let mut cycles = cycles::Cycles::new(self.mean(), range, pick);
        samples.each(|_, value| cycles.add(value)).ok()?;
        cycles.mean()
    }
}

/// Where the straight line between two points crosses zero.
fn crossing((t0, y0): (f64, f64), (t1, y1): (f64, f64)) -> f64 {
    if y0 == y1 {
        t1
    } else {
        t0 + (t1 - t0) * y0 / (y0 - y1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::ChannelQuantity;
    use crate::run::step_interval::LatestSteps;

    fn take(values: &[f64], statistic: Statistic, window: Option<[f64; 2]>) -> Option<f64> {
        let wanted = RequestedStatistic {
            of: StatisticSource::Channel(0),
            statistic,
            window,
            nth: None,
        };
        let mut of_channel = ChannelStatistics::new(vec![wanted]);
        let mut latest = LatestSteps::new(1, 0);
        for (i, value) in values.iter().enumerate() {
            let step = latest.next();
            (step.time, step.values[0]) = (i as f64, *value);
            of_channel.row(i as f64, &[*value]);
            if let Some(between) = latest.complete_interval(&[]) {
                of_channel.interval(&between);
            }
        }
        if let Some(between) = latest.last_interval(&[]) {
            of_channel.interval(&between);
        }
        let channel = Channel {
            peak: (9.0, 2.25),
            trough: (-9.0, 3.25),
            ..Channel::new(ChannelQuantity::X.at("body"))
        };
        let (statistics, warnings) = of_channel.finish(&[channel], &[]);
        assert_eq!(warnings, [""; 0]);
        statistics[0].1
    }

    #[test]
    fn mean_is_an_integral_and_windows_include_their_ends() {
        assert_eq!(take(&[0.0, 2.0, 4.0], Statistic::Mean, None), Some(2.0));
        assert_eq!(
            take(&[0.0, 2.0, 4.0, 100.0], Statistic::Mean, Some([0.0, 2.0])),
            Some(2.0)
        );
        assert_eq!(take(&[0.0, 2.0], Statistic::Mean, Some([0.0, 5.0])), None);
    }

    #[test]
    fn extremes_of_a_whole_run_are_those_of_every_step() {
        assert_eq!(take(&[1.0, 2.0, 0.0], Statistic::Max, None), Some(9.0));
        assert_eq!(
            take(&[1.0, 2.0, 0.0], Statistic::TimeOfMin, None),
            Some(3.25)
        );
        assert_eq!(
            take(&[1.0, 2.0, 0.0], Statistic::Max, Some([0.0, 0.5])),
            Some(1.875)
        );
        // The parabola through the three peaks in between.
        let peak = take(&[1.0, 2.0, 0.0], Statistic::Max, Some([0.0, 2.0])).unwrap();
        assert!((peak - (2.0 + 1.0 / 24.0)).abs() < 1e-14, "{peak}");
        assert_eq!(take(&[1.0, 2.0, 0.0], Statistic::Travel, None), Some(10.0));
    }

    #[test]
    fn peaks_are_those_of_whole_cycles() {
        // Amplitudes 1, 2, 3 and 4; the cycles begun before the record and not ended in it are not whole.
        let swing: Vec<f64> = (0..=70)
            .map(|i| {
                let t = f64::from(i) / 20.0;
                (std::f64::consts::TAU * t).sin() * (1.0 + t.floor())
            })
            .collect();
        let mean = |s| take(&swing, s, None).unwrap();
        assert!(
            (mean(Statistic::MeanPeak) - 2.5).abs() < 1e-9,
            "{}",
            mean(Statistic::MeanPeak)
        );
        assert!((mean(Statistic::MeanTrough) + 2.5).abs() < 1e-9);
        assert_eq!(take(&[0.0, 1.0, 0.0], Statistic::MeanPeak, None), None);
    }

    #[test]
    fn settling_and_rising() {
        let fall: Vec<f64> = (0..200).map(|i| (-f64::from(i) / 10.0).exp()).collect();
        let settled = take(&fall, Statistic::SettlingTime, None).unwrap();
        assert!((settled - 10.0 * 50f64.ln()).abs() < 0.1, "{settled}");
        let risen = take(&fall, Statistic::RiseTime, None).unwrap();
        assert!((risen - 10.0 * 10f64.ln()).abs() < 0.1, "{risen}");
        assert_eq!(take(&[3.0, 0.0, 5.0], Statistic::Rate, None), Some(1.0));
    }
}
