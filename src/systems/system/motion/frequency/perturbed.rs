//! States a little beside the mean position, by complex amplitudes.

use super::linear_system::Amplitudes;
use super::{Amplitude, Complex};
use crate::numerics::V3;
use crate::solve::State;
use crate::system::motion::moving_system::MovingSystem;
use crate::system::motion::system_state::SystemState;

/// A displacement `Re(factor X exp(i omega t))` at time zero.
#[derive(Debug, Clone, Copy)]
pub(super) struct Phase {
    /// The angular frequency \[rad/s\].
    pub(super) omega: f64,
    /// What amplitudes are multiplied by.
    pub(super) factor: Complex,
}

impl Phase {
    /// Displacement, velocity and acceleration of an amplitude.
    fn motion(self, amplitude: &Amplitude) -> [V3; 3] {
        let rate = Complex::new(0.0, self.omega);
        let x = amplitude * self.factor;
        let v = x * rate;
        [x, v, v * rate].map(|part| part.map(|c| c.re))
    }

    fn move_node(self, state: &mut State, node: usize, (mean, by): (&State, &Amplitude)) {
        let [x, v, a] = self.motion(by);
        state.x[node] = mean.x[node] + x;
        state.v[node] = v;
        state.a[node] = a;
    }

    /// Moves the joints that are prescribed, and what follows them.
    pub(super) fn move_given(
        self,
        system: &MovingSystem,
        (mean, given): (&SystemState, &[Amplitude]),
        state: &mut SystemState,
    ) {
        let held = given.iter().enumerate().take(system.joints.free.start);
        for (joint, amplitude) in held {
            self.move_node(&mut state.joints, joint, (&mean.joints, amplitude));
        }
        system.follow_prescribed(state);
        system.follow(state);
    }

    /// Moves all nodes and joints.
    pub(super) fn move_all(
        self,
        system: &MovingSystem,
        (mean, by): (&SystemState, &Amplitudes),
        state: &mut SystemState,
    ) {
        for (line, amplitudes) in by.lines.iter().enumerate() {
            for (node, amplitude) in amplitudes.iter().enumerate() {
                let mean = (&mean.lines[line], amplitude);
                self.move_node(&mut state.lines[line], node, mean);
            }
        }
        for (joint, amplitude) in by.joints.iter().enumerate() {
            self.move_node(&mut state.joints, joint, (&mean.joints, amplitude));
        }
        system.follow_prescribed(state);
        system.follow(state);
    }
}
