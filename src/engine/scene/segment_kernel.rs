//! Segment kernel: mass and weight of the nodes, and tension, drag and added mass of both halves of every segment, in the
//! residual and the tangent, in one pass.
//!
//! The pass is compiled twice: a line of constant EA in a uniform current does not pay for waves, the surface, shear, laws of
//! ropes or extrapolated tensions, which are tested once a call. The surroundings of a node are computed once for the segments
//! on both its sides, and both halves of a segment in the two lanes of a register.

use super::LumpedLine;
use super::segment_block::{SegmentKinematics, SegmentPass};
use super::segment_tangent::{SegmentHalves, SegmentTangent, pull_by_chord};
use super::submergence::Submergence;
use crate::numerics::lanes::{self, Two};
use crate::numerics::{BlockBand, M3, V3};
use crate::physics::CurrentProfile;
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::Drag;
use crate::physics::tension::{Chord, Tension};
use crate::solve::{Factors, State};

impl LumpedLine {
    /// Sets the residual to that of the nodes (mass and weight) and segments.
    pub(super) fn segment_residual(&self, t: f64, state: &State, r: &mut [V3]) {
        if self.is_plain(state) {
            self.residual_as::<true>(t, state, r);
        } else {
            self.residual_as::<false>(t, state, r);
        }
    }

    /// Sets the same residual, and its tangent without the far blocks.
    pub(super) fn segment_tangent(
        &self,
        t: f64,
        state: &State,
        c: Factors,
        r: &mut [V3],
        tangent: &mut BlockBand,
    ) {
        if self.is_plain(state) {
            self.linearise_as::<true>(t, state, c, r, tangent);
        } else {
            self.linearise_as::<false>(t, state, c, r, tangent);
        }
    }

    /// Whether the line has constant EA and the current is uniform, without waves, surface, extrapolated tensions or frozen drag.
    pub(super) fn is_plain(&self, state: &State) -> bool {
        matches!(self.current, CurrentProfile::Uniform(_))
            && self.water.is_none()
            && self.laws.is_empty()
            && state.wave_flow.is_empty()
            && state.extrapolated_tension.is_empty()
            && state.memory.drag_coefficients.is_empty()
    }

    #[inline(always)]
    pub(super) fn tension_as<const PLAIN: bool>(
        &self,
        i: usize,
        chord: &Chord,
        t: f64,
        state: &State,
    ) -> (Tension, Tension) {
        if PLAIN {
            let tension = self.segments[i].axial.tension(chord);
            (tension, tension)
        } else {
            self.tension(i, chord, t, state)
        }
    }

    /// Submerged fractions of both halves of segment i, and their drag.
    #[inline(always)]
    pub(super) fn drag_as<const PLAIN: bool>(
        &self,
        i: usize,
        segment: &SegmentKinematics<'_>,
        state: &State,
    ) -> (Option<[Submergence; 2]>, Drag<Two>) {
        let chord = segment.chord;
        let length = 0.5 * self.wetted_length(i, chord).0;
        let profile = &self.segments[i].drag;
        if PLAIN {
            return (
                None,
                profile.by_parts(&chord.tangent, segment.parts, length, None),
            );
        }
        let held = state.memory.drag_coefficients.get(i);
        let full = profile.by_parts(&chord.tangent, segment.parts, length, held);
        match self.wet(i, state) {
            None => (None, full),
            Some(wet) => {
                let drag = full.scaled(Two::new([wet[0].share, wet[1].share]));
                (Some(wet), drag)
            }
        }
    }

    #[inline(always)]
    fn residual_as<const PLAIN: bool>(&self, t: f64, state: &State, r: &mut [V3]) {
        let segments = self.segments.len();
        let mut pass = SegmentPass::<PLAIN>::new(self, state);
        let mut here = self.lumped_load(0, state);
        for (i, out) in r[..segments].iter_mut().enumerate() {
            let segment = pass.segment(i, self, state);
            let (chord, [near, far]) = (segment.chord, segment.nodes);
            let pull = chord.tangent * self.tension_as::<PLAIN>(i, chord, t, state).0.value;
            let (wet, drag) = self.drag_as::<PLAIN>(i, &segment, state);
            let added = AddedMass::of_halves(self.added(i, wet.as_ref()));
            let a = lanes::vectors(&near.a, &far.a);
            let load = added.force(&lanes::twice(&chord.tangent), &a) - drag.force;
            *out = here + lanes::vector(&load, 0) - pull;
            here = self.lumped_load(i + 1, state) + lanes::vector(&load, 1) + pull;
        }
        r[segments] = here;
    }

    #[inline(always)]
    fn linearise_as<const PLAIN: bool>(
        &self,
        t: f64,
        state: &State,
        c: Factors,
        r: &mut [V3],
        tangent: &mut BlockBand,
    ) {
        let segments = self.segments.len();
        let (r, diag) = (&mut r[..=segments], &mut tangent.diag[..=segments]);
        let (upper, lower) = (
            &mut tangent.upper[..=segments],
            &mut tangent.lower[..=segments],
        );
        let sheared = !PLAIN && !matches!(self.current, CurrentProfile::Uniform(_));
        let mut pass = SegmentPass::<PLAIN>::new(self, state);
        // Row of the node so far: its own part and that of the segment before it.
        let mut here = (self.lumped_load(0, state), self.lumped_mass(0, c));
        for i in 0..segments {
            let segment = pass.segment(i, self, state);
            let (chord, [near, far]) = (segment.chord, segment.nodes);
            let (tension, extrapolated) = self.tension_as::<PLAIN>(i, chord, t, state);
            let pull = chord.tangent * tension.value;
            let (wet, drag) = self.drag_as::<PLAIN>(i, &segment, state);
            let halves = SegmentHalves {
                added: AddedMass::of_halves(self.added(i, wet.as_ref())),
                chord,
                pull: pull_by_chord(chord, &extrapolated, c),
                drag: &drag,
                a: lanes::vectors(&near.a, &far.a),
                shear: sheared.then(|| lanes::vectors(&near.shear, &far.shear)),
                stretch: self.wetted_length(i, chord).1,
            };
            let load = halves.load();
            let SegmentTangent { own, coupling } = halves.slopes(c);
            r[i] = here.0 + lanes::vector(&load, 0) - pull;
            diag[i] = here.1 + lanes::block(&own, 0);
            upper[i] = lanes::block(&coupling, 0);
            lower[i + 1] = lanes::block(&coupling, 1);
            here = (
                self.lumped_load(i + 1, state) + lanes::vector(&load, 1) + pull,
                self.lumped_mass(i + 1, c) + lanes::block(&own, 1),
            );
        }
        (r[segments], diag[segments]) = here;
    }

    /// Inertia of a node less its weight.
    #[inline(always)]
    fn lumped_load(&self, node: usize, state: &State) -> V3 {
        let mut load = state.a[node] * self.mass[node];
        load.z += self.weight[node];
        load
    }

    /// Its derivative.
    #[inline(always)]
    fn lumped_mass(&self, node: usize, c: Factors) -> M3 {
        M3::from_diagonal_element(c.mass * self.mass[node])
    }
}
