//! Blocks of three unknowns of a system, and what of its lines and joints goes to which.

use std::ops::Range;

use super::super::joint_place::Place;
use super::super::joints::Role;
use super::super::line_ends::LineEnds;
use super::super::moving_system::MovingSystem;
use super::super::system_state::SystemState;
use super::pencil::ModalTangents;
use crate::numerics::{Banded, BlockEnvelope, M3, SideCouplings, V3};

/// A block of unknowns, by its number, and how a place moves with it; as itself where that is nothing.
type Part = (usize, Option<M3>);

/// What a joint has of another, beside lines.
pub(super) struct JointBlock {
    /// Row of the joint.
    pub(super) row: usize,
    /// Row of the other.
    pub(super) column: usize,
    /// By the displacement of the other.
    pub(super) block: M3,
}

impl JointBlock {
    /// All that are not zero.
    pub(super) fn all(system: &MovingSystem, mut matrix: BlockEnvelope) -> Vec<Self> {
        let mut found = Vec::new();
        for (row, first) in system.joints.envelope.iter().enumerate() {
            for column in *first..=row {
                let places = [(row, column), (column, row)];
                let both = &places[..if row == column { 1 } else { 2 }];
                for (row, column) in both.iter().copied() {
                    let block = *matrix.block(row, column);
                    if block != M3::zeros() {
                        found.push(Self { row, column, block });
                    }
                }
            }
        }
        found
    }
}

/// A line, by its blocks.
struct LineBlocks {
    /// The parts of each node.
    nodes: Vec<Vec<Part>>,
    /// The parts of the directions of its clamps on what turns, with their couplings to its nodes.
    clamps: Vec<(usize, Vec<Part>)>,
    couplings: Option<SideCouplings>,
}

/// The blocks of unknowns of a system: inner nodes of the lines, and then the rows of its joints.
pub(super) struct BlocksOfUnknowns {
    lines: Vec<LineBlocks>,
    /// The blocks of the joints.
    joints: Range<usize>,
    /// Whether each row of the joints moves: lengths that are paid out are held, and ends that are not let go have none.
    moves: Vec<bool>,
}

impl BlocksOfUnknowns {
    /// Those of a system in a state.
    pub(super) fn new(system: &MovingSystem, state: &SystemState) -> Self {
        let inner = state.lines.iter().map(|line| line.x.len() - 2);
        let begin = inner.sum();
        let rows = system.joints.envelope.len();
        let mut next = 0;
        let lines = state.lines.iter().enumerate().map(|(number, line)| {
            let ends = LineEnds::of_line(system, state, number);
            let places: Vec<(usize, Vec<Part>)> = ends
                .places()
                .map(|(which, place)| (which, parts(place, begin)))
                .collect();
            let at = |which: usize| {
                let mut places = places.iter();
                let found = places.find(|(own, _)| *own == which);
                found.map_or_else(Vec::new, |(_, parts)| parts.clone())
            };
            let inner = next..next + line.x.len() - 2;
            next = inner.end;
            let mut nodes = vec![at(0)];
            nodes.extend(inner.map(|block| vec![(block, None)]));
            nodes.push(at(1));
            let clamps = places.into_iter().filter(|(which, _)| *which > 1);
            LineBlocks {
                nodes,
                clamps: clamps.map(|(which, parts)| (which - 2, parts)).collect(),
                couplings: ends.couplings(1.0),
            }
        });
        let lines = lines.collect();
        let mut moves = vec![false; rows];
        for joint in system.joints.free.clone() {
            if let Some(row) = system.joints.row(joint) {
                moves[row] = match system.joints.roles[joint] {
                    Role::Released(line, end) => state.attached[line][end] == joint,
                    Role::Payout(_) => false,
                    _ => true,
                };
            }
        }
        Self {
            lines,
            joints: begin..begin + rows,
            moves,
        }
    }

    /// Unknowns of each block.
    pub(super) fn sizes(&self) -> Vec<usize> {
        let mut sizes = vec![3; self.joints.start];
        sizes.extend(self.moves.iter().map(|moves| if *moves { 3 } else { 0 }));
        sizes
    }

    /// The blocks that each one is coupled to by any of some tangents.
    pub(super) fn neighbours(&self, tangents: [&ModalTangents; 2]) -> Vec<Vec<usize>> {
        let mut all = vec![Vec::new(); self.joints.end];
        for tangents in tangents {
            self.assemble(tangents, &mut |row, column, _| {
                if row != column {
                    all[row].push(column);
                    all[column].push(row);
                }
            });
        }
        for own in &mut all {
            own.sort_unstable();
            own.dedup();
        }
        all
    }

    /// Hands out tangents by rows and columns of blocks.
    pub(super) fn assemble(
        &self,
        tangents: &ModalTangents,
        add: &mut impl FnMut(usize, usize, &M3),
    ) {
        for (line, band) in self.lines.iter().zip(&tangents.lines) {
            let reach = if band.is_wide() { 2 } else { 1 };
            for (i, on) in line.nodes.iter().enumerate() {
                let beside = i.saturating_sub(reach)..(i + reach + 1).min(line.nodes.len());
                for j in beside {
                    couple((on, &line.nodes[j]), &band.coupling(i, j), add);
                }
            }
            if tangents.clamps {
                line.clamp(add);
            }
        }
        for JointBlock { row, column, block } in &tangents.joints {
            if self.moves[*row] && self.moves[*column] {
                let begin = self.joints.start;
                add(begin + row, begin + column, block);
            }
        }
    }

    /// Displacements of the nodes of all lines, and then of the rows of the joints, by those of the blocks.
    pub(super) fn displacements(&self, at: &impl Fn(usize) -> V3) -> Vec<V3> {
        let moved = |parts: &Vec<Part>| {
            let parts = parts.iter();
            let parts =
                parts.map(|(block, by)| by.map_or_else(|| at(*block), |by| by * at(*block)));
            parts.fold(V3::zeros(), |sum, part| sum + part)
        };
        let nodes = self.lines.iter().flat_map(|line| &line.nodes).map(moved);
        let joints = self.joints.clone().zip(&self.moves);
        let joints = joints.map(|(block, moves)| match moves {
            true => at(block),
            false => V3::zeros(),
        });
        nodes.chain(joints).collect()
    }
}

impl LineBlocks {
    /// Couplings of the clamps to the nodes beside them, both ways.
    fn clamp(&self, add: &mut impl FnMut(usize, usize, &M3)) {
        let firsts = [0, self.nodes.len() - 2];
        for (end, parts) in &self.clamps {
            let Some(coupling) = self.couplings.as_ref().and_then(|both| both[*end]) else {
                continue;
            };
            let first = firsts[*end];
            for (node, block) in [(first, -coupling), (first + 1, coupling)] {
                couple((&self.nodes[node], parts), &block, add);
                couple((parts, &self.nodes[node]), &block.transpose(), add);
            }
        }
    }
}

/// A block between two places, by what they move with.
fn couple((on, by): (&[Part], &[Part]), block: &M3, add: &mut impl FnMut(usize, usize, &M3)) {
    for (row, lever) in on {
        for (column, moved) in by {
            let mut value = *block;
            if let Some(lever) = lever {
                value = lever.transpose() * value;
            }
            if let Some(moved) = moved {
                value *= moved;
            }
            add(*row, *column, &value);
        }
    }
}

/// The parts of a place, by the blocks of its rows.
fn parts(place: &Place, begin: usize) -> Vec<Part> {
    let parts = place.parts().iter();
    parts.map(|(row, by)| (begin + row, *by)).collect()
}
