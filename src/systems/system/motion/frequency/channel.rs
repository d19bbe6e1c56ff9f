//! The channels of a quick look: how they follow the motion, and what their spectra say.

use std::f64::consts::TAU;

use super::excitation::Excitation;
use super::linear_system::Amplitudes;
use super::perturbed::Phase;
use super::{Amplitude, Complex};
use crate::case::{ChannelId, ChannelQuantity};
use crate::system::motion::body_equation::MovingBody;
use crate::system::motion::channels::Channels;
use crate::system::motion::moving_system::MovingSystem;
use crate::system::motion::system_state::SystemState;

/// Harmonics at most that are no random sea.
pub(super) const FEW: usize = 3;

/// Greatest displacement of the states by which channels are differentiated \[m, rad\].
const STEP: f64 = 1e-4;

/// A channel as a normal process.
#[derive(Debug, Clone, PartialEq)]
pub struct QuickChannel {
    /// Which.
    pub id: ChannelId,
    /// Its value at rest, before waves drive what floats away.
    pub at_start: f64,
    /// Its mean.
    pub mean: f64,
    /// Moments of its spectrum over angular frequency, of orders 0, 1, 2 and 4.
    pub moments: [f64; 4],
    /// Complex amplitudes, one a component.
    amplitudes: Vec<Complex>,
}

impl QuickChannel {
    /// Of complex amplitudes at these frequencies \[rad/s\].
    pub(super) fn new(
        id: ChannelId,
        (at_start, mean): (f64, f64),
        terms: &[(f64, Complex)],
    ) -> Self {
        let moment = |order: i32| {
            let terms = terms.iter();
            terms
                .map(|(omega, y)| 0.5 * y.norm_sqr() * omega.powi(order))
                .sum()
        };
        Self {
            id,
            at_start,
            mean,
            moments: [0, 1, 2, 4].map(moment),
            amplitudes: terms.iter().map(|(_, y)| *y).collect(),
        }
    }

    /// Complex amplitudes by `exp(i omega t)`, one an excitation.
    #[must_use]
    pub fn amplitudes(&self) -> &[Complex] {
        &self.amplitudes
    }

    /// Standard deviation.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.moments[0].sqrt()
    }

    /// Rate at which it crosses its mean upwards \[1/s\]; 0 where it does not move.
    #[must_use]
    pub fn rate(&self) -> f64 {
        if self.moments[0] > 0.0 {
            (self.moments[2] / self.moments[0]).sqrt() / TAU
        } else {
            0.0
        }
    }

    /// The most probable greatest value of so many hours, or with sign -1 the least one: `mean + sigma sqrt(2 ln N)` with N crossings
    /// (Longuet-Higgins 1952). Of a few harmonics, which make no random sea, the greatest value that they ever reach together.
    #[must_use]
    pub fn most_probable(&self, hours: f64, sign: f64) -> f64 {
        if self.amplitudes.len() <= FEW {
            let reach = self.amplitudes.iter().map(|y| y.norm());
            return self.mean + sign * reach.sum::<f64>();
        }
        let crossings = (self.rate() * hours * 3600.0).max(1.0);
        self.mean + sign * self.deviation() * (2.0 * crossings.ln()).sqrt()
    }

    /// A sum of this and another one, with these weights; both of the same look.
    #[must_use]
    pub fn mixed(&self, other: &Self, [own, others]: [f64; 2], omegas: &[f64]) -> Self {
        let pairs = self.amplitudes.iter().zip(&other.amplitudes);
        let terms: Vec<(f64, Complex)> = pairs
            .zip(omegas)
            .map(|((a, b), omega)| (*omega, a * own + b * others))
            .collect();
        let mixed = |a: f64, b: f64| own * a + others * b;
        let (at_start, mean) = (
            mixed(self.at_start, other.at_start),
            mixed(self.mean, other.mean),
        );
        Self::new(self.id.clone(), (at_start, mean), &terms)
    }
}

/// Reads the channels of a system.
pub(super) struct ChannelReader<'a> {
    channels: Channels,
    system: &'a MovingSystem,
    bodies: Vec<MovingBody>,
    mean: &'a SystemState,
    state: SystemState,
    values: [Vec<f64>; 2],
}

impl<'a> ChannelReader<'a> {
    pub(super) fn new(
        channels: Channels,
        system: &'a MovingSystem,
        bodies: Vec<MovingBody>,
        mean: &'a SystemState,
    ) -> Self {
        let values = vec![0.0; channels.ids.len()];
        Self {
            values: [values.clone(), values],
            channels,
            system,
            bodies,
            state: mean.clone(),
            mean,
        }
    }

    pub(super) fn ids(&self) -> &[ChannelId] {
        &self.channels.ids
    }

    /// Their values in a state without waves.
    pub(super) fn values_in(&self, state: &SystemState) -> Vec<f64> {
        let mut values = vec![0.0; self.channels.ids.len()];
        let system = (self.system, self.bodies.as_slice());
        self.channels.read(system, (0.0, state), None, &mut values);
        for (value, id) in values.iter_mut().zip(&self.channels.ids) {
            if id.quantity == ChannelQuantity::WaveElevation {
                *value = 0.0;
            }
        }
        values
    }

    /// Their complex amplitudes under a response: central differences at two phases.
    pub(super) fn amplitudes(
        &mut self,
        excitation: &Excitation,
        response: &Amplitudes,
    ) -> Vec<Complex> {
        let mut sums = vec![Complex::default(); self.channels.ids.len()];
        let scale = greatest(response) / STEP;
        if scale > 0.0 {
            for turn in [Complex::from(1.0), Complex::i()] {
                for (sign, out) in [1.0, -1.0].into_iter().zip([0, 1]) {
                    let factor = turn * (sign / scale);
                    self.read_at(excitation, response, factor, out);
                }
                let pairs = self.values[0].iter().zip(&self.values[1]);
                for (sum, (high, low)) in sums.iter_mut().zip(pairs) {
                    *sum += turn.conj() * (0.5 * scale * (high - low));
                }
            }
        }
        for (sum, id) in sums.iter_mut().zip(&self.channels.ids) {
            if id.quantity == ChannelQuantity::WaveElevation {
                *sum = excitation.elevation;
            }
        }
        sums
    }

    fn read_at(
        &mut self,
        excitation: &Excitation,
        response: &Amplitudes,
        factor: Complex,
        out: usize,
    ) {
        let phase = Phase {
            omega: excitation.omega,
            factor,
        };
        phase.move_all(self.system, (self.mean, response), &mut self.state);
        excitation.read_into(factor, self.system, &mut self.state);
        let system = (self.system, self.bodies.as_slice());
        self.channels
            .read(system, (0.0, &self.state), None, &mut self.values[out]);
    }
}

/// The greatest displacement among nodes and joints.
fn greatest(response: &Amplitudes) -> f64 {
    let lines = response.lines.iter().flatten();
    let all = lines.chain(&response.joints);
    all.map(Amplitude::norm).fold(0.0, f64::max)
}
