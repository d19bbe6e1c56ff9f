//! The channels shortly before the end of a run. A last value of a channel that swings may agree with that of a companion by chance;
//! together with those before it it does not (see [`error_estimate`](super::error_estimate)).

use serde::{Deserialize, Serialize};

use super::step_interval::StepInterval;

/// Times of the samples by the duration: near enough to the end to have the same error, and apart by a part of a period.
const PLACES: [f64; 2] = [0.98, 0.99];

/// Samples of all channels at fixed times.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct LateSamples {
    /// When samples are due \[s\].
    #[serde(skip)]
    due: [f64; PLACES.len()],
    /// When they were taken \[s\].
    times: Vec<f64>,
    /// Those of each time, one after the other.
    values: Vec<f64>,
}

impl LateSamples {
    /// Of a run of this duration \[s\], without samples yet and with room for all of them.
    pub(super) fn of_duration(duration: f64, channels: usize) -> Self {
        Self {
            due: PLACES.map(|place| place * duration),
            times: Vec::with_capacity(PLACES.len()),
            values: Vec::with_capacity(PLACES.len() * channels),
        }
    }

    /// Takes those due between two steps.
    pub(super) fn update(&mut self, between: &StepInterval<'_>) {
        let channels = between.channels();
        let [from, until] = between.time();
        for time in self.due {
            if time > from && time <= until {
                let taken = self.values.len();
                self.values.resize(taken + channels, 0.0);
                between.sample_channels(time, &mut self.values[taken..]);
                self.times.push(time);
            }
        }
    }

    /// Whether they may be of so many channels, as of a checkpoint.
    pub(super) fn fits(&self, channels: usize) -> bool {
        self.times.len() <= PLACES.len()
            && self.values.len() == self.times.len() * channels
            && self.values.iter().all(|value| value.is_finite())
    }

    /// Continues from a checkpoint, of which those count that this run takes as well: it may go on for longer.
    pub(super) fn restore(&mut self, known: &Self) {
        for (time, row) in known.rows().filter(|(time, _)| self.due.contains(time)) {
            self.times.push(time);
            self.values.extend(row);
        }
    }

    /// Differences of a channel from the samples of another run at the same times.
    pub(super) fn differences(&self, other: &Self, channel: usize) -> impl Iterator<Item = f64> {
        self.rows().filter_map(move |(time, row)| {
            let (_, same) = other.rows().find(|(other, _)| *other == time)?;
            Some(row.get(channel)? - same.get(channel)?)
        })
    }

    /// The times with their samples.
    fn rows(&self) -> impl Iterator<Item = (f64, &[f64])> {
        let channels = self.values.len() / self.times.len().max(1);
        let rows = self.values.chunks(channels.max(1));
        self.times.iter().copied().zip(rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::step_interval::LatestSteps;

    /// Two channels, t and 2 t, over so many steps of a second.
    fn samples(steps: usize) -> LateSamples {
        let mut late = LateSamples::of_duration(100.0, 2);
        let mut latest = LatestSteps::new(2, 0);
        for i in 0..=steps {
            let step = latest.next();
            step.time = i as f64;
            step.values.copy_from_slice(&[i as f64, 2.0 * i as f64]);
            if let Some(between) = latest.complete_interval(&[]) {
                late.update(&between);
            }
        }
        if let Some(between) = latest.last_interval(&[]) {
            late.update(&between);
        }
        late
    }

    #[test]
    fn channels_are_sampled_once_at_each_time() {
        let late = samples(100);
        assert_eq!(late.times, [98.0, 99.0]);
        assert_eq!(late.values, [98.0, 196.0, 99.0, 198.0]);
        assert_eq!(samples(97).times, [0.0; 0]);
    }

    #[test]
    fn samples_of_the_same_time_are_compared() {
        let mut other = samples(100);
        other.values[3] = 200.5;
        let differences = |of: &LateSamples, channel| -> Vec<f64> {
            samples(100).differences(of, channel).collect()
        };
        assert_eq!(differences(&other, 1), [0.0, -2.5]);
        // One that was resumed from a checkpoint without the first of them.
        (other.times, other.values) = (vec![99.0], vec![99.25, 198.0]);
        assert_eq!(differences(&other, 0), [-0.25]);
        assert_eq!(differences(&LateSamples::default(), 0), [0.0; 0]);
    }

    #[test]
    fn a_checkpoint_of_other_channels_does_not_fit() {
        assert!(samples(98).fits(2) && samples(97).fits(3));
        assert!(!samples(98).fits(1) && !samples(98).fits(3));
        let mut damaged = samples(98);
        damaged.values[0] = f64::NAN;
        assert!(!damaged.fits(2));
    }

    #[test]
    fn what_a_checkpoint_holds_is_continued_by_a_run_of_the_same_duration() {
        let continued = |duration| {
            let mut late = LateSamples::of_duration(duration, 2);
            late.restore(&samples(98));
            late
        };
        assert_eq!(continued(100.0), samples(98));
        assert_eq!(continued(120.0).times, [0.0; 0]);
    }
}
