//! Energy balance of the line:
//! `d(energy)/dt = power of ends + power of waves - dissipation + growth of the added mass`.
//!
//! The last is the work of no force: the added mass of a segment rotates with it and grows as it submerges, and the reaction of
//! the water is `M a` (Morison), without the term `v' (dM/dt) v / 2` of Lagrange's equations for a variable mass; some 1e-5 to
//! 1e-4 of the dissipation by drag under water.

use super::{EndCondition, Scene};
use crate::numerics::V3;
use crate::solve::{Kinematics, State};

impl Scene {
    /// Kinetic, potential and elastic energy \[J\]: submerged weight, and weight in air above still water where the line
    /// crosses the surface. Added mass counts as far as it is wet. See [`Scene::traveller_energy`] for a traveller.
    #[must_use]
    pub fn energy(&self, state: &State) -> f64 {
        let (line, elements) = (&self.line, &self.elements);
        let payload = elements.rigid_payload.as_ref();
        let lifted = payload.map_or(0.0, |payload| payload.surface_energy(line, state));
        let bed = elements.bed.as_ref().map_or(0.0, |bed| bed.energy(state));
        let mut energy = line.surface_energy(state) + lifted + bed;
        for i in 0..self.nodes() {
            energy +=
                0.5 * line.mass[i] * state.v[i].norm_squared() + line.weight[i] * state.x[i].z;
        }
        for i in 0..line.segments.len() {
            let chord = line.chord(i, state);
            energy += line.elastic_energy(i, &chord, state);
            let added = line.added(i, line.wet(i, state).as_ref());
            for (v, added) in state.v[i..].iter().zip(added) {
                energy += 0.5 * v.dot(&added.force(&chord.tangent, v));
            }
        }
        for element in elements.iter() {
            element.add_energy(self.at(state.memory.time, state), &mut energy);
        }
        energy
    }

    /// Power of drag, axial and mass damping and the fading memory of ropes \[W\], positive if energy is lost. Drag in a current or in
    /// waves may put energy in.
    #[must_use]
    pub fn dissipation(&self, state: &State) -> f64 {
        let line = &self.line;
        let mut power = 0.0;
        for i in 0..line.segments.len() {
            let chord = line.chord(i, state);
            let viscous = line.tension_now(i, &chord, state).value - line.elastic(i, &chord, state);
            power += line.memory_dissipation(i, &chord, state);
            power += viscous * chord.tangent.dot(&chord.opening);
            let drag = line.drag(i, &chord, state).forces();
            for (node, drag) in [i, i + 1].into_iter().zip(drag) {
                power -= drag.dot(&state.v[node]);
            }
        }
        for element in self.elements.iter() {
            element.add_dissipation(self.at(state.memory.time, state), &mut power);
        }
        power
    }

    /// Power of the prescribed motion of the ends \[W\].
    #[must_use]
    pub fn power_of_ends(&self, t: f64, state: &State) -> f64 {
        let ends = self.line.ends.iter().zip([0, self.nodes() - 1]);
        let power = |(end, node): (&EndCondition, usize)| match end {
            EndCondition::Free => 0.0,
            EndCondition::Prescribed(_) => {
                let pull: V3 =
                    self.end_force(node, state) + self.traveller_force_on(node, t, state);
                -pull.dot(&state.v[node])
            }
        };
        ends.map(power).sum()
    }

    /// Power of the pressure of waves and of the inertia of the water they accelerate \[W\]; their drag counts in
    /// [`Scene::dissipation`].
    #[must_use]
    pub fn power_of_waves(&self, state: &State) -> f64 {
        if state.wave_flow.is_empty() {
            return 0.0;
        }
        // The potential of dry parts is that in still water: the work of the surface beyond it is the waves'.
        let mut power = 0.0;
        for element in self.elements.iter() {
            element.add_wave_power(self.at(state.memory.time, state), &mut power);
        }
        power
    }

    /// Kinetic and potential energy of the traveller \[J\], and the power that its drive and the water put into line and
    /// traveller \[W\]; none without a traveller.
    #[must_use]
    pub fn traveller_energy(&self, t: f64, state: &State) -> Option<(f64, f64)> {
        Some(self.elements.traveller.as_ref()?.energy(self.at(t, state)))
    }
}
