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
