//! Mixed iteration of statics: see [`crate::solve::Residual::extrapolate_tensions`].

use super::LumpedLine;
use crate::numerics::V3;
use crate::physics::tension::{Chord, Tension};
use crate::solve::State;

impl LumpedLine {
    /// Tension of segment i, and the one for its geometric stiffness. With extrapolated tensions a slack segment bears
    /// compression during the iteration, so that the tangent is regular.
    #[inline(always)]
    pub(super) fn tension(
        &self,
        i: usize,
        chord: &Chord,
        t: f64,
        state: &State,
    ) -> (Tension, Tension) {
        match state.extrapolated_tension.get(i) {
            None => {
                let tension = self.pull(i, chord, t, state);
                (tension, tension)
            }
            Some(extrapolated) => {
                let tension = self.two_sided_tension(i, chord, t, state);
                let value = *extrapolated;
                (tension, Tension { value, ..tension })
            }
        }
    }

    /// Initial tensions of the iteration: those of the strain if all are plausible, else those of the initial guess `start`.
    pub(super) fn initial_segment_tensions(&self, start: &[f64], state: &mut State) {
        let now = state.memory.time;
        let stretched = |i: usize| {
            let chord = self.chord(i, state);
            self.two_sided_tension(i, &chord, now, state).value
        };
        let tensions: Vec<f64> = (0..self.segments.len()).map(stretched).collect();
        let usual = start.iter().copied().fold(0.0, f64::max);
        let likely = |t: &f64| (1e-3 * usual..3.0 * usual).contains(t);
        state.extrapolated_tension = if tensions.iter().all(likely) {
            tensions
        } else {
            start.to_vec()
        };
    }

    /// Tensions to first order after the displacements `-d`.
    pub(super) fn extrapolate_segment_tensions(&self, d: &[V3], state: &mut State) {
        for i in 0..self.segments.len() {
            let chord = self.chord(i, state);
            let tension = self.two_sided_tension(i, &chord, state.memory.time, state);
            let next = tension.value - tension.by_length * chord.tangent.dot(&(d[i + 1] - d[i]));
            state.extrapolated_tension[i] = if self.segments[i].axial.rod {
                next
            } else {
                next.max(self.least_tension(i))
            };
        }
    }

    /// Lower bound of the tension in the geometric stiffness of a rope \[N\].
    fn least_tension(&self, i: usize) -> f64 {
        0.1 * self.segments[i].half_weight.abs() + 1e-6 * self.force_scale
    }
}
