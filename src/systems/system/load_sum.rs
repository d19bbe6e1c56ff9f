//! Forces and moments summed on a body.

use super::moving_pose::{DualVector, constant};
use crate::numerics::V3;
use nalgebra::{Matrix6, Vector6};

/// Force and moment about the moving origin.
pub(super) struct LoadSum {
    force: DualVector,
    moment: DualVector,
}

impl LoadSum {
    pub(super) fn none() -> Self {
        let zero = constant(&V3::zeros());
        Self {
            force: zero,
            moment: zero,
        }
    }

    /// A force at an arm.
    pub(super) fn add(&mut self, arm: &DualVector, force: &DualVector) {
        self.force += force;
        self.moment += arm.cross(force);
    }

    /// A moment alone.
    pub(super) fn turn(&mut self, moment: &DualVector) {
        self.moment += moment;
    }

    /// Values, and minus their change with the six motions.
    pub(super) fn parts(&self) -> (Vector6<f64>, Matrix6<f64>) {
        let at = |row: usize| match row {
            0..3 => &self.force[row],
            _ => &self.moment[row - 3],
        };
        let value = Vector6::from_fn(|row, _| at(row).re);
        let stiffness = Matrix6::from_fn(|row, column| {
            let eps = at(row).eps.0.as_ref();
            -eps.map_or(0.0, |eps| eps[column])
        });
        (value, stiffness)
    }
}
