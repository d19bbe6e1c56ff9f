//! What is read off a state: tensions at nodes, loads, energies.

use super::water::BodyInWater;
use super::{AttachedBody, Scene};
use crate::numerics::V3;
use crate::physics::tension::Chord;
use crate::solve::State;

impl Scene {
    /// Tension at node i \[N\], from the segment after it (before it at the last node): its pull, with the
    /// weight, drag and inertia of the half segment between the node and the segment's middle. So a
    /// hanging line's top tension is its whole weight, whatever the mesh.
    #[must_use]
    pub fn tension_at(&self, node: usize, state: &State) -> f64 {
        let last = self.line_nodes() - 1;
        let (i, sign) = if node < last {
            (node, 1.0)
        } else {
            (last - 1, -1.0)
        };
        let chord = self.chord(i, state);
        let pull = chord.tangent * self.tension_now(i, &chord, state).value;
        let load = self.half_load(i, node, &chord, state);
        let load = match &self.bed {
            None => load,
            Some(_) => load + self.bed_force_on_half(i, node, (&(pull * sign), &load), state),
        };
        // A slack segment has no direction to speak of: its half's load is then no tension.
        if pull == V3::zeros() {
            return 0.0;
        }
        let force = pull + load * sign;
        // With bending the force at a node has a shear part as well; the tension is the part along the line.
        if self.flexure.is_some() {
            force.dot(&chord.tangent)
        } else {
            force.norm()
        }
    }

    /// Weight, drag and (negative) inertia of the half of segment i at one of its nodes \[N\].
    #[inline(always)]
    fn half_load(&self, i: usize, node: usize, chord: &Chord, state: &State) -> V3 {
        let segment = &self.segments[i];
        let half = node - i;
        let wet = self.wet(i, state);
        let drag = self.submerged_drag(i, chord, state, wet.as_ref());
        // Forces alone: what their tangents need is then never worked out.
        let drag = drag.forces()[half];
        let relative = self.relative_acceleration(node, state);
        let added = self.added(i, wet.as_ref())[half].force(&chord.tangent, &relative);
        let inertia = state.a[node] * segment.half_mass + added;
        let load = drag - inertia - V3::z() * segment.half_weight;
        if self.water.is_some() {
            load + self.pressure(i, half, wet.as_ref(), state)
        } else {
            load
        }
    }

    /// Tensions at all nodes of the line \[N\].
    #[must_use]
    pub fn tensions(&self, state: &State) -> Vec<f64> {
        (0..self.line_nodes())
            .map(|i| self.tension_at(i, state))
            .collect()
    }

    /// The line's pull on its first or last node's holder \[N\]: all forces on that node, less its inertia.
    #[must_use]
    pub fn end_force(&self, node: usize, state: &State) -> V3 {
        let (i, sign) = if node == 0 {
            (0, 1.0)
        } else {
            (node - 1, -1.0)
        };
        let chord = self.chord(i, state);
        let (t, a) = (&chord.tangent, &state.a[node]);
        let wet = self.wet(i, state);
        let pull = t * (self.tension_now(i, &chord, state).value * sign);
        let drag = self.submerged_drag(i, &chord, state, wet.as_ref());
        let mut force = pull + drag.forces()[node - i]
            - V3::z() * self.weight[node]
            - a * self.mass[node]
            - self.added(i, wet.as_ref())[node - i]
                .force(t, &self.relative_acceleration(node, state));
        if self.water.is_some() {
            force += self.pressure(i, node - i, wet.as_ref(), state);
        }
        for (number, AttachedBody { node: at, body }) in self.bodies.iter().enumerate() {
            if *at == node {
                let BodyInWater {
                    u, a, share, load, ..
                } = self.body_in_water(number, state);
                force += (body.drag(&u) - body.added.component_mul(&a)) * share + load;
            }
        }
        if let Some(flexure) = &self.flexure {
            force += flexure.end_force(self, node, state);
        }
        if self.bed.is_some() {
            force += self.bed_force_on_half(i, node, (&pull, &(force - pull)), state);
        }
        force
    }

    /// The greatest angle between taut neighbouring segments \[rad\] and its node, those with a body left out: it must be
    /// small where straight segments are to stand for a curve.
    #[must_use]
    pub fn sharpest_turn(&self, state: &State) -> (f64, usize) {
        let taut = |i: usize| {
            let chord = self.chord(i, state);
            let pulls = self.tension_now(i, &chord, state).value > 0.0;
            pulls.then_some(chord.tangent)
        };
        let turn = |node: usize| {
            let bare = self.bodies.iter().all(|hung| hung.node != node);
            let cos = taut(node - 1)?.dot(&taut(node)?);
            bare.then(|| (cos.clamp(-1.0, 1.0).acos(), node))
        };
        (1..self.line_nodes() - 1)
            .filter_map(turn)
            .fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a })
    }

    /// The greatest acceleration \[m/s²\] that segments which are slack at `between` and taut at `end` give a node there.
    pub(super) fn acceleration_by_snaps(&self, between: &State, end: &State) -> f64 {
        let mut jolt = 0.0_f64;
        for (i, segment) in self.segments.iter().enumerate() {
            let unstretched = segment.axial.length * segment.axial.length;
            let taut = |s: &State| (s.x[i + 1] - s.x[i]).norm_squared() > unstretched;
            if taut(end) && !taut(between) && !segment.axial.rod {
                let stretch = (end.x[i + 1] - end.x[i]).norm() - segment.axial.length;
                let pull = segment.axial.ea * stretch / segment.axial.length;
                jolt = jolt.max(pull / self.mass[i].min(self.mass[i + 1]));
            }
        }
        jolt
    }
}
