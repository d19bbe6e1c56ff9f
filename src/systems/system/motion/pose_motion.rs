//! The prescribed motion of a body: of its origin, and of its roll, pitch and yaw.

use crate::numerics::V3;
use crate::physics::EndMotion;
use crate::system::pose::Pose;

/// How a body moves about its pose.
#[derive(Debug, Clone, PartialEq)]
pub struct PoseMotion {
    /// Its origin \[m\].
    pub place: EndMotion,
    /// Its roll, pitch and yaw \[rad\], as [`Pose::new`] takes them.
    pub angles: EndMotion,
}

/// A body in motion: rotation and its rates in the axes of the body.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BodyMotion {
    /// Where it is.
    pub pose: Pose,
    /// Velocity of its origin \[m/s\].
    pub velocity: V3,
    /// Angular velocity along its own axes \[rad/s\].
    pub spin: V3,
    /// Acceleration of its origin \[m/s²\].
    pub acceleration: V3,
    /// Rate of the angular velocity along its own axes \[rad/s²\].
    pub spin_rate: V3,
}

impl PoseMotion {
    /// The motion at time t \[s\]. With roll r, pitch p and yaw y the angular velocity along the axes of the body is
    ///
    /// ```text
    /// (r' - y' sin p,  p' cos r + y' sin r cos p,  y' cos r cos p - p' sin r)
    /// ```
    #[must_use]
    pub fn at(&self, t: f64) -> BodyMotion {
        self.after_kinks(t, t)
    }

    /// The same after the kinks of its tables up to a time `passed` \[s\], at any time t \[s\].
    #[must_use]
    pub fn after_kinks(&self, passed: f64, t: f64) -> BodyMotion {
        let (origin, velocity, acceleration) = self.place.after_kinks(passed, t);
        let (angles, rates, gains) = self.angles.after_kinks(passed, t);
        let (sr, cr) = angles.x.sin_cos();
        let (sp, cp) = angles.y.sin_cos();
        let (r1, p1, y1) = (rates.x, rates.y, rates.z);
        let (r2, p2, y2) = (gains.x, gains.y, gains.z);
        let spin = V3::new(r1 - y1 * sp, p1 * cr + y1 * sr * cp, y1 * cr * cp - p1 * sr);
        let spin_rate = V3::new(
            r2 - y2 * sp - y1 * cp * p1,
            p2 * cr - p1 * sr * r1 + y2 * sr * cp + y1 * (cr * r1 * cp - sr * sp * p1),
            y2 * cr * cp - y1 * (sr * r1 * cp + cr * sp * p1) - p2 * sr - p1 * cr * r1,
        );
        BodyMotion {
            pose: Pose::new(origin, angles.x, angles.y, angles.z),
            velocity,
            spin,
            acceleration,
            spin_rate,
        }
    }
}

impl BodyMotion {
    /// Position, velocity and acceleration of a place of the body.
    #[must_use]
    pub fn motion_of(&self, place: &V3) -> (V3, V3, V3) {
        let arm = self.pose.arm(place);
        let spin = self.pose.rotation * self.spin;
        let rate = self.pose.rotation * self.spin_rate;
        let by_spin = spin.cross(&arm);
        (
            self.pose.origin + arm,
            self.velocity + by_spin,
            self.acceleration + rate.cross(&arm) + spin.cross(&by_spin),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::motion::{HarmonicMotion, MotionPath};

    #[test]
    fn rates_are_those_of_the_pose() {
        let swing = |amplitude: V3, omega: f64| EndMotion {
            position: V3::new(0.3, -0.2, 0.9),
            course: MotionPath::Harmonic(HarmonicMotion {
                amplitude,
                omega,
                phase: V3::new(0.2, 1.1, -0.7),
            }),
            ramp: 0.0,
        };
        let motion = PoseMotion {
            place: swing(V3::new(3.0, 1.0, 2.0), 0.6),
            angles: swing(V3::new(0.4, 0.3, 0.8), 0.9),
        };
        let (t, h, at) = (2.3, 1e-5, V3::new(12.0, -7.0, 4.0));
        let [before, now, after] = [t - h, t, t + h].map(|t| motion.at(t).motion_of(&at));
        assert!(((after.0 - before.0) / (2.0 * h) - now.1).norm() < 1e-7);
        assert!(((after.1 - before.1) / (2.0 * h) - now.2).norm() < 1e-7);
    }
}
