//! Effective tension at the nodes of the line.
//!
//! By a segment alone, tension is the force at a node along the chord. In a line that bends, that chord is turned from the tangent at the
//! node by half of what the line turns over the segment, so that it takes in a part of the shear `Q`: `Q k l / 2` for a curvature `k` and a
//! length `l`, of first order, with one sign in the segment before and the other in the segment after. The difference of both at a node gives
//! `Q k`, and so the tension to second order. It is known where nothing but the line is at the node, as neither `Q` nor `k` jumps there; at
//! ends, bodies and changes of stiffness it is taken from the next node. At a clamp the direction of the line is known, and all of the force.

use super::Scene;
use super::elements::{Flexure, HalfSegment};
use crate::numerics::V3;
use crate::physics::tension::Chord;
use crate::solve::State;

impl Scene {
    /// Tensions at all nodes of the line \[N\].
    #[must_use]
    pub fn tensions(&self, state: &State) -> Vec<f64> {
        (0..self.line_nodes())
            .map(|i| self.tension_at(i, state))
            .collect()
    }

    /// Effective tension of the line at a node \[N\]: that of the segment after it (before it at the last node), with the
    /// weight, drag and inertia of the half segment between the node and the middle of the segment. The top tension of a
    /// hanging line is so its whole weight on any mesh. Of the bed's reaction on the node it contains the part that bears
    /// the line itself: what bears a body or an end is no tension. In a line that bends, the part of shear in it is taken out.
    #[must_use]
    pub fn tension_at(&self, node: usize, state: &State) -> f64 {
        let last = self.line_nodes() - 1;
        self.tension_beside(node.min(last - 1), node, state)
    }

    /// The same by segment i, which begins or ends at the node.
    fn tension_beside(&self, i: usize, node: usize, state: &State) -> f64 {
        let own = self.tension_along(i, node, state);
        let flexure = self.elements.flexure.as_ref();
        let Some(flexure) = flexure.filter(|flexure| !flexure.is_clamped(node)) else {
            return own;
        };
        let by_shear = |at: usize| {
            let [before, after] = [at - 1, at].map(|j| match (j, at) == (i, node) {
                true => own,
                false => self.tension_along(j, at, state),
            });
            flexure.shear_in_tension(at, before, after)
        };
        let nodes = [node, 2 * i + 1 - node].into_iter();
        let known = nodes.filter(|at| flexure.is_even(*at)).find_map(by_shear);
        let part = known.unwrap_or(0.0) * self.line.segments[i].axial.length;
        if node == i { own - part } else { own + part }
    }

    /// Force at a node along the chord of segment i, which begins or ends there, or along the clamp that holds it \[N\].
    fn tension_along(&self, i: usize, node: usize, state: &State) -> f64 {
        let sign = if node == i { 1.0 } else { -1.0 };
        let chord = self.line.chord(i, state);
        let pull = chord.tangent * (self.line.tension_now(i, &chord, state).value * sign);
        // A slack segment has no direction: the load of its half is no tension.
        if pull == V3::zeros() {
            return 0.0;
        }
        let load = self.half_load(i, node, &chord, state);
        self.tension_from((i, node - i), &chord, (&pull, load), state)
    }

    /// Tension of the pipe wall at the first or last node of a section, by its number \[N\]; none where it has no bore.
    #[must_use]
    pub fn wall_tension(&self, section: usize, at_end: bool, state: &State) -> Option<f64> {
        let wall = self.walls.get(section)?.as_ref()?;
        let node = self.labels.joints[section + usize::from(at_end)].node;
        let tension = self.tension_beside(node - usize::from(at_end), node, state);
        Some(wall.tension(tension, state.x[node].z))
    }

    /// Tension at a node of segment i from the pull of the segment on it and the load of the half between, without the bed.
    #[inline(always)]
    pub(super) fn tension_from(
        &self,
        (i, half): (usize, usize),
        chord: &Chord,
        (pull, mut load): (&V3, V3),
        state: &State,
    ) -> f64 {
        let sign = if half == 0 { 1.0 } else { -1.0 };
        if let Some(bed) = &self.elements.bed {
            let half = HalfSegment {
                segment: i,
                node: i + half,
                tangent: chord.tangent,
                pull: *pull,
                load,
            };
            load += bed.reaction_on_half(&half, self.now(state));
        }
        let (line, node, force) = (&self.line, i + half, pull + load);
        let Some(flexure) = &self.elements.flexure else {
            return force.norm();
        };
        // With bending the force at a node has a shear part; tension is the part along the line.
        match flexure.clamp_at(node, state) {
            Some(along) => (force + flexure.end_force(line, node, state)).dot(&along) * sign,
            None => force.dot(&chord.tangent) * sign,
        }
    }

    /// Weight, drag and (negative) inertia of the half of segment i at one of its nodes \[N\].
    #[inline(always)]
    fn half_load(&self, i: usize, node: usize, chord: &Chord, state: &State) -> V3 {
        let segment = &self.line.segments[i];
        let half = node - i;
        let wet = self.line.wet(i, state);
        let drag = self.line.submerged_drag(i, chord, state, wet.as_ref());
        // Forces only, so that the terms of the tangents are not computed.
        let drag = drag.forces()[half];
        let relative = self.line.relative_acceleration(node, state);
        let added = self.line.added(i, wet.as_ref())[half].force(&chord.tangent, &relative);
        let inertia = state.a[node] * segment.half_mass + added;
        let load = drag - inertia - V3::z() * segment.half_weight;
        if self.line.water.is_some() {
            load + self.line.pressure(i, half, wet.as_ref(), state)
        } else {
            load
        }
    }
}

/// The tensions at the nodes of a line that bends, as [`Scene::tension_at`], while its segments are read one after another.
#[derive(Default)]
pub(super) struct BothSides {
    /// Force at the end of the segment before along its chord \[N\], and its length \[m\].
    before: (f64, f64),
    /// Whether the tension at the node before that is known, from both of its sides or by a clamp.
    known: bool,
}

impl BothSides {
    /// Takes in segment i, of this length \[m\], by the forces at both its nodes along its chord \[N\].
    pub(super) fn add(
        &mut self,
        flexure: &Flexure,
        (i, length): (usize, f64),
        [near, far]: [f64; 2],
        tensions: &mut [f64],
    ) {
        let (before, length_before) = self.before;
        let even = flexure.is_even(i);
        let shear = even
            .then(|| flexure.shear_in_tension(i, before, near))
            .flatten();
        let part = shear.unwrap_or(0.0);
        if !self.known && i > 0 {
            tensions[i - 1] -= part * length_before;
        }
        tensions[i] = near - part * length;
        // Of the last node; at others the next segment has its own.
        let free = !flexure.is_clamped(i + 1);
        tensions[i + 1] = if free { far + part * length } else { far };
        self.before = (far, length);
        self.known = shear.is_some() || flexure.is_clamped(i);
    }
}
