//! Rigid payload in the water: relative flow, submerged fraction, wave pressure and buoyancy.
//!
//! Waves act by drag on every strip and, at the centre of buoyancy, by their pressure and on the added mass. Across the surface all
//! of these count by the submerged fraction, and buoyancy is lost to a potential, as for a sphere of the same volume about the
//! centre of buoyancy.

use super::RigidPayload;
use crate::numerics::{M3, V3};
use crate::physics::RigidBody;
use crate::physics::sea::WaterMotion;
use crate::physics::tension::Chord;
use crate::scene::{LumpedLine, Water, submergence};
use crate::solve::State;

/// The body in the water.
pub(super) struct SurroundingWater {
    pub(super) axis: Chord,
    /// Velocity of the water at the centre of buoyancy \[m/s\], and its gradient \[1/s\].
    pub(super) flow: (V3, M3),
    /// Acceleration of the water there \[m/s²\], and its gradient \[1/s²\].
    pub(super) carried: (V3, M3),
    /// Submerged fraction, and its derivative by the position of the centre of buoyancy \[1/m\].
    pub(super) wet: (f64, V3),
    /// Mass of the water displaced \[kg\]; 0 without waves and surface.
    pub(super) displaced: f64,
}

/// A strip of the body for drag.
pub(super) struct Strip {
    /// Its place on the rod, and its fraction of the drag.
    pub(super) place: f64,
    pub(super) part: f64,
    /// Its velocity \[m/s\].
    pub(super) v: V3,
    /// Velocity of the water relative to it \[m/s\], and the gradient of the water's \[1/s\].
    pub(super) u: V3,
    pub(super) gradient: M3,
}

impl RigidPayload {
    /// Wave kinematics at both nodes, with their shares at a place on the rod.
    fn waves<'s>(
        &self,
        place: f64,
        state: &'s State,
    ) -> impl Iterator<Item = (f64, &'s WaterMotion)> {
        let nodes = (self.node..).zip(RigidBody::shares(place));
        nodes.filter_map(|(node, share)| Some((share, state.wave_flow.get(node)?)))
    }

    /// Velocity of the water at a place on the rod \[m/s\], and its gradient \[1/s\].
    fn flow(&self, line: &LumpedLine, place: f64, state: &State) -> (V3, M3) {
        let x = self.at(&state.x, place);
        let (mut velocity, mut gradient) = line.current.flow(&x);
        for (share, flow) in self.waves(place, state) {
            velocity += flow.velocity_at(&x) * share;
            gradient += flow.gradient * share;
        }
        (velocity, gradient)
    }

    pub(super) fn water_around(&self, line: &LumpedLine, state: &State) -> SurroundingWater {
        let lift_at = self.body.buoyancy_at;
        let centre = self.at(&state.x, lift_at);
        let mut carried = (V3::zeros(), M3::zeros());
        for (share, flow) in self.waves(lift_at, state) {
            carried.0 += flow.acceleration_at(&centre) * share;
            carried.1 += flow.acceleration_gradient * share;
        }
        SurroundingWater {
            axis: line.chord(self.node, state),
            flow: self.flow(line, lift_at, state),
            carried,
            wet: self.wet(line, state),
            displaced: line.water.as_ref().map_or(0.0, |w| self.displaced(w)),
        }
    }

    /// The strips for drag.
    pub(super) fn strips(&self, line: &LumpedLine, state: &State) -> impl Iterator<Item = Strip> {
        self.body.strips().map(move |(place, part)| {
            let (water, gradient) = self.flow(line, place, state);
            let v = self.at(&state.v, place);
            Strip {
                place,
                part,
                v,
                u: water - v,
                gradient,
            }
        })
    }

    /// Mass of the water it displaces \[kg\].
    pub(super) fn displaced(&self, water: &Water) -> f64 {
        (self.body.buoyancy / water.gravity).max(0.0)
    }

    /// Submerged fraction, as of a sphere of its volume about the centre of buoyancy, and its derivative by the position of that
    /// \[1/m\].
    pub(super) fn wet(&self, line: &LumpedLine, state: &State) -> (f64, V3) {
        let Some(water) = line.water.as_ref().filter(|w| w.crossed) else {
            return (1.0, V3::zeros());
        };
        let centre = self.at(&state.x, self.body.buoyancy_at);
        let (mut above, mut by_place) = (centre.z, V3::z());
        for (share, flow) in self.waves(self.body.buoyancy_at, state) {
            above -= flow.elevation_at(&centre) * share;
            by_place -= flow.slope * share;
        }
        let (share, slope) = submergence::sphere(water.radius_of(self.displaced(water)), above);
        (share, by_place * slope)
    }

    /// Wave pressure on the submerged part, less the buoyancy of the dry one: a load at the centre of buoyancy \[N\].
    pub(super) fn lift(&self, there: &SurroundingWater) -> V3 {
        self.lift_if_wet(there) * there.wet.0 - V3::z() * self.body.buoyancy
    }

    /// Wave pressure and buoyancy of the whole body \[N\].
    pub(super) fn lift_if_wet(&self, there: &SurroundingWater) -> V3 {
        there.carried.0 * there.displaced + V3::z() * self.body.buoyancy
    }
}
