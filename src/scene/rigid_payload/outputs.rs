//! Where the end of a line with a body that turns is, and how the body is tilted.

use crate::numerics::V3;
use crate::scene::Scene;
use crate::solve::State;

impl Scene {
    /// Nodes of the line itself: all of them, less the far end of a body that turns.
    #[must_use]
    pub fn line_nodes(&self) -> usize {
        self.mass.len() - usize::from(self.rigid_payload.is_some())
    }

    /// Position of end B \[m\]: its last node, or the centre of gravity of a body that turns there.
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
        match &self.rigid_payload {
            Some(rigid_payload) => rigid_payload.at(values, rigid_payload.body.centre),
            None => values[values.len() - 1],
        }
    }

    /// Angle between the axis of a body that turns and straight down \[rad\]; zero where none does.
    #[must_use]
    pub fn tilt(&self, state: &State) -> f64 {
        self.rigid_payload.as_ref().map_or(0.0, |rigid_payload| {
            let t = self.chord(rigid_payload.node, state).tangent;
            t.x.hypot(t.y).atan2(-t.z)
        })
    }
}
