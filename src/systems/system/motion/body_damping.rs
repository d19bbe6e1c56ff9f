//! Damping of a free body by its matrices, and the memory of the waves that it radiated: along its own axes, or, where it holds to first
//! order, along the axes at the pose given turned to the heading of the body, so that roll and pitch make no drift of it.

use nalgebra::{Matrix3, Matrix6, UnitQuaternion, Vector6};
use num_dual::DualNum;

use super::super::load_sum::LoadSum;
use super::super::moving_pose::{Dual, DualVector, MovingPose, constant};
use super::body_equation::{MovingBody, velocities};
use super::flow_load::FlowLoad;
use super::pose_motion::BodyMotion;
use crate::numerics::V3;
use crate::system::network::{Body, Network};

/// Whether the added mass that a body is given acts to first order alone.
pub(super) fn is_linear(body: &Body) -> bool {
    body.potential_flow.is_some() || body.current_loads.is_some()
}

impl MovingBody {
    /// Power of the damping by matrices \[W\], positive where energy is lost.
    #[must_use]
    pub fn damped(network: &Network, number: usize, motion: &BodyMotion) -> f64 {
        let body = &network.bodies[number];
        let rates = damped_velocities(body, motion);
        let squares = rates.map(|rate| rate * rate.abs());
        rates.dot(&(body.damping * rates + body.quadratic_damping * squares))
    }
}

/// Velocity of the origin and angular velocity along the axes that damping acts in: where that holds to first order those of the pose
/// given, turned to the heading of the body; else those of the body.
pub(super) fn damped_velocities(body: &Body, motion: &BodyMotion) -> Vector6<f64> {
    if !is_linear(body) {
        return velocities(motion);
    }
    let ahead = motion.pose.arm(&V3::x());
    let turn = ahead.y.atan2(ahead.x) - body.pose.angles()[2];
    let axes = UnitQuaternion::from_euler_angles(0.0, 0.0, turn) * body.pose.rotation;
    let velocity = axes.inverse() * motion.velocity;
    let spin = axes.inverse() * (motion.pose.rotation * motion.spin);
    Vector6::new(velocity.x, velocity.y, velocity.z, spin.x, spin.y, spin.z)
}

/// The same axes, as they turn with the unknowns.
struct DampedAxes {
    given: Matrix3<Dual>,
    turn: Dual,
}

impl DampedAxes {
    fn new(body: &Body, moving: &MovingPose<'_>) -> Self {
        let ahead = moving.arm(&V3::x());
        Self {
            given: body.pose.matrix().matrix().map(Dual::from_re),
            turn: ahead.y.atan2(ahead.x) - body.pose.angles()[2],
        }
    }

    /// A vector of the earth's directions along these axes.
    fn along(&self, v: &DualVector) -> DualVector {
        self.given.transpose() * about_vertical(v, -self.turn)
    }

    /// A vector along these axes in the earth's directions.
    fn to_earth(&self, v: &DualVector) -> DualVector {
        about_vertical(&(self.given * v), self.turn)
    }
}

/// A vector turned about the vertical.
fn about_vertical(v: &DualVector, by: Dual) -> DualVector {
    let (sin, cos) = by.sin_cos();
    DualVector::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos, v.z)
}

/// Damping by the matrices of the body, and the memory of the waves that it radiated.
pub(super) fn damp(
    body: &Body,
    flow: Option<&FlowLoad>,
    moving: &MovingPose<'_>,
    spin: &DualVector,
    sum: &mut LoadSum,
) {
    let still = body.damping == Matrix6::zeros() && body.quadratic_damping == Matrix6::zeros();
    if still && flow.is_none() {
        return;
    }
    let mut damping = body.damping;
    let mut memory = Vector6::zeros();
    if let Some(flow) = flow {
        damping += flow.damping;
        memory = flow.memory;
    }
    let axes = is_linear(body).then(|| DampedAxes::new(body, moving));
    let (velocity, turned) = match &axes {
        Some(axes) => (axes.along(&moving.velocity), axes.along(&moving.spin)),
        None => (moving.to_body(&moving.velocity), *spin),
    };
    let rates = [
        velocity.x, velocity.y, velocity.z, turned.x, turned.y, turned.z,
    ];
    let load = |row: usize| {
        let zero = Dual::from_re(memory[row]);
        rates.iter().enumerate().fold(zero, |sum, (column, rate)| {
            let size = if rate.re < 0.0 { -*rate } else { *rate };
            sum - *rate * damping[(row, column)]
                - *rate * size * body.quadratic_damping[(row, column)]
        })
    };
    let force = DualVector::new(load(0), load(1), load(2));
    let moment = DualVector::new(load(3), load(4), load(5));
    let to_earth = |v: &DualVector| match &axes {
        Some(axes) => axes.to_earth(v),
        None => moving.to_earth(v),
    };
    sum.add(&constant(&V3::zeros()), &to_earth(&force));
    sum.turn(&to_earth(&moment));
}
