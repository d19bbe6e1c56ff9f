//! Where the waves are read for a line: once a step at each node, for all evaluations at and near that state.

use super::Scene;
use super::water::Water;
use crate::physics::sea::{Sea, SeaClock, SeaReader, WaterMotion};
use crate::solve::State;

/// A state in which the waves were read a time before \[s\], the nodes close to where they are now.
pub(crate) type Before<'a> = (f64, &'a State);

impl Scene {
    /// The water of the line and its waves, where there are any.
    fn waves(&self) -> Option<(&Water, &Sea)> {
        let water = self.line.water.as_ref()?;
        Some((water, water.waves.as_ref()?))
    }

    /// Writes the wave kinematics at the nodes at time t \[s\] into the state; nothing without waves. Under the surface they are extrapolated from a
    /// state before where one is given and the sea allows it, which costs next to nothing.
    pub(super) fn write_wave_kinematics(
        &self,
        t: f64,
        before: Option<Before<'_>>,
        state: &mut State,
    ) {
        if let Some((_, sea)) = self.waves() {
            let mut clock = std::mem::take(&mut state.kept_waves.clock);
            clock.move_to(sea, t);
            self.write_wave_kinematics_by(&clock, before, state);
            state.kept_waves.clock = clock;
        }
    }

    /// The same at the time of a clock of the same sea.
    pub fn write_wave_kinematics_by(
        &self,
        clock: &SeaClock,
        before: Option<Before<'_>>,
        state: &mut State,
    ) {
        let Some((water, sea)) = self.waves() else {
            return;
        };
        state
            .wave_flow
            .resize(self.line.mass.len(), WaterMotion::default());
        let deep = self.deep(water, sea);
        let before = before.filter(|_| sea.can_be_extrapolated());
        let mut reader = SeaReader::Again(sea, clock, &mut state.kept_waves.places);
        for (node, (flow, x)) in state.wave_flow.iter_mut().zip(&state.x).enumerate() {
            let around = node.saturating_sub(1)..(node + 2).min(state.x.len());
            let surface = water.crossed && !state.x[around].iter().all(|x| x.z < deep);
            *flow = match before {
                Some((time, before)) if !surface => before.wave_flow[node].extrapolated(time, x),
                _ => reader.flow(node, x, surface),
            };
        }
    }

    /// A node below this height \[m\] whose neighbours are too is under water however high the waves are.
    fn deep(&self, water: &Water, sea: &Sea) -> f64 {
        // Their heights are read at several nodes.
        if self.elements.rigid_payload.is_some() || self.elements.traveller.is_some() {
            return f64::NEG_INFINITY;
        }
        let bodies = 0..self.line.bodies.len();
        let bodies = bodies.map(|number| water.radius_of_body(number));
        let lines = water.radius.iter().copied();
        -sea.crest() - bodies.chain(lines).fold(0.0, f64::max)
    }
}
