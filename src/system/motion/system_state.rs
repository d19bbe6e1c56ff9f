//! The state of a system in motion.

use nalgebra::UnitQuaternion;
use serde::{Deserialize, Serialize};

use super::body_flow::{FlowLoad, VelocityHistory};
use super::joints::Joints;
use super::pose_motion::BodyMotion;
use crate::numerics::V3;
use crate::physics::sea::WaterMotion;
use crate::solve::State;
use crate::system::pose::Pose;

/// Positions, velocities, accelerations and history of everything.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SystemState {
    /// The lines, their end nodes included.
    pub lines: Vec<State>,
    /// The joints: points \[m\], and of each body its origin \[m\] and the rotation vector \[rad\] from its base, its velocity
    /// \[rad/s\] along the axes of the body.
    pub joints: State,
    /// Rotations of the bodies from which their rotation vectors count: those of the last accepted step.
    pub bases: Vec<UnitQuaternion<f64>>,
    /// Joints at ends A and B of each line.
    pub attached: Vec<[usize; 2]>,
    /// What waves make of the water at the stations of the bodies; empty in still water.
    #[serde(skip)]
    pub body_flow: Vec<WaterMotion>,
    /// Loads of potential flow on the bodies that have coefficients.
    #[serde(skip)]
    pub flow_loads: Vec<FlowLoad>,
    /// Past velocities of these bodies.
    pub velocities: Vec<VelocityHistory>,
}

impl SystemState {
    /// Copies another state of the same system without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        for (line, other) in self.lines.iter_mut().zip(&other.lines) {
            line.copy_from(other);
        }
        self.joints.copy_from(&other.joints);
        self.bases.copy_from_slice(&other.bases);
        self.attached.copy_from_slice(&other.attached);
        self.body_flow.clone_from(&other.body_flow);
        self.flow_loads.copy_from_slice(&other.flow_loads);
        self.velocities.clone_from_slice(&other.velocities);
    }

    /// Copies histories, bases and what is attached to what.
    pub fn copy_history_from(&mut self, other: &Self) {
        for (line, other) in self.lines.iter_mut().zip(&other.lines) {
            line.memory.copy_from(&other.memory);
        }
        self.bases.copy_from_slice(&other.bases);
        self.attached.copy_from_slice(&other.attached);
        self.velocities.clone_from_slice(&other.velocities);
    }

    /// Takes what a checkpoint has of it; what waves make of the water is read anew.
    pub fn restore(&mut self, stored: &Self) {
        self.lines.clone_from(&stored.lines);
        self.joints.clone_from(&stored.joints);
        self.bases.clone_from(&stored.bases);
        self.attached.clone_from(&stored.attached);
        self.velocities.clone_from(&stored.velocities);
    }

    /// The lines, then the joints.
    pub fn parts(&self) -> impl Iterator<Item = &State> {
        self.lines.iter().chain(std::iter::once(&self.joints))
    }

    /// The same, to be changed.
    pub fn parts_mut(&mut self) -> impl Iterator<Item = &mut State> {
        let joints = std::iter::once(&mut self.joints);
        self.lines.iter_mut().chain(joints)
    }

    /// A body in motion.
    #[must_use]
    pub fn body(&self, joints: &Joints, body: usize) -> BodyMotion {
        let at = joints.bodies[body];
        let (x, v, a) = (&self.joints.x, &self.joints.v, &self.joints.a);
        let turn = UnitQuaternion::from_scaled_axis(x[at + 1]);
        BodyMotion {
            pose: Pose {
                origin: x[at],
                rotation: self.bases[body] * turn,
            },
            velocity: v[at],
            spin: v[at + 1],
            acceleration: a[at],
            spin_rate: a[at + 1],
        }
    }

    /// Writes a body that is prescribed.
    pub fn set_body(&mut self, joints: &Joints, body: usize, motion: &BodyMotion) {
        let at = joints.bodies[body];
        let node = |list: &mut Vec<V3>, place: V3, turn: V3| {
            (list[at], list[at + 1]) = (place, turn);
        };
        node(&mut self.joints.x, motion.pose.origin, V3::zeros());
        node(&mut self.joints.v, motion.velocity, motion.spin);
        node(&mut self.joints.a, motion.acceleration, motion.spin_rate);
        self.bases[body] = motion.pose.rotation;
    }
}
