//! The place of a joint by the unknowns of the border: those of a point, or of a body and the arms on it.

use super::super::pose::cross;
use super::{
    body_equation::rotation_jacobian, joints::Follows, moving_system::MovingSystem,
    pose_motion::BodyMotion, system_state::SystemState,
};
use crate::numerics::{M3, V3};

/// How a place moves with the unknowns: rows, each with the displacement of the place by it; as itself where that is nothing. A force there is
/// on each row that force by the transpose. A place on a body that is pinned to another has four.
#[derive(Default)]
pub(super) struct Place {
    parts: [(usize, Option<M3>); 4],
    count: usize,
    arms: [Option<Arm>; 2],
}

/// An arm that turns under the force on its place.
#[derive(Clone, Copy)]
pub(super) struct Arm {
    pub(super) rotation: usize,
    /// As the matrix of its cross product.
    pub(super) arm: M3,
    pub(super) jacobian: M3,
}

impl Place {
    pub(super) fn push(&mut self, row: usize, by: Option<M3>) {
        if let Some(part) = self.parts.get_mut(self.count) {
            *part = (row, by);
            self.count += 1;
        }
    }

    /// Adds the rotation of a body that the place is on.
    pub(super) fn turn(&mut self, arm: Arm) {
        self.push(arm.rotation, Some(-arm.arm * arm.jacobian));
        if let Some(free) = self.arms.iter_mut().find(|known| known.is_none()) {
            *free = Some(arm);
        }
    }

    pub(super) fn parts(&self) -> &[(usize, Option<M3>)] {
        &self.parts[..self.count]
    }

    pub(super) fn arms(&self) -> impl Iterator<Item = &Arm> {
        self.arms.iter().flatten()
    }

    /// The displacement of the place by those of the unknowns.
    pub(super) fn displacement(&self, rows: &[V3]) -> V3 {
        let parts = self.parts().iter();
        let moved = parts.map(|(row, by)| match by {
            Some(by) => by * rows[*row],
            None => rows[*row],
        });
        moved.reduce(|sum, part| sum + part).unwrap_or_default()
    }

    /// Adds a force at the place to the rows of the unknowns.
    pub(super) fn add(&self, force: &V3, rows: &mut [V3]) {
        for (row, by) in self.parts() {
            rows[*row] += match by {
                Some(by) => by.transpose() * force,
                None => *force,
            };
        }
    }
}

/// How a joint moves.
pub(super) fn place(system: &MovingSystem, state: &SystemState, joint: usize) -> Place {
    let mut place = Place::default();
    add_parts(system, state, joint, &mut place);
    place
}

/// Adds the unknowns that a joint moves with: of one on a body those of its origin, and the rotation.
pub(super) fn add_parts(
    system: &MovingSystem,
    state: &SystemState,
    joint: usize,
    place: &mut Place,
) {
    match system.joints.follows(joint) {
        Follows::Nothing => {}
        Follows::Row(row) => place.push(row, None),
        Follows::Body(body, at) => {
            let joints = &system.joints;
            let rotation = joints.rotations[body];
            let Some(row) = joints.row(rotation) else {
                return;
            };
            add_parts(system, state, joints.bodies[body], place);
            let motion: BodyMotion = system.body(state, body);
            place.turn(Arm {
                rotation: row,
                arm: cross(&motion.pose.arm(&at)),
                jacobian: rotation_jacobian(&motion.pose.rotation, &state.joints.x[rotation]),
            });
        }
    }
}
