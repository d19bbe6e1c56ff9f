//! Energy of a rigid payload, dissipation and wave power.

use super::RigidPayload;
use crate::numerics::V3;
use crate::physics::kirchhoff::RelativeMotion;
use crate::scene::{LumpedLine, submergence};
use crate::solve::State;

impl RigidPayload {
    /// Dissipation by drag, and by the added mass in a current \[W\].
    pub(super) fn dissipation(&self, line: &LumpedLine, state: &State) -> f64 {
        let there = self.water_around(line, state);
        let strips = self.strips(line, state);
        let drag = strips.map(|strip| {
            let drag = self.body.drag(&there.axis.tangent, &strip.u);
            drag.dot(&strip.v) * strip.part
        });
        let relative = self.moving(&there, state, [V3::zeros(); 2]);
        let own = self.in_still_water(line, state);
        let [streaming, still] = [relative, own].map(|m| self.body.added.velocity_terms(&m));
        let by_current =
            (streaming.0 - still.0).dot(&own.v) + (streaming.1 - still.1).dot(&own.turn);
        (by_current - drag.sum::<f64>()) * there.wet.0
    }

    /// Its motion in still water.
    fn in_still_water(&self, line: &LumpedLine, state: &State) -> RelativeMotion {
        RelativeMotion {
            t: line.chord(self.node, state).tangent,
            v: self.at(&state.v, self.body.buoyancy_at),
            a: V3::zeros(),
            turn: self.opening(&state.v) / self.body.reach,
            gain: V3::zeros(),
        }
    }

    /// Power of the pressure of waves and of their acceleration on the added mass, beyond its potential in still water \[W\].
    pub(in crate::scene) fn wave_power(&self, line: &LumpedLine, state: &State) -> f64 {
        let there = self.water_around(line, state);
        let dragged = self.body.added.matrix(&there.axis.tangent) * there.carried.0 * there.wet.0;
        let lost = V3::z() * (self.body.buoyancy * (self.wet_in_still_water(line, state) - 1.0));
        (self.lift(&there) + dragged - lost).dot(&self.at(&state.v, self.body.buoyancy_at))
    }

    /// Submerged fraction where the surface is still.
    fn wet_in_still_water(&self, line: &LumpedLine, state: &State) -> f64 {
        let Some(water) = line.water.as_ref().filter(|water| water.crossed) else {
            return 1.0;
        };
        let z = self.at(&state.x, self.body.buoyancy_at).z;
        submergence::sphere(water.radius_of(self.displaced(water)), z).0
    }

    /// Power that moving water puts into it by drag \[W\].
    pub(super) fn water_drag_power(&self, line: &LumpedLine, state: &State) -> f64 {
        let there = self.water_around(line, state);
        let by_strip = self.strips(line, state).map(|strip| {
            let drag = self.body.drag(&there.axis.tangent, &strip.u);
            drag.dot(&(strip.u + strip.v)) * strip.part
        });
        by_strip.sum::<f64>() * there.wet.0
    }

    /// Rate of the kinetic energy of its added mass by its submerged fraction alone \[W\]. Its turning is in the forces
    /// already, which follow from Lagrange's equations.
    pub(super) fn growth(&self, line: &LumpedLine, state: &State) -> f64 {
        let (at, by) = (self.body.buoyancy_at, self.wet(line, state).1);
        let shares = [self.node, self.node + 1].into_iter().zip([1.0 - at, at]);
        let rising: f64 = shares
            .map(|(node, share)| line.elevation_rate(node, state) * share)
            .sum();
        let rate = by.dot(&self.at(&state.v, at)) - by.z * rising;
        rate * self.body.added.energy(&self.in_still_water(line, state))
    }

    /// Potential of its lost buoyancy in still water \[J\].
    pub(in crate::scene) fn surface_energy(&self, line: &LumpedLine, state: &State) -> f64 {
        let Some(water) = line.water.as_ref().filter(|water| water.crossed) else {
            return 0.0;
        };
        let z = self.at(&state.x, self.body.buoyancy_at).z;
        let radius = water.radius_of(self.displaced(water));
        self.body.buoyancy.max(0.0) * submergence::sphere_lost_energy(radius, z)
    }

    /// Kinetic energy of its added mass, of the submerged fraction \[J\].
    pub(in crate::scene) fn kinetic_energy(&self, line: &LumpedLine, state: &State) -> f64 {
        let moving = self.in_still_water(line, state);
        self.body.added.energy(&moving) * self.wet(line, state).0
    }
}
