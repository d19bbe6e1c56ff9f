//! Kinematics of a few successive segments, ahead of the pass that needs them. What takes longest, square roots and divisions,
//! runs side by side here, and nothing in the pass waits for it.

use super::LumpedLine;
use crate::numerics::V3;
use crate::physics::drag::VelocityParts;
use crate::physics::tension::Chord;
use crate::solve::State;

/// Segments in a block.
const LENGTH: usize = 8;

/// Kinematics of a node in the water around it.
#[derive(Clone, Copy, Default)]
pub(super) struct NodeKinematics {
    /// Velocity of the water relative to it \[m/s\].
    pub(super) u: V3,
    /// Its acceleration relative to the water's \[m/s²\].
    pub(super) a: V3,
    /// Shear of the current \[1/s\]; zero if the current is uniform.
    pub(super) shear: V3,
}

/// Kinematics of a segment.
#[derive(Clone, Copy)]
pub(super) struct SegmentKinematics<'a> {
    pub(super) chord: &'a Chord,
    /// Its nodes.
    pub(super) nodes: [&'a NodeKinematics; 2],
    /// Their relative velocities in parts.
    pub(super) parts: &'a VelocityParts,
}

/// A pass over the segments of a line, block by block.
pub(super) struct SegmentPass<const PLAIN: bool> {
    /// Segments computed so far.
    end: usize,
    nodes: [NodeKinematics; LENGTH + 1],
    chords: [Chord; LENGTH],
    parts: [VelocityParts; LENGTH],
}

impl<const PLAIN: bool> SegmentPass<PLAIN> {
    /// Before the first segment. See [`LumpedLine::is_plain`].
    #[inline(always)]
    pub(super) fn new(line: &LumpedLine, state: &State) -> Self {
        let mut nodes = [NodeKinematics::default(); LENGTH + 1];
        nodes[LENGTH] = line.around::<PLAIN>(0, state);
        Self {
            end: 0,
            nodes,
            chords: [Chord::default(); LENGTH],
            parts: [VelocityParts::default(); LENGTH],
        }
    }

    /// Segment i of the line, which follows the one before.
    #[inline(always)]
    pub(super) fn segment(
        &mut self,
        i: usize,
        line: &LumpedLine,
        state: &State,
    ) -> SegmentKinematics<'_> {
        if i == self.end {
            self.compute_block(line, state);
        }
        let k = i % LENGTH;
        SegmentKinematics {
            chord: &self.chords[k],
            nodes: [&self.nodes[k], &self.nodes[k + 1]],
            parts: &self.parts[k],
        }
    }

    /// Computes the next block.
    #[inline(always)]
    fn compute_block(&mut self, line: &LumpedLine, state: &State) {
        let first = self.end;
        self.end = (first + LENGTH).min(line.segments.len());
        self.nodes[0] = self.nodes[LENGTH];
        for (k, i) in (first..self.end).enumerate() {
            let chord = line.chord(i, state);
            let far = line.around::<PLAIN>(i + 1, state);
            self.parts[k] = VelocityParts::new(&chord.tangent, [&self.nodes[k].u, &far.u]);
            self.chords[k] = chord;
            self.nodes[k + 1] = far;
        }
    }
}

impl LumpedLine {
    /// Kinematics of a node; see [`LumpedLine::is_plain`].
    #[inline(always)]
    fn around<const PLAIN: bool>(&self, node: usize, state: &State) -> NodeKinematics {
        let v = state.v[node];
        if PLAIN {
            return NodeKinematics {
                u: self.current.at(&V3::zeros()).0 - v,
                a: state.a[node],
                shear: V3::zeros(),
            };
        }
        let x = &state.x[node];
        let (mut u, shear) = self.current.at(x);
        let mut a = state.a[node];
        if let Some(flow) = state.wave_flow.get(node) {
            u += flow.velocity_at(x);
            a -= flow.acceleration_at(x);
        }
        NodeKinematics { u: u - v, a, shear }
    }
}
