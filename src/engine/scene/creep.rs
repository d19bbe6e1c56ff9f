//! Segments of ropes that creep: their tension, their energy, and what they remember. See [`crate::physics::rope::creep`].

use super::LumpedLine;
use crate::physics::rope::CreepingRope;
use crate::physics::rope::creep::{CreepState, CreepTension};
use crate::physics::tension::{Chord, Tension};
use crate::solve::State;

/// A segment in motion whose rope creeps.
pub(super) struct CreepingSegment<'a> {
    rope: &'a CreepingRope,
    past: &'a CreepState,
    /// Time since the last accepted step \[s\]; 0 where a method integrates the mean strain itself.
    since: f64,
    /// Unstretched length \[m\].
    length: f64,
    strain: f64,
    /// Strain rate \[1/s\].
    rate: f64,
}

impl CreepingSegment<'_> {
    /// Its tension.
    pub(super) fn tension(&self) -> Tension {
        let found: CreepTension = self
            .rope
            .tension(self.strain, self.rate, self.past, self.since);
        Tension {
            value: found.tension,
            by_length: found.by_strain / self.length,
            by_speed: found.by_rate / self.length,
        }
    }

    /// Rate of its mean strain \[1/s\], at the mean strain that it remembers.
    fn mean_rate(&self) -> f64 {
        self.rope.mean_rate(self.strain, self.rate, self.past)
    }

    /// Elastic part of its tension \[N\], its energy \[J\] and the power that it loses as its mean strain changes \[W\].
    pub(super) fn energy(&self) -> (f64, f64, f64) {
        let energy = self.rope.energy(self.strain, self.past);
        let lost = energy.lost_by_mean * self.mean_rate();
        (
            energy.elastic,
            self.length * energy.stored,
            self.length * lost,
        )
    }
}

impl LumpedLine {
    /// Segment i at time t \[s\], if it is in motion and its rope creeps.
    pub(super) fn creeping<'a>(
        &'a self,
        i: usize,
        chord: &Chord,
        t: f64,
        state: &'a State,
    ) -> Option<CreepingSegment<'a>> {
        let past = state.memory.creep.get(i)?;
        let axial = &self.segments[i].axial;
        let rope = self.laws[usize::from(axial.law?)].creeping()?;
        let integrated = !state.creep_rates.is_empty();
        Some(CreepingSegment {
            rope,
            past,
            since: if integrated {
                0.0
            } else {
                t - state.memory.time
            },
            length: axial.length,
            strain: axial.strain(chord.length),
            rate: chord.tangent.dot(&chord.opening) * axial.inverse_length(),
        })
    }

    /// The chord of segment i that belongs to its tension at the last accepted step.
    #[inline(always)]
    pub(super) fn corrected_chord(&self, i: usize, chord: &Chord, state: &State) -> Chord {
        let excess = state.chord_correction.get(i).copied().unwrap_or(0.0);
        Chord {
            length: chord.length - excess,
            ..*chord
        }
    }

    /// Updates what ropes that creep remember by an accepted state, at time t \[s\], `dt` after the one before, but for that time, which
    /// [`LumpedLine::remember_ropes`] sets. `dt` 0 starts at rest.
    pub(super) fn remember_creep(&self, t: f64, dt: f64, state: &mut State) {
        if self.laws.iter().all(|law| law.creeping().is_none()) {
            return;
        }
        if dt <= 0.0 || state.memory.creep.len() != self.segments.len() {
            state.memory.creep.clear();
            for i in 0..self.segments.len() {
                let first = self.begin_creep(i, state);
                state.memory.creep.push(first);
            }
            return;
        }
        for i in 0..self.segments.len() {
            let chord = self.corrected_chord(i, &self.chord(i, state), state);
            let Some(segment) = self.creeping(i, &chord, t, state) else {
                continue;
            };
            state.memory.creep[i] = segment
                .rope
                .after(segment.strain, segment.past, segment.since);
        }
    }

    /// Whether a motion begins with another mean tension than that at rest, so that forces do not balance.
    #[must_use]
    pub fn begins_off_rest(&self) -> bool {
        let mut ropes = self.laws.iter().filter_map(|law| law.creeping());
        ropes.any(|rope| rope.initial_mean.is_some())
    }

    /// What segment i remembers at the start.
    fn begin_creep(&self, i: usize, state: &State) -> CreepState {
        let axial = &self.segments[i].axial;
        let law = axial.law.map(|law| &self.laws[usize::from(law)]);
        let rope = law.and_then(|law| law.creeping());
        let strain = axial.strain(self.chord(i, state).length);
        rope.map_or_else(CreepState::default, |rope| rope.begin(strain))
    }

    /// Writes the rates of the mean strains, where a method integrates these.
    pub fn write_creep_rates(&self, t: f64, state: &mut State) {
        for i in 0..state.creep_rates.len() {
            let rate = {
                let chord = self.chord(i, state);
                let segment = self.creeping(i, &chord, t, state);
                segment.map_or(0.0, |segment| segment.mean_rate())
            };
            state.creep_rates[i] = rate;
        }
    }
}
