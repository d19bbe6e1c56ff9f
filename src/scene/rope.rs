//! Tensions of segments by the law of their material, and the tension history of ropes.

use super::LumpedLine;
use crate::physics::rope::{ElasticTension, MeanState, TensionLaw};
use crate::physics::tension::{AxialConstants, Chord, Tension};
use crate::solve::{RopeHistory, State};

/// The dynamic stiffness of a segment at an instant.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct RopeStiffness {
    /// Lm: mean of the past tension, in percent of the breaking load.
    pub mean_load: f64,
    /// La: deviation of the tension from that mean, in percent of the breaking load.
    pub deviation: f64,
    /// k: stiffness EA by breaking load \[-\].
    pub stiffness: f64,
}

impl LumpedLine {
    /// The tension of segment i at time t \[s\].
    #[inline(always)]
    #[must_use]
    pub fn pull(&self, i: usize, chord: &Chord, t: f64, state: &State) -> Tension {
        let axial = &self.segments[i].axial;
        match axial.law {
            None => axial.tension(chord),
            Some(law) => self.pull_by(law, i, chord, t, state),
        }
    }

    /// The tension of segment i at the last accepted step, with its chord-length correction.
    #[inline(always)]
    #[must_use]
    pub fn tension_now(&self, i: usize, chord: &Chord, state: &State) -> Tension {
        match state.chord_correction.get(i) {
            None => self.pull(i, chord, state.memory.time, state),
            Some(_) => {
                let corrected = self.corrected_chord(i, chord, state);
                self.pull(i, &corrected, state.memory.time, state)
            }
        }
    }

    /// The tension of segment i if it bore compression.
    #[inline(always)]
    pub(super) fn two_sided_tension(
        &self,
        i: usize,
        chord: &Chord,
        t: f64,
        state: &State,
    ) -> Tension {
        let axial = self.segments[i].axial.bearing_compression(true);
        match axial.law {
            None => axial.tension(chord),
            Some(law) => {
                axial.tension_from(chord, self.elastic_by(law, i, &axial, chord, t, state))
            }
        }
    }

    /// The elastic part of the tension of segment i \[N\].
    pub(super) fn elastic(&self, i: usize, chord: &Chord, state: &State) -> f64 {
        if let Some(segment) = self.creeping(i, chord, state.memory.time, state) {
            return segment.energy().0;
        }
        let axial = &self.segments[i].axial;
        let elastic = match axial.law {
            None => axial.ea * (chord.length / axial.length - 1.0),
            Some(law) => {
                let now = state.memory.time;
                self.elastic_by(law, i, axial, chord, now, state).tension
            }
        };
        if axial.rod { elastic } else { elastic.max(0.0) }
    }

    /// Elastic energy of segment i \[J\]; with dynamic stiffness, that of immediate unloading.
    pub(super) fn elastic_energy(&self, i: usize, chord: &Chord, state: &State) -> f64 {
        if let Some(segment) = self.creeping(i, chord, state.memory.time, state) {
            return segment.energy().1;
        }
        let axial = &self.segments[i].axial;
        let stretch = chord.length - axial.length;
        let stretch = if axial.rod { stretch } else { stretch.max(0.0) };
        match axial.law {
            None => 0.5 * axial.ea / axial.length * stretch * stretch,
            Some(law) => {
                let mean = mean(i, state.memory.time, state);
                let strain = stretch / axial.length;
                axial.length * self.laws[usize::from(law)].stored(strain, mean.as_ref()).0
            }
        }
    }

    /// Power by which segment i loses elastic energy as its mean tension changes \[W\].
    pub(super) fn memory_dissipation(&self, i: usize, chord: &Chord, state: &State) -> f64 {
        if let Some(segment) = self.creeping(i, chord, state.memory.time, state) {
            return segment.energy().2;
        }
        let axial = &self.segments[i].axial;
        let (Some(law), Some(past)) = (axial.law, state.memory.ropes.get(i)) else {
            return 0.0;
        };
        let mean = mean(i, state.memory.time, state);
        let strain = axial.strain(chord.length).max(0.0);
        let (_, by_mean) = self.laws[usize::from(law)].stored(strain, mean.as_ref());
        -axial.length * by_mean * past.tension_rate
    }

    /// Elastic energy of segment i \[J\], and the power of its axial damping and of its memory \[W\], from its tension by
    /// [`LumpedLine::tension_now`]: what [`Scene::energy`](super::Scene::energy) and
    /// [`Scene::dissipation`](super::Scene::dissipation) count of it, with the laws evaluated once.
    #[inline(always)]
    pub(super) fn strain_energy(
        &self,
        i: usize,
        chord: &Chord,
        tension: f64,
        state: &State,
    ) -> (f64, f64) {
        let axial = &self.segments[i].axial;
        let closing = chord.tangent.dot(&chord.opening);
        let Some(law) = axial.law else {
            let stretch = chord.length - axial.length;
            let stretch = if axial.rod { stretch } else { stretch.max(0.0) };
            let elastic = axial.stiffness() * stretch;
            return (0.5 * elastic * stretch, (tension - elastic) * closing);
        };
        let corrected = self.corrected_chord(i, chord, state);
        if let Some(segment) = self.creeping(i, &corrected, state.memory.time, state) {
            let (elastic, stored, memory) = segment.energy();
            return (stored, (tension - elastic) * closing + memory);
        }
        let mean = mean(i, state.memory.time, state);
        let strain = axial.strain(chord.length);
        let strain = if axial.rod { strain } else { strain.max(0.0) };
        let (stored, by_mean) = self.laws[usize::from(law)].stored(strain, mean.as_ref());
        // Without damping the tension is elastic but for the chord-length correction.
        let known = axial.damping == 0.0 && state.chord_correction.is_empty();
        let elastic = if known {
            tension
        } else {
            self.elastic(i, chord, state)
        };
        let past = state.memory.ropes.get(i).map_or(0.0, |p| p.tension_rate);
        let memory = -axial.length * by_mean * past;
        (
            axial.length * stored,
            (tension - elastic) * closing + memory,
        )
    }

    /// Strain of segment i at rest under a tension \[N\].
    pub(super) fn strain_at_tension(&self, i: usize, tension: f64) -> f64 {
        let axial = &self.segments[i].axial;
        match axial.law {
            None => tension / axial.ea,
            Some(law) => self.laws[usize::from(law)].strain_at(tension),
        }
    }

    /// Secant stiffness of segment i at rest under a tension \[N\].
    pub(super) fn stiffness_at_tension(&self, i: usize, tension: f64) -> f64 {
        let axial = &self.segments[i].axial;
        if axial.law.is_none() {
            return axial.ea;
        }
        let small = 1e-9 * self.force_scale;
        let tension = tension.max(small);
        tension / self.strain_at_tension(i, tension)
    }

    /// The dynamic stiffness of segment i; none if its material has no dynamic stiffness.
    #[must_use]
    pub fn rope_reading(&self, i: usize, state: &State) -> Option<RopeStiffness> {
        let law = self.segments[i].axial.law?;
        let rope = self.laws[usize::from(law)].dynamic()?;
        let tension = self.elastic(i, &self.chord(i, state), state);
        let mean = state.memory.ropes.get(i).map_or(tension, |past| past.mean);
        let (mean_load, deviation) = (rope.percent(mean), rope.percent(tension - mean));
        Some(RopeStiffness {
            mean_load,
            deviation,
            stiffness: rope.stiffness(mean_load, deviation),
        })
    }

    /// Updates the tension history of the ropes by an accepted state: the running mean by the trapezoidal rule, over all of the
    /// past or with an exponential window, and its rate; of ropes that creep their mean strain. `dt` 0 starts the history at the present tensions. Times in s.
    pub fn remember_ropes(&self, t: f64, dt: f64, state: &mut State) {
        self.remember_creep(t, dt, state);
        if self.laws.iter().all(|law| law.dynamic().is_none()) {
            if !state.memory.creep.is_empty() {
                state.memory.time = t;
            }
            return;
        }
        if dt <= 0.0 || state.memory.ropes.len() != self.segments.len() {
            state.memory.ropes.clear();
            state.memory.time = t;
            let first = (0..self.segments.len())
                .map(|i| self.begin(i, state))
                .collect();
            state.memory.ropes = first;
            return;
        }
        for i in 0..self.segments.len() {
            let axial = &self.segments[i].axial;
            let law = axial.law.map(|law| &self.laws[usize::from(law)]);
            let Some(rope) = law.and_then(TensionLaw::dynamic) else {
                continue;
            };
            let chord = self.chord(i, state);
            let strain = axial.strain(chord.length);
            let about = mean(i, t, state).unwrap_or_default();
            let tension = rope.in_motion(strain, &about).tension.max(0.0);
            let past = &mut state.memory.ropes[i];
            let share = if t < rope.window {
                dt / t
            } else {
                dt / (rope.window + 0.5 * dt)
            };
            past.mean += share * (0.5 * (past.tension + tension) - past.mean);
            past.tension = tension;
            past.strain = rope.strain_at(past.mean);
            past.tension_rate = (tension - past.mean) / t.min(rope.window);
            past.strain_rate = past.tension_rate * rope.compliance(past.strain);
        }
        state.memory.time = t;
    }

    /// The initial history of segment i: its tension.
    fn begin(&self, i: usize, state: &State) -> RopeHistory {
        let tension = self.elastic(i, &self.chord(i, state), state);
        RopeHistory {
            mean: tension,
            strain: self.strain_at_tension(i, tension),
            tension,
            ..RopeHistory::default()
        }
    }

    /// The tension of segment i by a law.
    #[inline(never)]
    fn pull_by(&self, law: u16, i: usize, chord: &Chord, t: f64, state: &State) -> Tension {
        if let Some(segment) = self.creeping(i, chord, t, state) {
            return segment.tension();
        }
        let axial = &self.segments[i].axial;
        axial.tension_from(chord, self.elastic_by(law, i, axial, chord, t, state))
    }

    #[inline(never)]
    fn elastic_by(
        &self,
        law: u16,
        i: usize,
        axial: &AxialConstants,
        chord: &Chord,
        t: f64,
        state: &State,
    ) -> ElasticTension {
        let mean = mean(i, t, state);
        self.laws[usize::from(law)].at(axial.strain(chord.length), mean.as_ref())
    }
}

/// Mean state of segment i at time t, extrapolated from the last accepted step at its rate, which keeps second order; none at
/// rest.
#[inline(always)]
fn mean(i: usize, t: f64, state: &State) -> Option<MeanState> {
    let past = state.memory.ropes.get(i)?;
    let since = t - state.memory.time;
    Some(MeanState {
        tension: past.mean + past.tension_rate * since,
        strain: past.strain + past.strain_rate * since,
    })
}
