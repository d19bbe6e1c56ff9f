//! The line's books of energy: what it has, what it loses, and what its ends and the waves put into it.
//!
//! `d(energy)/dt = power of ends + power of waves - dissipation + growth of the added mass`. The last is no force's work:
//! the added mass of a segment turns with it and grows as it gets wet, and the force by which the water resists is taken
//! as `M a` (Morison), without what Lagrange's equations add for a mass that changes, `v' (dM/dt) v / 2`: some 1e-5 to 1e-4
//! of what drag takes from a line under water.

use super::water::BodyInWater;
use super::{AttachedBody, End, Scene};
use crate::numerics::V3;
use crate::solve::{Kinematics, State};

impl Scene {
    /// Kinetic, potential and elastic energy \[J\]: weight in water, and in air of what is above still water where the line
    /// crosses the surface. Added mass counts as mass as far as it is wet. A traveller has its own, see
    /// [`Scene::traveller_energy`].
    #[must_use]
    pub fn energy(&self, state: &State) -> f64 {
        let mut energy = self.surface_energy(state) + self.bed_energy(state);
        for i in 0..self.nodes() {
            energy +=
                0.5 * self.mass[i] * state.v[i].norm_squared() + self.weight[i] * state.x[i].z;
        }
        for i in 0..self.segments.len() {
            let chord = self.chord(i, state);
            energy += self.elastic_energy(i, &chord, state);
            let added = self.added(i, self.wet(i, state).as_ref());
            for (v, added) in state.v[i..].iter().zip(added) {
                energy += 0.5 * v.dot(&added.force(&chord.tangent, v));
            }
        }
        if let Some(flexure) = &self.flexure {
            energy += flexure.energy(self, state);
        }
        for (number, AttachedBody { node, body }) in self.bodies.iter().enumerate() {
            let (v, share) = (&state.v[*node], self.body_in_water(number, state).share);
            energy += 0.5 * share * v.dot(&body.added.component_mul(v));
        }
        if let Some(rigid_payload) = &self.rigid_payload {
            energy += rigid_payload.energy(self, state);
        }
        energy
    }

    /// Power that drag, axial damping and the fading memory of ropes take out of the line \[W\], positive when energy is
    /// lost. Drag in a current or in waves may give as well.
    #[must_use]
    pub fn dissipation(&self, state: &State) -> f64 {
        let mut power = 0.0;
        for i in 0..self.segments.len() {
            let chord = self.chord(i, state);
            let viscous = self.tension_now(i, &chord, state).value - self.elastic(i, &chord, state);
            power += self.memory_dissipation(i, &chord, state);
            power += viscous * chord.tangent.dot(&chord.opening);
            let drag = self.drag(i, &chord, state).forces();
            for (node, drag) in [i, i + 1].into_iter().zip(drag) {
                power -= drag.dot(&state.v[node]);
            }
        }
        power += self.bed_dissipation(state);
        for (number, AttachedBody { node, body }) in self.bodies.iter().enumerate() {
            let BodyInWater { u, share, .. } = self.body_in_water(number, state);
            power -= body.drag(&u).dot(&state.v[*node]) * share;
        }
        if let Some(rigid_payload) = &self.rigid_payload {
            power += rigid_payload.dissipation(self, state);
        }
        power
    }

    /// Power that held ends put into the line as they move \[W\].
    #[must_use]
    pub fn power_of_ends(&self, t: f64, state: &State) -> f64 {
        let ends = self.ends.iter().zip([0, self.nodes() - 1]);
        let power = |(end, node): (&End, usize)| match end {
            End::Free => 0.0,
            End::Prescribed(_) => {
                let pull: V3 =
                    self.end_force(node, state) + self.traveller_force_on(node, t, state);
                -pull.dot(&state.v[node])
            }
        };
        ends.map(power).sum()
    }
}
