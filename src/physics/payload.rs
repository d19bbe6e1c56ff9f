//! The payload: a body at the line's end, with mass, wet weight, drag and added mass, without rotation (with it: see
//! [`super::rigid_body`]).
//!
//! Drag `F_i = 1/2 rho (C_D A)_i |u| u_i` along x, y, z: Morison's first term (Jia et al. 2019, eq. 1)
//! with one area a direction. The form of the body gives what a case leaves out.

use std::f64::consts::PI;

use super::added_mass::AddedMass;
use crate::numerics::{M3, V3};

/// A body, in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyProperties {
    /// Mass in air \[kg\].
    pub mass: f64,
    /// Weight in water \[N\], positive down.
    pub weight: f64,
    /// `1/2 rho C_D A` along x, y, z \[kg/m\].
    pub drag: V3,
    /// Added mass along x, y, z \[kg\].
    pub added: V3,
    /// Added mass across and along the line that carries the body, in the place of that along x, y, z.
    pub aligned: Option<AddedMass>,
}

impl BodyProperties {
    /// The greatest added mass in any direction \[kg\].
    #[must_use]
    pub fn greatest_added_mass(&self) -> f64 {
        let aligned = self.aligned.map(|m| m.normal.max(m.tangential));
        aligned.unwrap_or_else(|| self.added.max())
    }

    /// Drag \[N\] at relative velocity u of the water \[m/s\].
    #[inline]
    #[must_use]
    pub fn drag(&self, u: &V3) -> V3 {
        self.drag.component_mul(u) * u.norm()
    }

    /// Derivative of the drag by u \[N s/m\].
    #[inline]
    #[must_use]
    pub fn drag_by_velocity(&self, u: &V3) -> M3 {
        let speed = u.norm();
        let direction = if speed > 0.0 { u / speed } else { V3::zeros() };
        M3::from_diagonal(&(self.drag * speed)) + self.drag.component_mul(u) * direction.transpose()
    }
}

/// What the form of a body gives: displaced volume, drag areas and added mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FormCoefficients {
    /// Displaced volume \[m³\].
    pub volume: f64,
    /// Drag coefficient times projected area along x, y, z \[m²\].
    pub drag_area: V3,
    /// Added volume along x, y, z \[m³\]: added mass by density.
    pub added_volume: V3,
}

/// A box, length along x, breadth along y, height along z \[m\]. Drag on each face by
/// `C_D = 1.10 + 0.02 (L/B + B/L)`, the common fit for a plate of sides L and B; added mass of each face
/// as that of a square plate of its area, `0.579 * pi/4 * a³` (the usual tabulated coefficient).
#[must_use]
pub fn box_form(length: f64, breadth: f64, height: f64) -> FormCoefficients {
    let face = |a: f64, b: f64| (1.10 + 0.02 * (a / b + b / a)) * a * b;
    let plate = |a: f64, b: f64| 0.579 * PI / 4.0 * (a * b).powf(1.5);
    FormCoefficients {
        volume: length * breadth * height,
        drag_area: V3::new(
            face(breadth, height),
            face(length, height),
            face(length, breadth),
        ),
        added_volume: V3::new(
            plate(breadth, height),
            plate(length, height),
            plate(length, breadth),
        ),
    }
}

/// A sphere above an upright cylinder \[m\]. Drag coefficients 0.5 for the sphere, 0.7 across and 0.9 along the
/// short cylinder (Hoerner 1965); added mass half the volume of the sphere, once the volume of the
/// cylinder across and a sphere's of its diameter along.
#[must_use]
pub fn sphere_and_cylinder(sphere: f64, diameter: f64, length: f64) -> FormCoefficients {
    let ball = PI / 6.0 * sphere.powi(3);
    let drum = PI / 4.0 * diameter.powi(2) * length;
    let disc = |d: f64| PI / 4.0 * d * d;
    let across = 0.5 * disc(sphere) + 0.7 * diameter * length;
    // Seen from above the two hide each other: the greater one counts.
    let along = (0.5 * disc(sphere)).max(0.9 * disc(diameter));
    let along_added = 0.5 * ball + PI / 12.0 * diameter.powi(3);
    FormCoefficients {
        volume: ball + drum,
        drag_area: V3::new(across, across, along),
        added_volume: V3::new(0.5 * ball + drum, 0.5 * ball + drum, along_added),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms_have_the_volumes_of_the_paper() {
        // Jia et al. 2019, table 2 (16 x 6.7 x 5 m) and the module's assumed 4 m sphere and 4 x 4 m cylinder.
        assert!((box_form(16.0, 6.7, 5.0).volume - 536.0).abs() < 1e-9);
        assert!((sphere_and_cylinder(4.0, 4.0, 4.0).volume - 83.776).abs() < 1e-3);
    }

    #[test]
    fn drag_tangent_is_the_finite_difference() {
        let body = BodyProperties {
            mass: 1.0,
            weight: 0.0,
            drag: V3::new(2.0, 3.0, 5.0),
            added: V3::zeros(),
            aligned: None,
        };
        let u = V3::new(0.3, -0.7, 1.1);
        let tangent = body.drag_by_velocity(&u);
        for j in 0..3 {
            let mut h = V3::zeros();
            h[j] = 1e-6;
            let column = (body.drag(&(u + h)) - body.drag(&(u - h))) / 2e-6;
            assert!((column - tangent.column(j)).norm() < 1e-8);
        }
    }
}
