//! Stiffness and mass of everything that moves in a system at rest.

use std::sync::Arc;

use nalgebra::DVector;

use super::super::border::Border;
use super::super::moving_system::MovingSystem;
use super::super::system_state::SystemState;
use super::blocks::{BlocksOfUnknowns, JointBlock};
use crate::modes::Inertia;
use crate::numerics::envelope::{EnvelopeMatrix, number};
use crate::numerics::{BlockBand, M3, V3};
use crate::physics::CurrentProfile;
use crate::solve::Factors;

/// The matrices of `K x = omega² M x`, and how all nodes and joints move with their unknowns.
pub(super) struct SystemPencil {
    /// K \[N/m, N, N m\].
    pub(super) stiffness: EnvelopeMatrix,
    /// M \[kg, kg m, kg m²\].
    pub(super) mass: EnvelopeMatrix,
    /// Where the unknowns of each block begin.
    begins: Vec<usize>,
    blocks: BlocksOfUnknowns,
    /// Own mass of the nodes of each line, ends included \[kg\].
    of_nodes: Vec<Vec<M3>>,
    /// That of the joints.
    of_joints: Vec<JointBlock>,
}

/// Tangents of a system by accelerations or by positions.
pub(super) struct ModalTangents {
    /// The bands of the lines.
    pub(super) lines: Vec<BlockBand>,
    /// What the joints have beside lines.
    pub(super) joints: Vec<JointBlock>,
    /// Whether the clamps of lines on what turns take part.
    pub(super) clamps: bool,
}

const BY_MASS: Factors = Factors {
    mass: 1.0,
    damping: 0.0,
    stiffness: 0.0,
};
const BY_STIFFNESS: Factors = Factors {
    mass: 0.0,
    damping: 0.0,
    stiffness: 1.0,
};

impl SystemPencil {
    /// Of a system at rest in a state, drag left out.
    pub(super) fn new(system: &MovingSystem, state: &SystemState) -> Self {
        let (system, state) = without_drag(system, state);
        let mut border = Border::new(&system, &state);
        let mut tangents = |c: Factors| {
            let found = border.linearise(&system, 0.0, &state, c);
            let joints = found.matrix.clone();
            ModalTangents {
                lines: found.tangents.to_vec(),
                joints: JointBlock::all(&system, joints),
                clamps: c.stiffness > 0.0,
            }
        };
        let (stiffness, mass) = (tangents(BY_STIFFNESS), tangents(BY_MASS));
        let blocks = BlocksOfUnknowns::new(&system, &state);
        let (begins, shape) = number(&blocks.neighbours([&stiffness, &mass]), &blocks.sizes());
        let shape = Arc::new(shape);
        let assembled = |tangents: &ModalTangents| {
            let mut matrix = EnvelopeMatrix::zeros(&shape);
            blocks.assemble(tangents, &mut |row, column, block| {
                matrix.add_block(begins[row], begins[column], block);
            });
            matrix.symmetric_part()
        };
        Self {
            stiffness: assembled(&stiffness),
            mass: assembled(&mass),
            of_nodes: mass.lines.iter().map(|band| band.diag.clone()).collect(),
            of_joints: mass.joints,
            begins,
            blocks,
        }
    }

    /// Unknowns.
    pub(super) fn size(&self) -> usize {
        self.mass.size()
    }

    /// Displacements of the nodes of all lines, and then of the rows of the joints, by those of the unknowns.
    pub(super) fn displacements(&self, unknowns: &DVector<f64>) -> Vec<V3> {
        self.blocks.displacements(&|block| {
            let begin = self.begins[block];
            V3::from(unknowns.fixed_rows::<3>(begin))
        })
    }

    /// Kinetic energies by what moves, for displacements of nodes and joints: of each line, and of each row of the joints.
    pub(super) fn energies(&self, shape: &[V3]) -> (Vec<f64>, Vec<f64>) {
        let (nodes, joints) = shape.split_at(self.of_nodes.iter().map(Vec::len).sum());
        let mut rest = nodes;
        let lines = self.of_nodes.iter().map(|masses| {
            let (own, others) = rest.split_at(masses.len());
            rest = others;
            let of_nodes = masses.iter().zip(own);
            of_nodes.map(|(mass, x)| x.dot(&(mass * x))).sum()
        });
        let lines = lines.collect();
        let mut of_joints = vec![0.0; joints.len()];
        for block in &self.of_joints {
            of_joints[block.row] += joints[block.row].dot(&(block.block * joints[block.column]));
        }
        (lines, of_joints)
    }
}

impl Inertia for SystemPencil {
    fn mass_product(&self, x: &[V3], y: &[V3]) -> f64 {
        let masses = self.of_nodes.iter().flatten();
        let nodes = masses
            .zip(x)
            .zip(y)
            .map(|((mass, x), y)| x.dot(&(mass * y)));
        let first = self.of_nodes.iter().map(Vec::len).sum::<usize>();
        let joints = self.of_joints.iter().map(|block| {
            let (x, y) = (x[first + block.row], y[first + block.column]);
            x.dot(&(block.block * y))
        });
        nodes.sum::<f64>() + joints.sum::<f64>()
    }

    fn highest(&self) -> f64 {
        let (stiffness, mass) = (self.stiffness.diagonal(), self.mass.diagonal());
        let pairs = stiffness.iter().zip(&mass).filter(|(_, mass)| **mass > 0.0);
        let ratios = pairs.map(|(stiffness, mass)| (stiffness / mass).abs());
        ratios.fold(0.0, f64::max)
    }
}

/// The same at rest in still water, where nothing is dragged: what drag does to a system in a current is no part of its modes, the place to
/// which it takes it is.
fn without_drag(system: &MovingSystem, state: &SystemState) -> (MovingSystem, SystemState) {
    let (mut bare, mut still) = (system.clone(), state.clone());
    for scene in bare.scenes.iter_mut().chain(&mut still.paid) {
        *scene = scene.without_drag();
    }
    bare.water = None;
    bare.network.sea = None;
    bare.network.current = bare
        .network
        .current
        .map(|_| CurrentProfile::Uniform(V3::zeros()));
    bare.network.current_over_time = None;
    (bare, still)
}
