//! The fastest decay of a system in motion, which limits explicit steps as the stiffness of its lines does.

use nalgebra::Matrix6;

use super::body_equation::{MovingBody, rotation_jacobian};
use super::joints::Role;
use super::moving_system::MovingSystem;
use super::point_loads::point_load;
use super::system_state::SystemState;
use crate::solve::{Factors, Kinematics, PartedSystem};
use crate::system::network::{FreePoint, Held};

/// Forces by accelerations alone, and by velocities.
const BY_ACCELERATION: Factors = Factors {
    mass: 1.0,
    damping: 0.0,
    stiffness: 0.0,
};
const BY_VELOCITY: Factors = Factors {
    mass: 0.0,
    damping: 1.0,
    stiffness: 0.0,
};

impl MovingSystem {
    /// An upper bound of the rate at which damping slows a node of a line, a point or a body \[1/s\], and its number among all. Where a line
    /// ends on a point both drags act on both masses: no faster than the faster of the two.
    pub(super) fn decay(&self, bodies: &[MovingBody], state: &SystemState) -> (f64, usize) {
        let lines = self
            .lines(state)
            .enumerate()
            .map(|(number, (scene, line))| {
                let (rate, node) = scene.fastest_drag_decay(1..scene.nodes() - 1, line);
                (rate, self.offset(number) + node)
            });
        let first = self.offset(self.scenes.len());
        let points = self.joints.free.clone().filter_map(|joint| {
            let rate = self.decay_of_point(joint, state)?;
            Some((rate, first + joint))
        });
        let bodies = bodies.iter().filter_map(|body| {
            let rate = self.decay_of_body(body, state)?;
            Some((rate, first + self.joints.rotations[body.number]))
        });
        let all = lines.chain(points).chain(bodies);
        all.fold(
            (0.0, 0),
            |most, one| if one.0 > most.0 { one } else { most },
        )
    }

    fn decay_of_point(&self, joint: usize, state: &SystemState) -> Option<f64> {
        let point = self.free_point(joint)?;
        let joints = &state.joints;
        let at = (&joints.x[joint], &joints.v[joint]);
        let load = point_load(&self.network, point, at, self.around(joints, joint));
        let mass = load.mass.min();
        let rate = load.by_velocity.norm() / mass;
        (mass > 0.0).then_some(rate)
    }

    /// Mass and damping have no negative eigenvalue: the greatest decay is at most the sum of all.
    fn decay_of_body(&self, body: &MovingBody, state: &SystemState) -> Option<f64> {
        let rotation = self.joints.rotations[body.number];
        self.joints.row(rotation)?;
        let motion = self.body(state, body.number);
        let jacobian = rotation_jacobian(&motion.pose.rotation, &state.joints.x[rotation]);
        let around = self.water_around(state, body.number);
        let network = &self.network;
        let tangent = |c| body.residual(network, &motion, &around, &jacobian, c).1;
        let (mass, damping) = (tangent(BY_ACCELERATION), tangent(BY_VELOCITY));
        let given = &network.bodies[body.number];
        let rate = match given.pinned || given.carrier.is_some() {
            true => {
                let turning = |m: &Matrix6<f64>| m.fixed_view::<3, 3>(3, 3).into_owned();
                (turning(&mass).try_inverse()? * turning(&damping)).trace()
            }
            false => (mass.try_inverse()? * damping).trace(),
        };
        Some(rate)
    }

    /// The free point that a joint is.
    fn free_point(&self, joint: usize) -> Option<&FreePoint> {
        let Role::Free(number) = self.joints.roles[joint] else {
            return None;
        };
        match &self.network.points[number].held {
            Held::Free(point) => Some(point),
            Held::At(_) | Held::On(..) => None,
        }
    }
}
