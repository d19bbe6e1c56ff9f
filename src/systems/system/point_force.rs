//! The force on a free point.

use super::{
    immersion::Immersion,
    line_physics::LinePhysics,
    network::{FreePoint, Network},
};
use crate::numerics::{M3, V3};

impl FreePoint {
    /// Its mass along x, y, z with the added mass of the share of it that is under water \[kg\].
    #[must_use]
    pub fn mass(&self, share: f64) -> V3 {
        self.moving_mass - self.added_mass * (1.0 - share)
    }

    /// The force on it under water at a place \[m\], lines apart \[N\], and its change with the place \[N/m\]; drag in the full physics.
    #[must_use]
    pub fn force(&self, network: &Network, place: &V3, physics: LinePhysics) -> (V3, M3) {
        let wet = match network.crossed {
            true => Immersion::of_point(network, self, place.z),
            false => Immersion::WHOLE,
        };
        let mut force = self.load + V3::new(0.0, 0.0, self.buoyancy * wet.share - self.weight);
        let mut by_place = M3::zeros();
        by_place[(2, 2)] = self.buoyancy * wet.by_height;
        if let Some((push, by)) = self.bed_at_rest(network, place) {
            force += push;
            by_place += by;
        }
        let flows = physics == LinePhysics::Full && self.drag_area != V3::zeros();
        let Some(current) = network.current.as_ref().filter(|_| flows) else {
            return (force, by_place);
        };
        let (velocity, gradient) = current.flow(place);
        let (drag, by_flow) = self.drag(network.density, &velocity, wet.share);
        by_place += match self.one_drag_area() {
            None => by_flow * gradient,
            // As before: see `drag`.
            Some(area) => {
                let speed = velocity.norm();
                let turning = if speed > 0.0 {
                    velocity * (gradient.transpose() * velocity / speed).transpose()
                } else {
                    M3::zeros()
                };
                (gradient * speed + turning) * (0.5 * network.density * area * wet.share)
            }
        };
        for k in 0..3 {
            by_place[(k, 2)] += drag[k] * wet.by_height;
        }
        (force + drag * wet.share, by_place)
    }
}
