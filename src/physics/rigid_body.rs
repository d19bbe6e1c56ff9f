//! A body that turns about the point it hangs from: symmetric about an axis through that point.
//!
//! Two masses at the ends of a massless, rigid rod move as the body does where mass, first and second moment about the
//! hang point agree (equimomental systems; any text on rigid dynamics, such as Routh 1905): one at the hang point, the other at
//! the centre of percussion,
//! `d = J/S`, `m2 = S/d`, `m1 = M - m2`, with `M` the mass, `S = M c` and `J = I + M c²`. Neither couples to
//! the other but through the rod, so the body is one more node and one more segment of the line. Weight and buoyancy act at
//! their own centres: split between the two
//! nodes by the lever they give the same force and the same moment. The water that goes with the body is [`KirchhoffAddedMass`].
//!
//! A line without torsion transmits no torque, so the body spins about its axis as fast as it did at first, with the angular
//! momentum h along the axis. As the axis turns at the rate t', that takes the moment `h t'` (Goldstein 2002, sec. 5.7).
//!
//! Drag acts strip by strip, `F = 1/2 rho |u| (A_n u + (A_t - A_n) t (t.u))`, A being drag coefficient times area across and
//! along the axis t, u the velocity of the water past the strip: spread evenly over a length of the axis about a centre of
//! its own, it resists turning too. Gauss's rule takes four strips on either side of the centre.

use super::kirchhoff::KirchhoffAddedMass;
use super::tension::AxialConstants;
use crate::numerics::{M3, V3};

/// What the rod stretches by under the body's weight, as a share of its length. A rod that were rigid to the last digit
/// would hide all other forces in the rounding of its own.
const STRETCH: f64 = 1e-6;
/// Damping of the rod's ringing, a ratio to critical.
const RINGING: f64 = 0.1;
/// Standard gravity \[m/s²\], for the rod's stiffness.
const GRAVITY: f64 = 9.80665;

/// Where the strips lie between the ends of the stretch, -1 to 1, and the share of the whole that each has: Gauss's rule of
/// four points on either half, so that it is exact for a body that turns about its centre of drag.
const STRIPS: [(f64, f64); 8] = {
    const INNER: f64 = 0.339_981_043_584_856_3;
    const OUTER: f64 = 0.861_136_311_594_052_6;
    const MORE: f64 = 0.25 * 0.652_145_154_862_546_1;
    const LESS: f64 = 0.25 * 0.347_854_845_137_453_9;
    [
        (0.5 * (-1.0 - OUTER), LESS),
        (0.5 * (-1.0 - INNER), MORE),
        (0.5 * (-1.0 + INNER), MORE),
        (0.5 * (-1.0 + OUTER), LESS),
        (0.5 * (1.0 - OUTER), LESS),
        (0.5 * (1.0 - INNER), MORE),
        (0.5 * (1.0 + INNER), MORE),
        (0.5 * (1.0 + OUTER), LESS),
    ]
};

/// A rigid body, in SI; places along its axis from the hang point, positive towards the centre of gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidBodyProperties {
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
    /// Length of the axis, about that centre, over which drag is spread \[m\].
    pub drag_length: f64,
    /// Moment of inertia about an axis across, through the centre of gravity \[kg m²\].
    pub inertia: f64,
    /// Added mass, and added moment of inertia about an axis across, through the centre of buoyancy.
    pub added: KirchhoffAddedMass,
    /// `1/2 rho C_D A` across and along the axis \[kg/m\].
    pub drag: [f64; 2],
    /// Angular momentum of the spin about the axis \[kg m²/s\], positive by the right hand with the thumb away from the
    /// hang point.
    pub spin: f64,
}

/// The same body as two masses on a rod. Places on the rod are shares of its length from the hang point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidBody {
    /// Length of the rod \[m\]: from the hang point to the centre of percussion.
    pub reach: f64,
    /// Masses at the hang point and at the far end \[kg\].
    pub mass: [f64; 2],
    /// Weights in water there \[N\], positive down.
    pub weight: [f64; 2],
    /// Place of the centre of gravity.
    pub centre: f64,
    /// Place of the centre of drag, and how far drag is spread to either side of it.
    pub drag_at: (f64, f64),
    /// `1/2 rho C_D A` across and along the axis \[kg/m\].
    pub drag: [f64; 2],
    /// Place of the centre of buoyancy and of the added mass.
    pub buoyancy_at: f64,
    /// Buoyancy \[N\], of the weights already.
    pub buoyancy: f64,
    /// The water that goes with it.
    pub added: KirchhoffAddedMass,
    /// Angular momentum of its spin \[kg m²/s\].
    pub spin: f64,
}

/// The strips of a stretch of the axis of a body for drag, `half` to either side of its centre: their places from there and their shares of the
/// drag; one at the centre where the stretch has no length.
pub fn drag_strips(half: f64) -> impl Iterator<Item = (f64, f64)> {
    let whole: &[(f64, f64)] = if half > 0.0 { &STRIPS } else { &[(0.0, 1.0)] };
    whole
        .iter()
        .map(move |(place, share)| (half * place, *share))
}

impl RigidBody {
    /// The two masses; nothing where the body hangs from its centre, which makes it a point, or is not
    /// finite.
    #[must_use]
    pub fn new(of: &RigidBodyProperties) -> Option<Self> {
        let first = of.mass * of.gravity_at;
        let second = of.inertia + first * of.gravity_at;
        let reach = second / first;
        if !(first > 0.0 && reach > 0.0 && reach.is_finite()) {
            return None;
        }
        let far = first / reach;
        let split = |size: f64, at: f64| [size * (1.0 - at / reach), size * at / reach];
        let (down, up) = (
            split(of.weight, of.gravity_at),
            split(of.buoyancy, of.buoyancy_at),
        );
        Some(Self {
            reach,
            // Not negative by Cauchy and Schwarz, but for rounding.
            mass: [(of.mass - far).max(0.0), far],
            weight: [down[0] - up[0], down[1] - up[1]],
            centre: of.gravity_at / reach,
            drag_at: (of.drag_at / reach, 0.5 * of.drag_length / reach),
            drag: of.drag,
            buoyancy_at: of.buoyancy_at / reach,
            buoyancy: of.buoyancy,
            added: of.added,
            spin: of.spin,
        })
    }

    /// The rod: stiff enough to stretch by a millionth of its length under the body's weight, its ringing damped.
    #[must_use]
    pub fn rod(&self) -> AxialConstants {
        let [near, far] = self.mass;
        let ea = (near + far) * GRAVITY / STRETCH;
        let together = near * far / (near + far);
        let damping = 2.0 * RINGING * (ea * self.reach * together).sqrt();
        AxialConstants::new(self.reach, ea, damping).bearing_compression(true)
    }

    /// Shares of the two nodes in what acts at a place on the rod.
    #[inline]
    #[must_use]
    pub fn shares(place: f64) -> [f64; 2] {
        [1.0 - place, place]
    }

    /// The strips that drag acts on: their places on the rod and their shares of the drag.
    pub fn strips(&self) -> impl Iterator<Item = (f64, f64)> {
        let (centre, half) = self.drag_at;
        drag_strips(half).map(move |(place, share)| (centre + place, share))
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
    pub fn drag_derivatives(&self, t: &V3, u: &V3) -> (M3, M3) {
        let [across, along] = self.drag;
        let (speed, more, ahead) = (u.norm(), along - across, t.dot(u));
        let direction = if speed > 0.0 { u / speed } else { V3::zeros() };
        let shape = u * across + t * (more * ahead);
        let matrix = M3::from_diagonal_element(across) + t * t.transpose() * more;
        let by_velocity = matrix * speed + shape * direction.transpose();
        let by_axis = (M3::from_diagonal_element(ahead) + t * u.transpose()) * (more * speed);
        (by_velocity, by_axis)
    }

    /// The fastest rate at which drag on a strip slows either node \[1/s\], at a relative speed \[m/s\], with what else they
    /// weigh \[kg\]: that of a push there on both, which is no less.
    #[must_use]
    pub fn damping_rate(&self, place: f64, speed: f64, mass: [f64; 2]) -> f64 {
        let shares = Self::shares(place);
        let lightness: f64 = shares.iter().zip(mass).map(|(w, m)| w * w / m).sum();
        2.0 * self.drag[0].max(self.drag[1]) * speed * lightness
    }

    /// The couple that the spin needs where the axis t turns at this rate \[1/s\], as couples of [`KirchhoffAddedMass`]
    /// \[N m\], and its derivatives by the axis and by the rate.
    #[must_use]
    pub fn gyroscopic(&self, t: &V3, turn: &V3) -> (V3, [M3; 2]) {
        (
            turn.cross(t) * self.spin,
            [
                turn.cross_matrix() * self.spin,
                t.cross_matrix() * -self.spin,
            ],
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measures() -> RigidBodyProperties {
        RigidBodyProperties {
            mass: 469e3,
            weight: 469e3 * GRAVITY,
            buoyancy: 85e3 * GRAVITY,
            gravity_at: 4.4,
            buoyancy_at: 4.1,
            drag_at: 3.5,
            drag_length: 6.0,
            inertia: 2.1e6,
            added: KirchhoffAddedMass {
                normal: 42e3,
                tangential: 30e3,
                inertia: 1e5,
            },
            drag: [9e3, 7e3],
            spin: 8e5,
        }
    }

    /// Mass, first and second moment; forces and moments of weight and buoyancy: all as the body's own.
    #[test]
    fn two_masses_stand_for_the_body() {
        let of = measures();
        let body = RigidBody::new(&of).unwrap();
        let d = body.reach;
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-14, "{a} {b}");
        near(body.mass[0] + body.mass[1], of.mass);
        near(body.mass[1] * d, 469e3 * 4.4);
        near(body.mass[1] * d * d, 2.1e6 + 469e3 * 4.4 * 4.4);
        near(body.weight[0] + body.weight[1], 384e3 * GRAVITY);
        near(body.weight[1] * d, (469e3 * 4.4 - 85e3 * 4.1) * GRAVITY);
        near(body.centre * d, 4.4);
        assert!(body.mass[0] > 0.0);
    }

    #[test]
    fn a_body_on_a_strop_is_a_point_and_one_hung_from_its_centre_is_none() {
        let strop = RigidBodyProperties {
            inertia: 0.0,
            ..measures()
        };
        let body = RigidBody::new(&strop).unwrap();
        assert!((body.reach - 4.4).abs() < 1e-14 && body.mass[0] < 1e-9 * body.mass[1]);
        let centred = RigidBodyProperties {
            gravity_at: 0.0,
            ..measures()
        };
        assert_eq!(RigidBody::new(&centred), None);
    }

    #[test]
    fn the_slopes_of_the_drag_are_its_finite_differences() {
        let body = RigidBody::new(&measures()).unwrap();
        let (t, u) = (V3::new(0.48, -0.6, 0.64), V3::new(0.3, -0.7, 1.1));
        let (by_velocity, by_axis) = body.drag_derivatives(&t, &u);
        for j in 0..3 {
            let mut h = V3::zeros();
            h[j] = 1e-6;
            let column = (body.drag(&t, &(u + h)) - body.drag(&t, &(u - h))) / 2e-6;
            assert!((column - by_velocity.column(j)).norm() < 1e-4);
            let column = (body.drag(&(t + h), &u) - body.drag(&(t - h), &u)) / 2e-6;
            assert!((column - by_axis.column(j)).norm() < 1e-4);
        }
        assert_eq!(body.drag(&t, &V3::zeros()), V3::zeros());
        assert!(body.drag_derivatives(&t, &V3::zeros()).0.norm() == 0.0);
    }

    /// About its centre of drag: `k omega |omega| L³ / 32`; about an end of the stretch: `k omega |omega| L³ / 4`.
    #[test]
    fn strips_resist_turning_as_the_integral_over_them_does() {
        let body = RigidBody::new(&measures()).unwrap();
        let (t, omega, length) = (-V3::z(), 0.7, 6.0);
        let moment = |pivot: f64| -> f64 {
            let strips = body.strips().map(|(place, share)| {
                let arm = place * body.reach - pivot;
                share * body.drag(&t, &(V3::x() * (-omega * arm))).x * arm
            });
            -strips.sum::<f64>()
        };
        let k = 9e3 * omega * omega * f64::powi(length, 3);
        assert!((moment(3.5) / (k / 32.0) - 1.0).abs() < 1e-13);
        assert!((moment(0.5) / (k / 4.0) - 1.0).abs() < 1e-13);
        // Of a body whose centre of drag is the pivot and that has no length: none.
        let shares: f64 = body.strips().map(|(_, share)| share).sum();
        assert!((shares - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_gyroscopic_couple_does_no_work_and_has_its_slopes() {
        let body = RigidBody::new(&measures()).unwrap();
        let (t, turn) = (V3::new(0.48, -0.6, 0.64), V3::new(0.3, -0.7, 1.1));
        let (couple, slopes) = body.gyroscopic(&t, &turn);
        assert!(couple.dot(&turn).abs() < 1e-9 && couple.dot(&t).abs() < 1e-9);
        // The moment t x C is the spin's angular momentum times the rate of the axis, as far as it lies across.
        let across = turn - t * t.dot(&turn);
        assert!((t.cross(&couple) - across * 8e5).norm() < 1e-8);
        for j in 0..3 {
            let mut h = V3::zeros();
            h[j] = 1e-3;
            let by_axis = body.gyroscopic(&(t + h), &turn).0 - couple;
            assert!((by_axis / 1e-3 - slopes[0].column(j)).norm() < 1e-4);
            let by_turn = body.gyroscopic(&t, &(turn + h)).0 - couple;
            assert!((by_turn / 1e-3 - slopes[1].column(j)).norm() < 1e-4);
        }
    }
}
