//! The state of a system in motion.

use nalgebra::UnitQuaternion;
use serde::{Deserialize, Serialize};

use super::flow_load::FlowLoad;
use super::joints::Joints;
use super::pose_motion::BodyMotion;
use super::surplus::Surplus;
use super::velocity_history::VelocityHistory;
use crate::numerics::V3;
use crate::physics::sea::WaterMotion;
use crate::scene::Scene;
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
    /// Up to when the kinks of prescribed motions are passed \[s\].
    pub kinks_passed_s: f64,
    /// What waves make of the water at the stations of the bodies; empty in still water.
    #[serde(skip)]
    pub body_flow: Vec<WaterMotion>,
    /// Loads of potential flow on the bodies that have coefficients.
    #[serde(skip)]
    pub flow_loads: Vec<FlowLoad>,
    /// Past velocities of these bodies.
    pub velocities: Vec<VelocityHistory>,
    /// The lines that are paid out, as they are now.
    #[serde(skip)]
    pub paid: Vec<Scene>,
    /// Segments that each of them has more at ends A and B than at rest.
    #[serde(default)]
    pub added: Vec<[i64; 2]>,
    /// What meshing anew left too much in their end segments.
    #[serde(default)]
    pub surplus: Vec<[Surplus; 2]>,
    /// By how much the forces of winches and of friction at points that slide exceed, at the rates of an accepted state, those that the
    /// balances were solved with \[N\].
    #[serde(default)]
    pub drive_excess: Vec<f64>,
}

impl SystemState {
    /// Sets the lines that are paid out as in another state.
    pub(super) fn pay_out_as(&mut self, other: &Self) {
        for (line, other) in self.paid.iter_mut().zip(&other.paid) {
            line.pay_out_as(other);
        }
    }

    /// Takes what a checkpoint has of it; what waves make of the water is read anew.
    pub fn restore(&mut self, stored: &Self) {
        self.lines.clone_from(&stored.lines);
        self.joints.clone_from(&stored.joints);
        self.bases.clone_from(&stored.bases);
        self.attached.clone_from(&stored.attached);
        self.kinks_passed_s = stored.kinks_passed_s;
        self.velocities.clone_from(&stored.velocities);
        self.added.clone_from(&stored.added);
        self.surplus.clone_from(&stored.surplus);
        self.drive_excess.clone_from(&stored.drive_excess);
    }

    /// Takes the nodes of lines that are paid out from another state, whose numbers of nodes differ.
    pub fn size_as(&mut self, other: &Self) {
        self.lines.clone_from(&other.lines);
        self.added.clone_from(&other.added);
        self.surplus.clone_from(&other.surplus);
    }

    /// Number of the nodes of all lines.
    #[must_use]
    pub fn nodes(&self) -> i64 {
        self.lines.iter().map(|line| line.x.len() as i64).sum()
    }

    /// A body in motion.
    #[must_use]
    pub fn body(&self, joints: &Joints, body: usize) -> BodyMotion {
        let (at, turned) = (joints.bodies[body], joints.rotations[body]);
        let (x, v, a) = (&self.joints.x, &self.joints.v, &self.joints.a);
        let turn = UnitQuaternion::from_scaled_axis(x[turned]);
        BodyMotion {
            pose: Pose {
                origin: x[at],
                rotation: self.bases[body] * turn,
            },
            velocity: v[at],
            spin: v[turned],
            acceleration: a[at],
            spin_rate: a[turned],
        }
    }

    /// Writes the origin of a body that is pinned to what moves.
    pub fn set_pin(&mut self, joints: &Joints, body: usize, motion: &BodyMotion) {
        let at = joints.bodies[body];
        self.joints.x[at] = motion.pose.origin;
        self.joints.v[at] = motion.velocity;
        self.joints.a[at] = motion.acceleration;
    }

    /// Writes a body that is prescribed.
    pub fn set_body(&mut self, joints: &Joints, body: usize, motion: &BodyMotion) {
        let (at, turned) = (joints.bodies[body], joints.rotations[body]);
        let node = |list: &mut Vec<V3>, place: V3, turn: V3| {
            (list[at], list[turned]) = (place, turn);
        };
        node(&mut self.joints.x, motion.pose.origin, V3::zeros());
        node(&mut self.joints.v, motion.velocity, motion.spin);
        node(&mut self.joints.a, motion.acceleration, motion.spin_rate);
        self.bases[body] = motion.pose.rotation;
    }
}
