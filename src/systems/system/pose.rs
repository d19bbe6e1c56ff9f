//! Where a rigid body is: place of its origin and rotation.

use nalgebra::{Rotation3, UnitQuaternion};

use crate::numerics::{M3, V3};

/// Place of the origin of a body's frame, and its rotation from the earth's frame.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Pose {
    /// The origin \[m\].
    pub origin: V3,
    /// From the body's frame to the earth's.
    pub rotation: UnitQuaternion<f64>,
}

impl Pose {
    /// The pose of an origin \[m\] and of angles \[rad\]: yaw about z first, then pitch about the new y, then roll about the
    /// new x.
    #[must_use]
    pub fn new(origin: V3, roll: f64, pitch: f64, yaw: f64) -> Self {
        Self {
            origin,
            rotation: UnitQuaternion::from_euler_angles(roll, pitch, yaw),
        }
    }

    /// The pose of an origin \[m\] and of angles \[rad\] about the axes in the other order: roll about x first, then pitch about the new
    /// y, then yaw about the new z, as `MoorDyn` takes those of its bodies (`EulerXYZ`, source/Misc.cpp).
    #[must_use]
    pub fn of_roll_first(origin: V3, [roll, pitch, yaw]: [f64; 3]) -> Self {
        let about = |axis, angle| UnitQuaternion::from_axis_angle(&axis, angle);
        Self {
            origin,
            rotation: about(V3::x_axis(), roll)
                * about(V3::y_axis(), pitch)
                * about(V3::z_axis(), yaw),
        }
    }

    /// The angles \[rad\] that [`Pose::of_roll_first`] takes.
    #[must_use]
    pub fn angles_roll_first(&self) -> [f64; 3] {
        // Those of the inverse rotation, which is made of the same turns backwards.
        let (roll, pitch, yaw) = self.rotation.inverse().euler_angles();
        [-roll, -pitch, -yaw]
    }

    /// The arm from the origin to a place of the body, in the earth's directions \[m\].
    #[must_use]
    pub fn arm(&self, place: &V3) -> V3 {
        self.rotation * place
    }

    /// The pose moved by `step` \[m\] and then turned about its origin by the rotation vector `turn` \[rad\], both in the
    /// earth's directions.
    #[must_use]
    pub fn moved(&self, step: &V3, turn: &V3) -> Self {
        Self {
            origin: self.origin + step,
            rotation: UnitQuaternion::from_scaled_axis(*turn) * self.rotation,
        }
    }

    /// Roll, pitch and yaw \[rad\], as [`Pose::new`] takes them.
    #[must_use]
    pub fn angles(&self) -> [f64; 3] {
        let (roll, pitch, yaw) = self.rotation.euler_angles();
        [roll, pitch, yaw]
    }

    /// The rotation as a matrix.
    #[must_use]
    pub fn matrix(&self) -> Rotation3<f64> {
        self.rotation.to_rotation_matrix()
    }
}

/// The matrix of the cross product `a x`.
#[must_use]
pub fn cross(a: &V3) -> M3 {
    a.cross_matrix()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_orders_of_the_angles_are_taken_back() {
        for angles in [[0.3, -0.4, 1.9], [-1.2, 0.7, -2.8], [0.0, 0.0, 0.5]] {
            let first = Pose::of_roll_first(V3::zeros(), angles);
            let [roll, pitch, yaw] = angles;
            let last = Pose::new(V3::zeros(), roll, pitch, yaw);
            for (found, given) in first
                .angles_roll_first()
                .iter()
                .chain(&last.angles())
                .zip(angles.iter().chain(&angles))
            {
                assert!((found - given).abs() < 1e-12, "{found} {given}");
            }
            let by_one = Pose::of_roll_first(V3::zeros(), [0.0, 0.0, yaw]);
            let by_other = Pose::new(V3::zeros(), 0.0, 0.0, yaw);
            assert!(by_one.rotation.angle_to(&by_other.rotation) < 1e-12);
        }
    }

    /// The rotation matrix of intrinsic turns about x, y and z.
    #[test]
    fn roll_comes_first() {
        let pose = Pose::of_roll_first(V3::zeros(), [0.2, 0.5, 0.9]);
        let ([sr, sp, sy], [cr, cp, cy]) = (
            [0.2_f64.sin(), 0.5_f64.sin(), 0.9_f64.sin()],
            [0.2_f64.cos(), 0.5_f64.cos(), 0.9_f64.cos()],
        );
        let expected = M3::new(
            cp * cy,
            -cp * sy,
            sp,
            cr * sy + sr * sp * cy,
            cr * cy - sr * sp * sy,
            -sr * cp,
            sr * sy - cr * sp * cy,
            sr * cy + cr * sp * sy,
            cr * cp,
        );
        assert!((pose.matrix().matrix() - expected).norm() < 1e-14);
    }
}
