//! Effective tension at the nodes of the line.

use super::Scene;
use super::elements::HalfSegment;
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
    /// the line itself: what bears a body or an end is no tension.
    #[must_use]
    pub fn tension_at(&self, node: usize, state: &State) -> f64 {
        let last = self.line_nodes() - 1;
        self.tension_beside(node.min(last - 1), node, state)
    }

    /// The same by segment i, which begins or ends at the node.
    fn tension_beside(&self, i: usize, node: usize, state: &State) -> f64 {
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
        let force = pull + load;
        // With bending the force at a node has a shear part; tension is the part along the line.
        if self.elements.flexure.is_some() {
            force.dot(&chord.tangent) * sign
        } else {
            force.norm()
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
