//! The drag of a free point.

use super::network::FreePoint;
use crate::numerics::{M3, V3};
use crate::physics::BodyProperties;

impl FreePoint {
    /// Its drag area, where that is the same along all axes \[m²\].
    #[must_use]
    pub fn one_drag_area(&self) -> Option<f64> {
        let area = &self.drag_area;
        (area.x == area.y && area.y == area.z).then_some(area.x)
    }

    /// Drag under water \[N\] at a velocity u of the water past it \[m/s\], and the derivative by u of a share of that \[N s/m\]: the law of
    /// a payload. One area for all axes keeps the order of operations, and with it the bits, of runs before there were three.
    #[must_use]
    pub fn drag(&self, density: f64, u: &V3, share: f64) -> (V3, M3) {
        let Some(area) = self.one_drag_area() else {
            let body = BodyProperties {
                mass: 0.0,
                weight: 0.0,
                drag: self.drag_area * (0.5 * density),
                added: V3::zeros(),
                aligned: None,
            };
            return (body.drag(u), body.drag_by_velocity(u) * share);
        };
        let speed = u.norm();
        let half = 0.5 * density * area;
        let turning = if speed > 0.0 {
            u * u.transpose() / speed
        } else {
            M3::zeros()
        };
        let by_flow = (M3::identity() * speed + turning) * (half * share);
        (u * (half * speed), by_flow)
    }
}
