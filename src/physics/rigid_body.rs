//! A body that turns about the point it hangs from: symmetric about an axis through that point, its spin left out.
//!
//! Two masses at the ends of a massless, rigid rod move as the body does where mass, first and second moment about the
//! hang point agree (equimomental systems; any text on rigid dynamics, such as Routh 1905): one at the hang point, the other at
//! the centre of percussion,
//! `d = J/S`, `m2 = S/d`, `m1 = M - m2`, with `M` the mass, `S = M c` and `J = I + M c²`. Neither couples to
//! the other but through the rod, so the body is one more node and one more segment of the line. Water that goes with
//! the body across its axis counts in `M`, `S` and `J`. Weight and buoyancy act at their own centres: split between the two
//! nodes by the lever they give the same force and the same moment. Drag acts at a centre of its own,
//! `F = 1/2 rho |u| (A_n u + (A_t - A_n) t (t.u))`, A being drag coefficient times area across and along the axis t.

use super::tension::Axial;
use crate::linalg::{M3, V3};

/// What the rod stretches by under the body's weight, as a share of its length. A rod that were rigid to the last digit
/// would hide all other forces in the rounding of its own.
const STRETCH: f64 = 1e-6;
/// Damping of the rod's ringing, a ratio to critical.
const RINGING: f64 = 0.1;
/// Standard gravity \[m/s²\], for the rod's stiffness.
const GRAVITY: f64 = 9.80665;

/// A body as a case tells it, in SI; places along its axis from the hang point, positive towards the centre of gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measures {
    /// Mass in air \[kg\].
    pub mass: f64,
    /// Weight in air \[N\].
    pub weight: f64,
    /// Buoyancy \[N\].
    pub buoyancy: f64,
    /// Centre of gravity \[m\].
    pub gravity_at: f64,
    /// Centre of buoyancy and of the added mass \[m\].
    pub buoyancy_at: f64,
    /// Centre of drag \[m\].
    pub drag_at: f64,
    /// Moment of inertia about an axis across, through the centre of gravity \[kg m²\].
    pub inertia: f64,
    /// Added mass across and along the axis \[kg\].
    pub added: [f64; 2],
    /// Added moment of inertia about an axis across, through the centre of buoyancy \[kg m²\].
    pub added_inertia: f64,
    /// `1/2 rho C_D A` across and along the axis \[kg/m\].
    pub drag: [f64; 2],
}

/// The same body as two masses on a rod. Places on the rod are shares of its length from the hang point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidBody {
    /// Length of the rod \[m\]: from the hang point to the centre of percussion.
    pub reach: f64,
    /// Masses at the hang point and at the far end \[kg\], the water that goes along across the axis counted.
    pub mass: [f64; 2],
    /// What more, or less, they are along the axis \[kg\].
    pub along: [f64; 2],
    /// Weights in water there \[N\], positive down.
    pub weight: [f64; 2],
    /// Place of the centre of gravity.
    pub centre: f64,
    /// Place of the centre of drag.
    pub drag_at: f64,
    /// `1/2 rho C_D A` across and along the axis \[kg/m\].
    pub drag: [f64; 2],
    /// Place of the centre of buoyancy and of the added mass.
    pub buoyancy_at: f64,
    /// Buoyancy \[N\], of the weights already.
    pub buoyancy: f64,
    /// Added mass across and along the axis \[kg\], of the masses already.
    pub added: [f64; 2],
}

impl RigidBody {
    /// The two masses; nothing where the body hangs from its centre, which no rod can tell from a point, or is not
    /// finite.
    #[must_use]
    pub fn new(of: &Measures) -> Option<Self> {
        let mass = of.mass + of.added[0];
        let first = of.mass * of.gravity_at + of.added[0] * of.buoyancy_at;
        let second = of.inertia
            + of.mass * of.gravity_at.powi(2)
            + of.added_inertia
            + of.added[0] * of.buoyancy_at.powi(2);
        let reach = second / first;
        if !(first > 0.0 && reach > 0.0 && reach.is_finite() && mass > 0.0) {
            return None;
        }
        let far = first / reach;
        // Not negative by Cauchy and Schwarz, but for rounding.
        let near = (mass - far).max(0.0);
        let split = |size: f64, at: f64| [size * (1.0 - at / reach), size * at / reach];
        let (down, up) = (
            split(of.weight, of.gravity_at),
            split(of.buoyancy, of.buoyancy_at),
        );
        let more = (of.added[1] - of.added[0]) / mass;
        Some(Self {
            reach,
            mass: [near, far],
            along: [near * more, far * more],
            weight: [down[0] - up[0], down[1] - up[1]],
            centre: of.gravity_at / reach,
            drag_at: of.drag_at / reach,
            drag: of.drag,
            buoyancy_at: of.buoyancy_at / reach,
            buoyancy: of.buoyancy,
            added: of.added,
        })
    }

    /// The rod: stiff enough to stretch by a millionth of its length under the body's weight, its ringing damped.
    #[must_use]
    pub fn rod(&self) -> Axial {
        let [near, far] = self.mass;
        let ea = (near + far) * GRAVITY / STRETCH;
        let together = near * far / (near + far);
        let damping = 2.0 * RINGING * (ea * self.reach * together).sqrt();
        Axial::new(self.reach, ea, damping).as_rod(true)
    }

    /// Shares of the two nodes in what acts at a place on the rod.
    #[inline]
    #[must_use]
    pub fn shares(place: f64) -> [f64; 2] {
        [1.0 - place, place]
    }

    /// Drag \[N\] at relative velocity u of the water \[m/s\], the axis along the unit vector t.
    #[inline]
    #[must_use]
    pub fn drag(&self, t: &V3, u: &V3) -> V3 {
        let [across, along] = self.drag;
        (u * across + t * ((along - across) * t.dot(u))) * u.norm()
    }

    /// Derivatives of the drag by u \[N s/m\] and by the axis \[N\].
    #[must_use]
    pub fn drag_slopes(&self, t: &V3, u: &V3) -> (M3, M3) {
        let [across, along] = self.drag;
        let (speed, more, ahead) = (u.norm(), along - across, t.dot(u));
        let direction = if speed > 0.0 { u / speed } else { V3::zeros() };
        let shape = u * across + t * (more * ahead);
        let matrix = M3::from_diagonal_element(across) + t * t.transpose() * more;
        let by_velocity = matrix * speed + shape * direction.transpose();
        let by_axis = (M3::from_diagonal_element(ahead) + t * u.transpose()) * (more * speed);
        (by_velocity, by_axis)
    }

    /// The fastest rate at which drag slows either node \[1/s\], at a relative speed \[m/s\], with what else they
    /// weigh \[kg\]: that of a push at the centre of drag on both, which is no less.
    #[must_use]
    pub fn decay(&self, speed: f64, mass: [f64; 2]) -> f64 {
        let shares = Self::shares(self.drag_at);
        let lightness: f64 = shares.iter().zip(mass).map(|(w, m)| w * w / m).sum();
        2.0 * self.drag[0].max(self.drag[1]) * speed * lightness
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measures() -> Measures {
        Measures {
            mass: 469e3,
            weight: 469e3 * GRAVITY,
            buoyancy: 85e3 * GRAVITY,
            gravity_at: 4.4,
            buoyancy_at: 4.1,
            drag_at: 3.5,
            inertia: 2.1e6,
            added: [42e3, 30e3],
            added_inertia: 1e5,
            drag: [9e3, 7e3],
        }
    }

    /// Mass, first and second moment; forces and moments of weight and buoyancy: all as the body's own.
    #[test]
    fn two_masses_stand_for_the_body() {
        let of = measures();
        let body = RigidBody::new(&of).unwrap();
        let d = body.reach;
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-14, "{a} {b}");
        near(body.mass[0] + body.mass[1], of.mass + of.added[0]);
        near(body.mass[1] * d, 469e3 * 4.4 + 42e3 * 4.1);
        near(
            body.mass[1] * d * d,
            2.1e6 + 1e5 + 469e3 * 4.4 * 4.4 + 42e3 * 4.1 * 4.1,
        );
        near(body.along[0] + body.along[1], -12e3);
        near(body.weight[0] + body.weight[1], 384e3 * GRAVITY);
        near(body.weight[1] * d, (469e3 * 4.4 - 85e3 * 4.1) * GRAVITY);
        near(body.centre * d, 4.4);
        assert!(body.mass[0] > 0.0);
    }

    #[test]
    fn a_body_on_a_strop_is_a_point_and_one_hung_from_its_centre_is_none() {
        let strop = Measures {
            inertia: 0.0,
            added: [0.0; 2],
            added_inertia: 0.0,
            ..measures()
        };
        let body = RigidBody::new(&strop).unwrap();
        assert!((body.reach - 4.4).abs() < 1e-14 && body.mass[0] < 1e-9 * body.mass[1]);
        let centred = Measures {
            gravity_at: 0.0,
            added: [0.0; 2],
            ..measures()
        };
        assert_eq!(RigidBody::new(&centred), None);
    }

    #[test]
    fn the_slopes_of_the_drag_are_its_finite_differences() {
        let body = RigidBody::new(&measures()).unwrap();
        let (t, u) = (V3::new(0.48, -0.6, 0.64), V3::new(0.3, -0.7, 1.1));
        let (by_velocity, by_axis) = body.drag_slopes(&t, &u);
        for j in 0..3 {
            let mut h = V3::zeros();
            h[j] = 1e-6;
            let column = (body.drag(&t, &(u + h)) - body.drag(&t, &(u - h))) / 2e-6;
            assert!((column - by_velocity.column(j)).norm() < 1e-4);
            let column = (body.drag(&(t + h), &u) - body.drag(&(t - h), &u)) / 2e-6;
            assert!((column - by_axis.column(j)).norm() < 1e-4);
        }
        assert_eq!(body.drag(&t, &V3::zeros()), V3::zeros());
        assert!(body.drag_slopes(&t, &V3::zeros()).0.norm() == 0.0);
    }
}
