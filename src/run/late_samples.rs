//! The channels shortly before the end of a run. A last value of a channel that swings may agree with that of a companion by chance;
//! together with those before it it does not (see [`error_estimate`](super::error_estimate)).

use serde::{Deserialize, Serialize};

use super::step_interval::StepInterval;

/// Times of the samples by the duration: near enough to the end to have the same error, and apart by a part of a period.
const PLACES: [f64; 2] = [0.98, 0.99];

/// Samples of all channels at fixed times, one row after the other.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct LateSamples {
    /// The times \[s\].
    #[serde(skip)]
    times: [f64; PLACES.len()],
    values: Vec<f64>,
}

impl LateSamples {
    /// Of a run of this duration \[s\], without samples yet and with room for all of them.
    pub(super) fn of(duration: f64, channels: usize) -> Self {
        Self {
            times: PLACES.map(|place| place * duration),
            values: Vec::with_capacity(PLACES.len() * channels),
        }
    }

    /// Takes those in between two steps.
    pub(super) fn update(&mut self, between: &StepInterval<'_>) {
        let channels = between.channels();
        let [from, until] = between.time();
        for time in self.times {
            if time > from && time <= until {
                let taken = self.values.len();
                self.values.resize(taken + channels, 0.0);
                between.sample_channels(time, &mut self.values[taken..]);
            }
        }
    }

    /// Whether they may be of so many channels, as of a checkpoint.
    pub(super) fn fits(&self, channels: usize) -> bool {
        self.values.len() <= PLACES.len() * channels
            && self.values.len().checked_rem(channels).unwrap_or(0) == 0
            && self.values.iter().all(|value| value.is_finite())
    }

    /// Continues from a checkpoint.
    pub(super) fn restore(&mut self, known: &Self) {
        self.values.clone_from(&known.values);
    }

    /// The samples of a channel among so many, from the first to the last.
    pub(super) fn channel(&self, number: usize, channels: usize) -> impl Iterator<Item = f64> {
        let rows = self.values.chunks_exact(channels.max(1));
        rows.filter_map(move |row| row.get(number).copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::step_interval::LatestSteps;

    /// Two channels, t and 2 t, over so many steps of a second.
    fn samples(steps: usize) -> LateSamples {
        let mut late = LateSamples::of(100.0, 2);
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
        assert_eq!(late.channel(0, 2).collect::<Vec<_>>(), [98.0, 99.0]);
        assert_eq!(late.channel(1, 2).collect::<Vec<_>>(), [196.0, 198.0]);
        assert_eq!(samples(97).channel(0, 2).count(), 0);
    }

    #[test]
    fn a_checkpoint_of_other_channels_does_not_fit() {
        assert!(samples(98).fits(2) && samples(0).fits(0));
        assert!(!samples(98).fits(1) && !samples(98).fits(3));
        let mut damaged = samples(98);
        damaged.values[0] = f64::NAN;
        assert!(!damaged.fits(2));
    }

    #[test]
    fn what_a_checkpoint_holds_is_continued() {
        let mut late = LateSamples::of(100.0, 2);
        late.restore(&samples(98));
        assert_eq!(late, samples(98));
    }
}
