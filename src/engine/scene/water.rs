//! Waves and the water surface around the line, where the case names them.
//!
//! Morison's equation in moving water (DNV-RP-C205 section 6.2): drag by the relative velocity, added mass by the relative
//! acceleration, and the displaced mass times the acceleration of the water (Froude-Krylov). The last acts along the line as
//! well as transverse to it, since tensions are effective. The displaced mass is the mass in air less that in water, floats and
//! modules included.
//!
//! Where the line crosses the surface, all of these count by the submerged fraction of each half segment, and buoyancy is lost to
//! a potential: see `scene/submergence.rs`.

use super::submergence::{self, NodeHeight, Submergence};
use super::{AttachedBody, LumpedLine, Segment};

use crate::numerics::V3;
use crate::physics::added_mass::AddedMass;
use crate::physics::sea::{Sea, WaterMotion};
use crate::solve::State;

/// Waves and the surface, where the case names them.
#[derive(Debug, Clone, PartialEq)]
pub struct Water {
    /// The waves, if there are any.
    pub waves: Option<Sea>,
    /// Whether the line crosses the surface; if not, all of it counts as submerged.
    pub crossed: bool,
    /// Mass of the water displaced by half of each segment \[kg\].
    pub displaced: Vec<f64>,
    /// Radius of a line of each segment's volume \[m\].
    pub radius: Vec<f64>,
    /// Mass of the water displaced by each body on the line \[kg\].
    pub by_bodies: Vec<f64>,
    /// Acceleration of gravity \[m/s²\].
    pub gravity: f64,
    /// Density of the water \[kg/m³\].
    pub density: f64,
    /// Position of the wave gauge \[m\].
    pub gauge: V3,
}

impl Water {
    /// Potential of the buoyancy lost by the dry part of segment i, by gravity \[J s²/m\].
    fn lost_by(&self, i: usize, state: &State) -> f64 {
        let heights = [i, i + 1].map(|node| state.x[node].z);
        2.0 * self.displaced[i] * submergence::lost_buoyancy(self.radius[i], heights).energy
    }

    /// The water around these segments and bodies.
    #[must_use]
    pub fn around(
        segments: &[Segment],
        bodies: &[AttachedBody],
        (density, gravity): (f64, f64),
        waves: Option<Sea>,
        crossed: bool,
    ) -> Self {
        let under = |mass: f64, weight: f64| (mass - weight / gravity).max(0.0);
        let displaced: Vec<f64> = segments
            .iter()
            .map(|s| under(s.half_mass, s.half_weight))
            .collect();
        let radius = segments.iter().zip(&displaced).map(|(s, half)| {
            let area = 2.0 * half / (density * s.axial.length);
            (area / std::f64::consts::PI)
                .sqrt()
                .max(0.5 * s.diameter)
                .max(LEAST_RADIUS)
        });
        let radius = radius.collect();
        let bodies = bodies.iter().map(|h| under(h.body.mass, h.body.weight));
        Self {
            waves,
            crossed,
            displaced,
            radius,
            by_bodies: bodies.collect(),
            gravity,
            density,
            gauge: V3::zeros(),
        }
    }

    /// Buoyancy that half of segment i loses between nodes at these heights above the surface \[m\], a load downwards \[N\].
    #[inline(always)]
    fn lost_buoyancy(&self, i: usize, half: usize, heights: [f64; 2]) -> V3 {
        let lost = submergence::lost_buoyancy(self.radius[i], heights).lost[half];
        V3::z() * (-2.0 * self.displaced[i] * self.gravity * lost)
    }

    /// Radius of a sphere of the volume of a body \[m\].
    pub(super) fn radius_of_body(&self, body: usize) -> f64 {
        self.radius_of(self.by_bodies[body])
    }

    /// Radius of a sphere of water of this mass \[m\].
    pub(super) fn radius_of(&self, mass: f64) -> f64 {
        let volume = mass / self.density;
        (0.75 * volume / std::f64::consts::PI)
            .cbrt()
            .max(LEAST_RADIUS)
    }
}

/// Least radius of a line that crosses the surface \[m\].
const LEAST_RADIUS: f64 = 1e-6;

/// A point body in the water: relative motion and submerged fraction.
pub(super) struct BodyInWater {
    /// Velocity of the water relative to it \[m/s\].
    pub(super) u: V3,
    /// Its acceleration relative to the water's \[m/s²\].
    pub(super) a: V3,
    /// Acceleration of the water \[m/s²\].
    pub(super) carried: V3,
    /// Submerged fraction, and its derivative by the position of the body \[1/m\].
    pub(super) share: f64,
    pub(super) by_place: V3,
    /// Pressure of the wave and buoyancy lost \[N\].
    pub(super) load: V3,
}

impl LumpedLine {
    /// Puts waves into the water around the line, of this density \[kg/m³\] and under this gravity \[m/s²\].
    pub fn put_into_waves(&mut self, sea: &Sea, (density, gravity): (f64, f64)) {
        let bodies = &self.bodies;
        let water = self.water.get_or_insert_with(|| {
            Water::around(&self.segments, bodies, (density, gravity), None, false)
        });
        water.waves = Some(sea.clone());
    }

    /// Height of the waves above still water over the gauge at a time \[s\], in metres; 0 without waves.
    #[must_use]
    pub fn elevation(&self, time: f64) -> f64 {
        let water = self.water.as_ref();
        let waves = water.and_then(|water| Some((water.waves.as_ref()?, &water.gauge)));
        waves.map_or(0.0, |(waves, gauge)| waves.elevation(time, gauge))
    }

    /// Velocity of the water at a node \[m/s\].
    #[inline(always)]
    pub(super) fn water_at(&self, node: usize, state: &State) -> V3 {
        let current = self.current.at(&state.x[node]).0;
        match state.wave_flow.get(node) {
            None => current,
            Some(flow) => current + flow.velocity_at(&state.x[node]),
        }
    }

    /// Acceleration of a node relative to the water \[m/s²\].
    #[inline(always)]
    pub(super) fn relative_acceleration(&self, node: usize, state: &State) -> V3 {
        match state.wave_flow.get(node) {
            None => state.a[node],
            Some(flow) => state.a[node] - flow.acceleration_at(&state.x[node]),
        }
    }

    /// Submerged fractions of both halves of segment i; none if all of the line counts as submerged.
    #[inline(always)]
    pub(super) fn wet(&self, i: usize, state: &State) -> Option<[Submergence; 2]> {
        let water = self.water.as_ref().filter(|w| w.crossed)?;
        Some(submergence::halves(
            water.radius[i],
            [&height(i, state), &height(i + 1, state)],
        ))
    }

    /// Added mass of both halves of segment i, of their submerged fractions.
    #[inline(always)]
    pub(super) fn added(&self, i: usize, wet: Option<&[Submergence; 2]>) -> [AddedMass; 2] {
        let added = self.segments[i].added;
        match wet {
            None => [added; 2],
            Some(wet) => [0, 1].map(|half| added.scaled(wet[half].share)),
        }
    }

    /// Froude-Krylov force on half of segment i, less the buoyancy of its dry part \[N\].
    #[inline(always)]
    pub(super) fn pressure(
        &self,
        i: usize,
        half: usize,
        wet: Option<&[Submergence; 2]>,
        state: &State,
    ) -> V3 {
        let Some(water) = &self.water else {
            return V3::zeros();
        };
        let share = wet.map_or(1.0, |wet| wet[half].share);
        let mut load = self.lost_buoyancy(i, half, state);
        if let Some(flow) = state.wave_flow.get(i + half) {
            load += flow.acceleration_at(&state.x[i + half]) * (share * water.displaced[i]);
        }
        load
    }

    /// Lost buoyancy of half of segment i, a load downwards \[N\].
    #[inline(always)]
    pub fn lost_buoyancy(&self, i: usize, half: usize, state: &State) -> V3 {
        let Some(water) = self.water.as_ref().filter(|w| w.crossed) else {
            return V3::zeros();
        };
        let heights = [i, i + 1].map(|node| height(node, state).above);
        water.lost_buoyancy(i, half, heights)
    }

    /// The same in still water at the place of the line.
    pub(super) fn lost_in_still_water(&self, i: usize, half: usize, state: &State) -> V3 {
        let Some(water) = self.water.as_ref().filter(|w| w.crossed) else {
            return V3::zeros();
        };
        water.lost_buoyancy(i, half, [state.x[i].z, state.x[i + 1].z])
    }

    /// Lost buoyancy of a body in still water at its place, a load downwards \[N\].
    pub(super) fn body_lost_in_still_water(&self, number: usize, state: &State) -> V3 {
        let Some(water) = self.water.as_ref().filter(|w| w.crossed) else {
            return V3::zeros();
        };
        let z = state.x[self.bodies[number].node].z;
        let share = submergence::sphere(water.radius_of_body(number), z).0;
        V3::z() * (-(1.0 - share) * water.by_bodies[number] * water.gravity)
    }

    /// Rate at which the surface rises past a node \[m/s\].
    pub(super) fn elevation_rate(&self, node: usize, state: &State) -> f64 {
        state
            .wave_flow
            .get(node)
            .map_or(0.0, |flow| flow.elevation_rate)
    }

    /// The same with the force of the acceleration of the water on the added mass: the wave load on a node whose own acceleration
    /// is not known yet \[N\].
    pub(super) fn wave_force(
        &self,
        i: usize,
        half: usize,
        t: &V3,
        wet: Option<&[Submergence; 2]>,
        state: &State,
    ) -> V3 {
        let node = i + half;
        let with = |flow: &WaterMotion| {
            let a = flow.acceleration_at(&state.x[node]);
            self.added(i, wet)[half].force(t, &a)
        };
        self.pressure(i, half, wet, state) + state.wave_flow.get(node).map_or_else(V3::zeros, with)
    }

    /// The body of this number in the water.
    #[inline(always)]
    pub(super) fn body_in_water(&self, number: usize, state: &State) -> BodyInWater {
        let node = self.bodies[number].node;
        let flow = state.wave_flow.get(node);
        let carried = flow.map_or_else(V3::zeros, |flow| flow.acceleration_at(&state.x[node]));
        let mut around = BodyInWater {
            u: self.water_at(node, state) - state.v[node],
            a: self.relative_acceleration(node, state),
            carried,
            share: 1.0,
            by_place: V3::zeros(),
            load: V3::zeros(),
        };
        let Some(water) = &self.water else {
            return around;
        };
        (around.share, around.by_place) = self.body_submergence(number, state);
        let mass = water.by_bodies[number];
        around.load = carried * (around.share * mass)
            - V3::z() * ((1.0 - around.share) * mass * water.gravity);
        around
    }

    /// Submerged fraction of the body of this number, and its derivative by the position of the body \[1/m\].
    #[inline(always)]
    pub(super) fn body_submergence(&self, number: usize, state: &State) -> (f64, V3) {
        let Some(water) = self.water.as_ref().filter(|water| water.crossed) else {
            return (1.0, V3::zeros());
        };
        let height = height(self.bodies[number].node, state);
        let (share, slope) = submergence::sphere(water.radius_of_body(number), height.above);
        (share, height.by_place * slope)
    }

    /// Potential of the buoyancy lost by dry parts of the line in still water \[J\].
    pub(super) fn surface_energy(&self, state: &State) -> f64 {
        let Some(water) = self.water.as_ref().filter(|w| w.crossed) else {
            return 0.0;
        };
        let segments = 0..self.segments.len();
        let segments: f64 = segments.map(|i| water.lost_by(i, state)).sum();
        let numbered = self.bodies.iter().enumerate();
        let bodies = numbered.map(|(number, hung)| {
            let radius = water.radius_of_body(number);
            water.by_bodies[number] * submergence::sphere_lost_energy(radius, state.x[hung.node].z)
        });
        water.gravity * (segments + bodies.sum::<f64>())
    }

    /// The same of segment i alone.
    pub(super) fn surface_energy_of(&self, i: usize, state: &State) -> f64 {
        let crossed = self.water.as_ref().filter(|w| w.crossed);
        crossed.map_or(0.0, |water| water.gravity * water.lost_by(i, state))
    }
}

/// Height of a node above the surface.
#[inline(always)]
pub(super) fn height(node: usize, state: &State) -> NodeHeight {
    let x = &state.x[node];
    match state.wave_flow.get(node) {
        None => NodeHeight {
            above: x.z,
            by_place: V3::z(),
        },
        Some(flow) => NodeHeight {
            above: x.z - flow.elevation_at(x),
            by_place: V3::z() - flow.slope,
        },
    }
}
