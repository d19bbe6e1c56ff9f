//! Outputs of a state: end forces, forces of the bed, positions.

use super::Scene;
use super::element::At;
use crate::numerics::{M3, V3};
use crate::solve::State;

impl Scene {
    /// Normal force of the bed on a node of the line and all bodies there \[N\]; negative where suction holds them.
    #[must_use]
    pub fn bed_force_at(&self, node: usize, state: &State) -> f64 {
        let bed = self.elements.bed.as_ref();
        let contact = self.elements.body_contact.as_ref();
        let bodies = contact.map_or(0.0, |contact| contact.normal_force_at(node, state));
        bed.map_or(0.0, |bed| bed.push(node, state).force) + bodies
    }

    /// The same on one clump by its number in the case, and the node of the line that it is on \[N\].
    #[must_use]
    pub fn bed_force_on_body(&self, number: usize, state: &State) -> f64 {
        let (bed, contact) = (&self.elements.bed, &self.elements.body_contact);
        let on_line = bed.as_ref().zip(self.labels.clumps.get(number));
        let on_line = on_line.map_or(0.0, |(bed, node)| bed.push(*node, state).force);
        let on_body = contact
            .as_ref()
            .map(|contact| contact.normal_force(number, state));
        on_line + on_body.unwrap_or(0.0)
    }

    /// Force of the line on the support of its first or last node \[N\]: all forces on that node, less its inertia.
    #[must_use]
    pub fn end_force(&self, node: usize, state: &State) -> V3 {
        let (pull, load) = self.end_loads(node, state);
        let force = pull + load;
        force + self.bed_on_end(node, (&pull, &load), state)
    }

    /// What the bed bears of [`Scene::end_force`] along its normal \[N\]: of the half segment at an end that lies on it.
    #[must_use]
    pub fn bed_reaction_on_end(&self, node: usize, state: &State) -> V3 {
        let (pull, load) = self.end_loads(node, state);
        let reaction = self.bed_on_end(node, (&pull, &load), state);
        self.elements.bed.as_ref().map_or(reaction, |bed| {
            let normal = bed.seabed.normal(&state.x[node]);
            normal * normal.dot(&reaction)
        })
    }

    /// Derivative of [`Scene::bed_reaction_on_end`] by the place of the end, as far as that turns the normal of the bed \[N/m\]: along the bed all
    /// of it; nothing on a plane.
    #[must_use]
    pub fn bed_reaction_turning(&self, node: usize, state: &State) -> M3 {
        let reaction = self.bed_reaction_on_end(node, state);
        let bed = self.elements.bed.as_ref();
        let slope = bed.and_then(|bed| bed.seabed.normal_slope(&state.x[node]));
        slope.map_or_else(M3::zeros, |slope| slope * reaction.norm())
    }

    fn bed_on_end(&self, node: usize, loads: (&V3, &V3), state: &State) -> V3 {
        let bed = self.elements.bed.as_ref();
        bed.map_or_else(V3::zeros, |bed| {
            bed.force_on_end(node, loads, self.now(state))
        })
    }

    /// The pull of its segment on the first or last node, and all else on it but the bed, less its inertia \[N\].
    fn end_loads(&self, node: usize, state: &State) -> (V3, V3) {
        let (i, sign) = if node == 0 {
            (0, 1.0)
        } else {
            (node - 1, -1.0)
        };
        let chord = self.line.chord(i, state);
        let (t, a) = (&chord.tangent, &state.a[node]);
        let wet = self.line.wet(i, state);
        let pull = t * (self.line.tension_now(i, &chord, state).value * sign);
        let drag = self.line.submerged_drag(i, &chord, state, wet.as_ref());
        let mut force = pull + drag.forces()[node - i]
            - V3::z() * self.line.weight[node]
            - a * self.line.mass[node]
            - self.line.added(i, wet.as_ref())[node - i]
                .force(t, &self.line.relative_acceleration(node, state));
        for element in self.elements.iter() {
            element.add_end_force(self.now(state), node, &mut force);
        }
        (pull, force - pull)
    }

    /// Curvature \[1/m\] and bending moment \[N m\] at end A or B of the line; nothing at a hinge.
    #[must_use]
    pub fn bending_at_end(&self, at_b: bool, state: &State) -> (f64, f64) {
        let node = if at_b { self.line_nodes() - 1 } else { 0 };
        let flexure = self.elements.flexure.as_ref();
        flexure.map_or((0.0, 0.0), |flexure| {
            flexure.bent_at(node, &self.line, state)
        })
    }

    /// The greatest angle between taut neighbouring segments \[rad\] and its node, without nodes that carry a body: straight segments
    /// approximate a curve only if it is small.
    #[must_use]
    pub fn sharpest_turn(&self, state: &State) -> (f64, usize) {
        let taut = |i: usize| {
            let chord = self.line.chord(i, state);
            let pulls = self.line.tension_now(i, &chord, state).value > 0.0;
            pulls.then_some(chord.tangent)
        };
        let turn = |node: usize| {
            let bare = self.line.bodies.iter().all(|hung| hung.node != node);
            let cos = taut(node - 1)?.dot(&taut(node)?);
            bare.then(|| (cos.clamp(-1.0, 1.0).acos(), node))
        };
        (1..self.line_nodes() - 1)
            .filter_map(turn)
            .fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a })
    }

    /// Where elements are evaluated at the time of the last accepted step.
    pub(super) fn now<'a>(&'a self, state: &'a State) -> At<'a> {
        self.at(state.memory.time, state)
    }

    /// Unstretched arc length of the traveller at time t \[m\]; none without one.
    #[must_use]
    pub fn traveller_arc(&self, t: f64, state: &State) -> Option<f64> {
        let traveller = self.elements.traveller.as_ref();
        traveller.map(|traveller| traveller.at(state.memory.traveller_kinks, t).0)
    }

    /// Position \[m\] and velocity \[m/s\] of the traveller at time t; none without one.
    #[must_use]
    pub fn traveller_at(&self, t: f64, state: &State) -> Option<(V3, V3)> {
        let traveller = self.elements.traveller.as_ref()?;
        let point = traveller.path_point(&self.line, t, state);
        Some((point.place(state), point.velocity(state)))
    }

    /// Tension of the segment that the traveller is on \[N\]; none without one.
    #[must_use]
    pub fn traveller_tension(&self, t: f64, state: &State) -> Option<f64> {
        let traveller = self.elements.traveller.as_ref()?;
        let point = traveller.path_point(&self.line, t, state);
        let chord = self.line.chord(point.segment, state);
        Some(self.line.pull(point.segment, &chord, t, state).value)
    }

    /// Load of the traveller on a prescribed end while it is on the segment there \[N\].
    #[must_use]
    pub fn traveller_force_on(&self, node: usize, t: f64, state: &State) -> V3 {
        let traveller = self.elements.traveller.as_ref();
        traveller.map_or_else(V3::zeros, |traveller| {
            traveller.force_on(node, self.at(t, state))
        })
    }

    /// Nodes of the line itself, without the far node of a rigid payload.
    #[must_use]
    pub fn line_nodes(&self) -> usize {
        self.line.line_nodes
    }

    /// Position of end B \[m\]: its last node, or the centre of gravity of a rigid payload there.
    #[must_use]
    pub fn end_b_position(&self, state: &State) -> V3 {
        self.at_end_b(&state.x)
    }

    /// Velocity of end B \[m/s\], likewise.
    #[must_use]
    pub fn end_b_velocity(&self, state: &State) -> V3 {
        self.at_end_b(&state.v)
    }

    fn at_end_b(&self, values: &[V3]) -> V3 {
        match &self.elements.rigid_payload {
            Some(rigid_payload) => rigid_payload.at(values, rigid_payload.body.centre),
            None => values[values.len() - 1],
        }
    }

    /// Angle between the axis of a rigid payload and the vertical \[rad\]; 0 without one.
    #[must_use]
    pub fn tilt(&self, state: &State) -> f64 {
        self.elements
            .rigid_payload
            .as_ref()
            .map_or(0.0, |rigid_payload| {
                let t = self.line.chord(rigid_payload.node, state).tangent;
                t.x.hypot(t.y).atan2(-t.z)
            })
    }
}
