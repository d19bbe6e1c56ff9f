//! What is recorded while it moves: a line, or a system of lines.

use super::channel_reading::ChannelReading;
use super::step_interval::StepSample;
use crate::case::ChannelSpec;
use crate::scene::Scene;
use crate::solve::State;

/// Something whose accepted steps are recorded.
pub trait Recorded {
    /// The state that its march changes.
    type State;

    /// Number of its lines.
    fn lines(&self) -> usize;

    /// A line as it is in a state, and its own part of the state.
    fn line<'a>(&'a self, number: usize, state: &'a Self::State) -> (&'a Scene, &'a State);

    /// Reads the tensions of all nodes into a sample \[N\], one line after the other, then the channels and, where `balances` is set,
    /// the energy; the nodes are read by the recorder. Does not allocate.
    fn read(&self, time: f64, state: &Self::State, balances: bool, sample: &mut StepSample);

    /// Number of the nodes of all lines.
    fn nodes(&self, state: &Self::State) -> usize {
        let lines = 0..self.lines();
        lines
            .map(|number| self.line(number, state).0.line_nodes())
            .sum()
    }
}

/// A line by itself with its channels.
pub(super) struct RecordedLine<'a> {
    pub(super) scene: &'a Scene,
    pub(super) channels: &'a [ChannelSpec],
}

impl Recorded for RecordedLine<'_> {
    type State = State;

    fn lines(&self) -> usize {
        1
    }

    fn line<'a>(&'a self, _: usize, state: &'a State) -> (&'a Scene, &'a State) {
        (self.scene, state)
    }

    fn read(&self, time: f64, state: &State, balances: bool, sample: &mut StepSample) {
        let StepSample {
            values,
            tension,
            energy,
            ..
        } = sample;
        *energy = self.scene.read_step(time, state, balances, tension);
        let mut reading = ChannelReading::new(self.scene, time, state, tension);
        for (value, channel) in values.iter_mut().zip(self.channels) {
            let read = reading.channel(channel.id.quantity, channel.site);
            *value = read.unwrap_or(f64::NAN);
        }
    }
}
