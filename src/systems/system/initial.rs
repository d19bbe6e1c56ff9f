//! Initial conditions: how what is free begins a run in time off its equilibrium.

use nalgebra::UnitQuaternion;

use super::pose::Pose;
use crate::numerics::V3;

/// Initial conditions of a free point.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PointInitial {
    /// Whether it begins where the file puts it, held there while everything else comes to rest.
    pub placed: bool,
    /// Displacement from there, or from where it rests \[m\].
    pub offset: V3,
    /// Velocity \[m/s\].
    pub velocity: V3,
    /// Of one that is placed: how far from where it rests; infinite where nothing else holds it \[m\].
    pub from_rest: f64,
}

impl PointInitial {
    /// Whether it begins off its equilibrium.
    #[must_use]
    pub fn is_off_rest(&self) -> bool {
        self.placed || self.is_pushed()
    }

    /// Whether it begins with an offset or a velocity.
    #[must_use]
    pub fn is_pushed(&self) -> bool {
        self.offset != V3::zeros() || self.velocity != V3::zeros()
    }

    /// The greatest distance from where it rests \[m\], and the speed at the start \[m/s\].
    #[must_use]
    pub fn scale(&self) -> (f64, f64) {
        (self.offset.norm() + self.from_rest, self.velocity.norm())
    }
}

/// Initial conditions of a body that is free or pinned.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BodyInitial {
    /// Whether it begins where the file puts it, held there while everything else comes to rest.
    pub placed: bool,
    /// Displacement of its origin from there, or from where it rests \[m\].
    pub offset: V3,
    /// Roll, pitch and yaw beyond those there \[rad\].
    pub angles: V3,
    /// Turn from there about its origin, in the earth's frame: of a rod, whose roll, pitch and yaw have no meaning where it is upright.
    pub turn: UnitQuaternion<f64>,
    /// Velocity of its origin along the axes of the earth \[m/s\].
    pub velocity: V3,
    /// Angular velocity along the axes of the earth \[rad/s\].
    pub angular_velocity: V3,
    /// Of one that is placed: how far its origin \[m\] and its rotation \[rad\] are from those at rest; infinite where nothing else holds it.
    pub from_rest: [f64; 2],
}

impl BodyInitial {
    /// Whether it begins off its equilibrium.
    #[must_use]
    pub fn is_off_rest(&self) -> bool {
        self.placed || self.is_pushed()
    }

    /// Whether it begins with an offset, a turn or a velocity.
    #[must_use]
    pub fn is_pushed(&self) -> bool {
        let rates = [
            self.offset,
            self.angles,
            self.velocity,
            self.angular_velocity,
        ];
        rates.iter().any(|rate| *rate != V3::zeros()) || self.turn != UnitQuaternion::identity()
    }

    /// Where it begins, if it rests, or is placed, at this pose.
    #[must_use]
    pub fn pose(&self, from: &Pose) -> Pose {
        let rotation = match self.angles == V3::zeros() {
            true => from.rotation,
            false => {
                let [roll, pitch, yaw] = from.angles();
                let beyond = &self.angles;
                Pose::new(
                    V3::zeros(),
                    roll + beyond.x,
                    pitch + beyond.y,
                    yaw + beyond.z,
                )
                .rotation
            }
        };
        Pose {
            origin: from.origin + self.offset,
            rotation: self.turn * rotation,
        }
    }

    /// The greatest distance of what is on it from where that rests \[m\], and its speed at the start \[m/s\], with arms of this length
    /// \[m\].
    #[must_use]
    pub fn scale(&self, arm: f64) -> (f64, f64) {
        let turned = self.angles.norm() + self.turn.angle() + self.from_rest[1];
        (
            self.offset.norm() + self.from_rest[0] + turned * arm,
            self.velocity.norm() + self.angular_velocity.norm() * arm,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_upright_rod_turns_about_the_axis_that_is_named() {
        // A rod that hangs: its x axis is downwards, where roll and yaw are one.
        let hanging = Pose::new(V3::zeros(), 0.0, std::f64::consts::FRAC_PI_2, 0.4);
        let initial = BodyInitial {
            turn: UnitQuaternion::from_euler_angles(0.0, -0.5, 0.0),
            ..BodyInitial::default()
        };
        let axis = initial.pose(&hanging).arm(&V3::x());
        let known = V3::new(0.5_f64.sin(), 0.0, -0.5_f64.cos());
        assert!((axis - known).norm() < 1e-12, "{axis}");
    }
}
