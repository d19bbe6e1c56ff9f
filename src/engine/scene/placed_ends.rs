//! A line whose held ends are put elsewhere, as one that is part of a system.

use super::{EndCondition, Scene};
use crate::numerics::V3;
use crate::physics::EndMotion;

impl Scene {
    /// Holds both ends still at these places \[m\]. The initial shape stays as it is.
    pub fn hold_ends(&mut self, a: V3, b: V3) {
        self.line.ends = [a, b].map(|place| EndCondition::Prescribed(EndMotion::still(place)));
    }

    /// Holds both ends still at these places \[m\], with the closed form between them as the initial shape, which also lies on the
    /// bed. Friction springs of the bed stay where they are.
    pub fn start_between(&mut self, a: V3, b: V3) {
        self.hold_ends(a, b);
        let guess = self.guess_between(a, b);
        self.start.positions = guess.nodes;
        self.start.tension = guess.tension;
        self.start.in_equilibrium = true;
    }

    /// The same with another initial shape, nodes \[m\], in the place of the closed form: what is given of it goes along with its ends.
    pub fn start_between_in(&mut self, a: V3, b: V3, shape: &[V3]) {
        self.start_between(a, b);
        let (Some(first), Some(last), Some(whole)) =
            (shape.first(), shape.last(), self.line.arc.last())
        else {
            return;
        };
        let (at_a, at_b) = (a - first, b - last);
        let places = shape.iter().zip(&self.line.arc);
        let placed = places.map(|(place, arc)| place + at_a.lerp(&at_b, arc / whole));
        self.start.positions = placed.collect();
        self.start.tension.fill(self.line.force_scale);
    }

    /// Attaches the friction springs of the bed where the initial shape was laid and pulled (`initial_bed_friction`).
    pub fn lay_start_on_bed(&mut self) {
        self.start.grips = self
            .initial_friction(&self.start.positions, &self.start.tension)
            .grips;
    }
}
