//! What is recorded of a system in motion: its channels, the tensions along its lines, its energy.

use super::body_equation::MovingBody;
use super::channels::Channels;
use super::energy::add_beside_lines;
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::run::recorded::Recorded;
use crate::run::step_interval::StepSample;
use crate::scene::{EnergyRates, Scene};
use crate::solve::State;

/// A system with what is read of it.
#[derive(Clone, Copy)]
pub(super) struct RecordedSystem<'a> {
    pub(super) system: &'a MovingSystem,
    /// The bodies that turn, with their mass.
    pub(super) bodies: &'a [MovingBody],
    pub(super) channels: &'a Channels,
}

impl Recorded for RecordedSystem<'_> {
    type State = SystemState;

    fn lines(&self) -> usize {
        self.system.scenes.len()
    }

    fn line<'a>(&'a self, number: usize, state: &'a SystemState) -> (&'a Scene, &'a State) {
        (self.system.scene(number, state), &state.lines[number])
    }

    fn read(&self, time: f64, state: &SystemState, balances: bool, sample: &mut StepSample) {
        let Self {
            system,
            bodies,
            channels,
        } = *self;
        let mut sum = EnergyRates::default();
        let mut left = &mut sample.tension[..];
        for (number, (scene, line)) in system.lines(state).enumerate() {
            let (own, rest) = left.split_at_mut(scene.line_nodes());
            let mut rates = scene.read_step(time, line, balances, own);
            // What comes off a drum brings its energy with it.
            if system.paid.iter().any(|paid| paid.line == number) {
                rates.supplied += std::mem::take(&mut rates.growth);
            }
            sum.add(&rates);
            left = rest;
        }
        if balances {
            add_beside_lines(system, bodies, (time, state), &mut sum);
            sample.energy = sum;
        }
        let StepSample {
            tension, values, ..
        } = sample;
        channels.read((system, bodies), (time, state), Some(tension), values);
    }
}
