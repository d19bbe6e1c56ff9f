//! The segments in the residual and in the tangent: pull, drag and added mass of both halves of every one.
//!
//! A line in a uniform current, of materials that stretch in proportion, pays for nothing else: whether there are waves, a
//! surface, shear, laws of ropes or tensions foretold is asked once a call, and the loop over the segments is compiled
//! for either answer. What surrounds a node is worked out once and serves the segments on both its sides.

use super::Scene;
use super::half::{Half, pull_by_chord};
use super::wetting::Wet;
use crate::linalg::{BlockBand, V3};
use crate::physics::Current;
use crate::physics::drag::Drag;
use crate::physics::tension::{Chord, Tension};
use crate::solve::{Factors, State};

/// What surrounds a node.
#[derive(Clone, Copy)]
pub(super) struct Around {
    /// Velocity of the water relative to it \[m/s\].
    u: V3,
    /// Its acceleration relative to the water's \[m/s²\].
    a: V3,
    /// Shear of the current \[1/s\]; nothing where the current is uniform.
    shear: V3,
}

impl Scene {
    /// Adds the segments to the residual.
    pub(super) fn add_segments(&self, t: f64, state: &State, r: &mut [V3]) {
        if self.is_plain(state) {
            self.add_segments_as::<true>(t, state, r);
        } else {
            self.add_segments_as::<false>(t, state, r);
        }
    }

    /// Adds the segments to the residual and to the tangent, whose blocks beside the diagonal they set.
    pub(super) fn linearise_segments(
        &self,
        t: f64,
        state: &State,
        c: Factors,
        r: &mut [V3],
        tangent: &mut BlockBand,
    ) {
        if self.is_plain(state) {
            self.linearise_segments_as::<true>(t, state, c, r, tangent);
        } else {
            self.linearise_segments_as::<false>(t, state, c, r, tangent);
        }
    }

    /// Whether a uniform current and the line's own stretch, in proportion, are all that acts on its segments.
    pub(super) fn is_plain(&self, state: &State) -> bool {
        matches!(self.current, Current::Uniform(_))
            && self.water.is_none()
            && self.laws.is_empty()
            && state.water.is_empty()
            && state.foretold.is_empty()
            && state.memory.held_drag.is_empty()
    }

    #[inline(always)]
    pub(super) fn around<const PLAIN: bool>(&self, node: usize, state: &State) -> Around {
        if PLAIN {
            let u = self.current.at(0.0).0 - state.v[node];
            return Around {
                u,
                a: state.a[node],
                shear: V3::zeros(),
            };
        }
        let x = &state.x[node];
        let (mut u, shear) = self.current.at(x.z);
        let mut a = state.a[node];
        if let Some(flow) = state.water.get(node) {
            u += flow.velocity_at(x);
            a -= flow.acceleration_at(x);
        }
        u -= state.v[node];
        Around { u, a, shear }
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

    /// How much of both halves is wet, and their drag.
    #[inline(always)]
    pub(super) fn drag_as<const PLAIN: bool>(
        &self,
        i: usize,
        chord: &Chord,
        [near, far]: [&Around; 2],
        state: &State,
    ) -> (Option<[Wet; 2]>, [Drag; 2]) {
        let length = 0.5 * self.wetted(i, chord).0;
        let u = [&near.u, &far.u];
        let profile = &self.segments[i].drag;
        if PLAIN {
            return (None, profile.drag(&chord.tangent, u, length, None));
        }
        let held = state.memory.held_drag.get(i);
        let full = profile.drag(&chord.tangent, u, length, held);
        match self.wet(i, state) {
            None => (None, full),
            Some(wet) => {
                let drag = [0, 1].map(|half| full[half].scaled(wet[half].share));
                (Some(wet), drag)
            }
        }
    }

    #[inline(always)]
    fn add_segments_as<const PLAIN: bool>(&self, t: f64, state: &State, r: &mut [V3]) {
        let mut near = self.around::<PLAIN>(0, state);
        for i in 0..self.segments.len() {
            let chord = self.chord(i, state);
            let along = &chord.tangent;
            let pull = along * self.tension_as::<PLAIN>(i, &chord, t, state).0.value;
            let far = self.around::<PLAIN>(i + 1, state);
            let (wet, drag) = self.drag_as::<PLAIN>(i, &chord, [&near, &far], state);
            let added = self.added(i, wet.as_ref());
            r[i] += added[0].force(along, &near.a) - drag[0].force - pull;
            r[i + 1] += added[1].force(along, &far.a) - drag[1].force + pull;
            near = far;
        }
    }

    #[inline(always)]
    fn linearise_segments_as<const PLAIN: bool>(
        &self,
        t: f64,
        state: &State,
        c: Factors,
        r: &mut [V3],
        tangent: &mut BlockBand,
    ) {
        let sheared = !PLAIN && matches!(self.current, Current::Table { .. });
        let mut near = self.around::<PLAIN>(0, state);
        for i in 0..self.segments.len() {
            let chord = self.chord(i, state);
            let (tension, foretold) = self.tension_as::<PLAIN>(i, &chord, t, state);
            let pull = chord.tangent * tension.value;
            r[i] -= pull;
            r[i + 1] += pull;
            let far = self.around::<PLAIN>(i + 1, state);
            let (wet, drag) = self.drag_as::<PLAIN>(i, &chord, [&near, &far], state);
            let added = self.added(i, wet.as_ref());
            let by_chord = pull_by_chord(&chord, &foretold, c);
            let stretch = self.wetted(i, &chord).1;
            let half = |k: usize, own: &Around, other: &Around, sign| Half {
                added: added[k],
                chord,
                pull: by_chord,
                drag: drag[k],
                other: drag[1 - k],
                a: own.a,
                shear: sheared.then_some([own.shear, other.shear]),
                stretch,
                sign,
            };
            let first = half(0, &near, &far, -1.0);
            tangent.upper[i] = first.add(c, &mut r[i], &mut tangent.diag[i]);
            let second = half(1, &far, &near, 1.0);
            tangent.lower[i + 1] = second.add(c, &mut r[i + 1], &mut tangent.diag[i + 1]);
            near = far;
        }
    }
}
