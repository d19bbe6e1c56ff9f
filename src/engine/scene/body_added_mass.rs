//! Added mass of the bodies on the line: along x, y, z, or across and along the line that carries them, as modules and cylinders around a
//! line have it.
//!
//! Aligned with the direction d of the line at the body ([`NodeDirection`]) it is `M = m_n (I - dd') + m_t dd'`, and the water resists an
//! acceleration a relative to it by `M a`, as it resists that of the line itself (Jia et al. 2019, eqs (2) and (3)).

use super::LumpedLine;
use crate::numerics::{M3, V3};
use crate::physics::NodeDirection;
use crate::physics::added_mass::AddedMass;
use crate::solve::State;

/// The added mass of a body as it lies, all of it under water.
pub(super) enum BodyAddedMass<'a> {
    /// Along x, y, z \[kg\].
    Axes(&'a V3),
    /// Across and along the line there.
    Aligned(AddedMass, NodeDirection),
}

impl BodyAddedMass<'_> {
    /// The force that an acceleration needs \[N\].
    #[inline(always)]
    pub(super) fn force(&self, a: &V3) -> V3 {
        match self {
            Self::Axes(added) => added.component_mul(a),
            Self::Aligned(added, direction) => added.force(&direction.d, a),
        }
    }

    /// It as a matrix, with a mass that is the same along all axes on top \[kg\].
    pub(super) fn matrix_with(&self, mass: f64) -> M3 {
        match self {
            Self::Axes(added) => M3::from_diagonal(&added.add_scalar(mass)),
            Self::Aligned(added, direction) => added.matrix(&direction.d, mass),
        }
    }

    /// Derivatives of the force by the positions of the node before, of its own and of the node after \[N/m\], as far as the direction of
    /// the line turns by them; nothing where it has none.
    pub(super) fn by_positions(&self, a: &V3) -> Option<[M3; 3]> {
        let Self::Aligned(added, direction) = self else {
            return None;
        };
        let d = &direction.d;
        let by_direction = M3::from_diagonal_element(d.dot(a)) + d * a.transpose();
        let by_direction = by_direction * (added.tangential - added.normal);
        Some(direction.by_positions().map(|by| by_direction * by))
    }

    /// `v' (dM/dt) v / 2` as the line turns \[W\], v the velocities of the nodes before, at and after the body \[m/s\].
    pub(super) fn growth(&self, v: [V3; 3]) -> f64 {
        let Self::Aligned(added, direction) = self else {
            return 0.0;
        };
        let rates = direction.by_positions().into_iter().zip(&v);
        let turn: V3 = rates.map(|(by, v)| by * v).sum();
        (added.tangential - added.normal) * direction.d.dot(&v[1]) * turn.dot(&v[1])
    }
}

impl LumpedLine {
    /// Direction of the line at a node; the rod of a payload that rotates is no part of the line.
    pub(super) fn direction_at(&self, node: usize, state: &State) -> NodeDirection {
        let after = Some(node).filter(|i| i + 1 < self.line_nodes);
        let beside = [node.checked_sub(1), after];
        let [before, after] = beside.map(|segment| segment.map(|i| self.chord(i, state)));
        NodeDirection::new(before.as_ref(), after.as_ref())
    }

    /// Added mass of the body of this number.
    #[inline(always)]
    pub(super) fn body_added_mass(&self, number: usize, state: &State) -> BodyAddedMass<'_> {
        let hung = &self.bodies[number];
        match hung.body.aligned {
            None => BodyAddedMass::Axes(&hung.body.added),
            Some(added) => BodyAddedMass::Aligned(added, self.direction_at(hung.node, state)),
        }
    }

    /// Velocities of the nodes before, at and after the node of a body \[m/s\]; zero where there is none.
    pub(super) fn velocities_beside(&self, node: usize, state: &State) -> [V3; 3] {
        let at = |node: Option<usize>| {
            let node = node.filter(|node| *node < self.line_nodes);
            node.map_or_else(V3::zeros, |node| state.v[node])
        };
        [at(node.checked_sub(1)), at(Some(node)), at(Some(node + 1))]
    }
}
