//! Tensions of segments by the law of their material, and the tension history of ropes.

use std::ops::Range;

use super::{LumpedLine, Scene};
use crate::case::ChannelQuantity;
use crate::physics::rope::{
    ElasticTension, FibreRope, MeanState, RopeAverage, StiffnessForm, TensionLaw,
};
use crate::physics::tension::{AxialConstants, Chord, Tension};
use crate::solve::{RopeHistory, SharedStiffness, State};

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

impl RopeStiffness {
    /// The value of a quantity of dynamic stiffness, in its unit; nothing of others.
    #[must_use]
    pub fn value(&self, quantity: ChannelQuantity) -> Option<f64> {
        match quantity {
            ChannelQuantity::MeanLoad => Some(self.mean_load),
            ChannelQuantity::LoadDeviation => Some(self.deviation),
            ChannelQuantity::Stiffness => Some(self.stiffness),
            _ => None,
        }
    }
}

impl Scene {
    /// Dynamic stiffness at the first or last node of a section, by its number; zero of a material that has none. A segment has that of its
    /// middle: at the node it is extrapolated from both segments next to it.
    #[must_use]
    pub fn rope_at_end(&self, section: usize, at_end: bool, state: &State) -> RopeStiffness {
        let joint = |index: usize| self.labels.joints[index].node;
        let (first, last) = (joint(section), joint(section + 1) - 1);
        let (near, far) = if at_end {
            (last, first.max(last.saturating_sub(1)))
        } else {
            (first, last.min(first + 1))
        };
        let length = |segment: usize| self.line.segments[segment].axial.length;
        let beyond = length(near) / (length(near) + length(far));
        let of = |segment: usize| self.line.rope_reading(segment, state);
        let [near, far] = [near, far].map(|segment| of(segment).unwrap_or_default());
        let at_node = |value: fn(&RopeStiffness) -> f64| {
            let (near, far) = (value(&near), value(&far));
            near + (near - far) * beyond
        };
        RopeStiffness {
            // A mean is positive, or of a rope that has been slack all along.
            mean_load: at_node(|of| of.mean_load).max(near.mean_load.min(0.0)),
            deviation: at_node(|of| of.deviation),
            stiffness: at_node(|of| of.stiffness),
        }
    }
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
            Some(law) => axial.length * self.stored_by(law, i, stretch / axial.length, state).0,
        }
    }

    /// Power by which segment i loses elastic energy as its mean tension changes \[W\].
    pub(super) fn memory_dissipation(&self, i: usize, chord: &Chord, state: &State) -> f64 {
        if let Some(segment) = self.creeping(i, chord, state.memory.time, state) {
            return segment.energy().2;
        }
        let axial = &self.segments[i].axial;
        let Some(law) = axial.law else {
            return 0.0;
        };
        let strain = axial.strain(chord.length).max(0.0);
        axial.length * self.stored_by(law, i, strain, state).1
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
        let strain = axial.strain(chord.length);
        let strain = if axial.rod { strain } else { strain.max(0.0) };
        let (stored, lost) = self.stored_by(law, i, strain, state);
        // Without damping the tension is elastic but for the chord-length correction.
        let known = axial.damping == 0.0 && state.chord_correction.is_empty();
        let elastic = if known {
            tension
        } else {
            self.elastic(i, chord, state)
        };
        (
            axial.length * stored,
            (tension - elastic) * closing + axial.length * lost,
        )
    }

    /// Energy stored in segment i per unstretched length by a law \[N\], and the power lost of it as the memory of the rope
    /// fades \[N/s\].
    fn stored_by(&self, law: u16, i: usize, strain: f64, state: &State) -> (f64, f64) {
        let (law, now) = (&self.laws[usize::from(law)], state.memory.time);
        let mean = mean(i, now, state);
        let past = state.memory.ropes.get(i);
        if let (Some(rope), Some(shared)) = (law.dynamic(), shared(i, now, state)) {
            let mean_rate = past.map(|past| MeanState {
                tension: past.tension_rate,
                strain: past.strain_rate,
            });
            let k = rope.shared_stiffness(&shared.now);
            let k_rate = rope.shared_stiffness_rate(&shared.now, &shared.rate);
            let own = mean.as_ref().zip(mean_rate.as_ref());
            let (stored, rate) = rope.stored_in_step(strain, own, (k, k_rate));
            return (stored, -rate);
        }
        let (stored, by_mean) = law.stored(strain, mean.as_ref());
        (
            stored,
            -by_mean * past.map_or(0.0, |past| past.tension_rate),
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
        if let Some(shared) = shared(i, state.memory.time, state) {
            let stiffness = rope.shared_stiffness(&shared.now);
            return Some(RopeStiffness {
                mean_load: rope.percent(shared.now.tension),
                deviation: rope.shared_deviation(&shared.now, stiffness),
                stiffness,
            });
        }
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
            self.share_stiffness_at_rest(state);
            let first = (0..self.segments.len())
                .map(|i| self.begin(i, state))
                .collect();
            state.memory.ropes = first;
            self.share_stiffness(state);
            return;
        }
        for i in 0..self.segments.len() {
            let axial = &self.segments[i].axial;
            let law = axial.law.map(|law| &self.laws[usize::from(law)]);
            let Some(rope) = law.and_then(TensionLaw::dynamic) else {
                continue;
            };
            let strain = axial.strain(self.chord(i, state).length);
            let about = mean(i, t, state).unwrap_or_default();
            let tension = match shared(i, t, state) {
                None => rope.in_motion(strain, &about),
                Some(shared) => {
                    rope.in_step(strain, Some(&about), rope.shared_stiffness(&shared.now))
                }
            };
            let tension = tension.tension.max(0.0);
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
        self.share_stiffness(state);
    }

    /// Ropes whose segments share one stiffness: neighbours of one law, at least two, for one alone has its own anyway.
    fn sharing_ropes(&self) -> impl Iterator<Item = (Range<usize>, &FibreRope)> {
        let mut start = 0;
        let runs = self.segments.chunk_by(|a, b| a.axial.law == b.axial.law);
        runs.filter_map(move |run| {
            let range = start..start + run.len();
            start = range.end;
            let rope = self.laws[usize::from(run[0].axial.law?)].dynamic()?;
            (rope.shared && range.len() > 1).then_some((range, rope))
        })
    }

    /// Brings the one stiffness of ropes that share it up to date with an accepted state and its history.
    fn share_stiffness(&self, state: &mut State) {
        if !self.laws.iter().any(is_shared) {
            return;
        }
        let mut list = std::mem::take(&mut state.memory.shared_stiffness);
        list.clear();
        list.resize(self.segments.len(), SharedStiffness::default());
        for (range, rope) in self.sharing_ropes() {
            let about = matches!(rope.reading, StiffnessForm::AboutTheMean(_));
            let mut sum = SharedStiffness::default();
            let mut total = 0.0;
            for i in range.clone() {
                let (axial, chord) = (&self.segments[i].axial, self.chord(i, state));
                let past = state.memory.ropes.get(i).copied().unwrap_or_default();
                let rate = chord.tangent.dot(&chord.opening) / axial.length;
                let from = if about {
                    (past.strain, past.strain_rate)
                } else {
                    (0.0, 0.0)
                };
                total += axial.length;
                sum.mean += axial.length * past.mean;
                sum.mean_rate += axial.length * past.tension_rate;
                sum.strain += axial.length * (axial.strain(chord.length) - from.0);
                sum.strain_rate += axial.length * (rate - from.1);
            }
            let average = SharedStiffness {
                shared: true,
                mean: sum.mean / total,
                mean_rate: sum.mean_rate / total,
                strain: sum.strain / total,
                strain_rate: sum.strain_rate / total,
            };
            list[range].fill(average);
        }
        state.memory.shared_stiffness = list;
    }

    /// The same for a state at rest without history; returns the greatest change of a stiffness, relative to itself. The
    /// average tension is its own mean, so that it follows from the average strain by the curve at rest.
    pub(super) fn share_stiffness_at_rest(&self, state: &mut State) -> f64 {
        if !self.laws.iter().any(is_shared) {
            return 0.0;
        }
        let mut change = 0.0_f64;
        let mut list = vec![SharedStiffness::default(); self.segments.len()];
        for (range, rope) in self.sharing_ropes() {
            let secant = rope.reading == StiffnessForm::Secant;
            let (mut total, mut sum) = (0.0, 0.0);
            for i in range.clone() {
                let axial = &self.segments[i].axial;
                let strain = axial.strain(self.chord(i, state).length);
                let what = if secant {
                    strain
                } else {
                    rope.at_rest(strain).tension
                };
                total += axial.length;
                sum += axial.length * what;
            }
            let average = sum / total;
            let now = if secant {
                SharedStiffness {
                    shared: true,
                    mean: rope.at_rest(average).tension,
                    strain: average,
                    ..SharedStiffness::default()
                }
            } else {
                SharedStiffness {
                    shared: true,
                    mean: average,
                    ..SharedStiffness::default()
                }
            };
            let k = |shared: &SharedStiffness| rope.shared_stiffness(&average_of(shared, 0.0).now);
            if secant {
                let before = state.memory.shared_stiffness.get(range.start);
                let before = before.filter(|known| known.shared);
                let before = before.map_or(f64::INFINITY, k);
                change = change.max((k(&now) / before - 1.0).abs());
            }
            list[range].fill(now);
        }
        state.memory.shared_stiffness = list;
        change
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
        let (law, mean) = (&self.laws[usize::from(law)], mean(i, t, state));
        let strain = axial.strain(chord.length);
        if let (Some(rope), Some(shared)) = (law.dynamic(), shared(i, t, state)) {
            return rope.in_step(strain, mean.as_ref(), rope.shared_stiffness(&shared.now));
        }
        law.at(strain, mean.as_ref())
    }
}

/// Whether a law is that of ropes whose segments share one stiffness.
fn is_shared(law: &TensionLaw) -> bool {
    law.dynamic().is_some_and(|rope| rope.shared)
}

/// What a shared stiffness depends on, and the rates of that \[1/s\].
struct Shared {
    now: RopeAverage,
    rate: RopeAverage,
}

/// That of segment i at time t, extrapolated from the last accepted step at its rate, which keeps second order: the tangent
/// stays that of a segment alone. None if the segment has a stiffness of its own.
#[inline(always)]
fn shared(i: usize, t: f64, state: &State) -> Option<Shared> {
    let known = state.memory.shared_stiffness.get(i)?;
    known
        .shared
        .then(|| average_of(known, t - state.memory.time))
}

/// The same, a time \[s\] after the last accepted step.
fn average_of(known: &SharedStiffness, since: f64) -> Shared {
    Shared {
        now: RopeAverage {
            tension: known.mean + known.mean_rate * since,
            strain: known.strain + known.strain_rate * since,
        },
        rate: RopeAverage {
            tension: known.mean_rate,
            strain: known.strain_rate,
        },
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
