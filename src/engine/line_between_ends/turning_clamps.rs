//! Clamps of a line at rest whose directions are given with every solution: they turn with what holds them.

use crate::numerics::{BlockBand, Condensation, CondensedBeside, EndBlocks, M3, SingularBlock, V3};
use crate::scene::Scene;
use crate::solve::State;

/// What the clamps of a line at rest that turn do to what holds them. A direction d moves like a place at the arm d of the body that holds
/// the clamp, but for displacements of the body: the moment on the body is `d x F` of the force F on the direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClampedEquilibrium {
    /// Forces on the directions of the clamps at ends A and B \[N m\]; none where no clamp turns.
    pub force_n_m: [V3; 2],
    /// Change of the forces on ends A and B \[N\] and of these, by the places of the ends \[m\] and by the directions: rows and columns in
    /// this order. As [`LineEquilibrium::stiffness_n_per_m`](super::LineEquilibrium::stiffness_n_per_m), of which it contains the blocks.
    pub stiffness: [[M3; 4]; 4],
}

/// A line condensed onto its ends, and onto the directions of its clamps where any turns.
#[derive(Debug, Clone)]
pub(super) struct CondensedLine {
    pub(super) ends: EndBlocks,
    beside: Option<Box<CondensedClamps>>,
}

/// Which clamps turn, and the blocks of the ends and of them.
#[derive(Debug, Clone)]
struct CondensedClamps {
    turns: [bool; 2],
    blocks: [[M3; 4]; 4],
}

/// The directions of clamps that turn.
#[derive(Debug, Clone, Default)]
pub(super) struct Turning {
    /// Those of the next solution, and of the last one.
    pub(super) now: [Option<V3>; 2],
    last: [Option<V3>; 2],
}

impl Turning {
    /// The condensed tangent of a line at a state.
    pub(super) fn condense(
        &self,
        (scene, state): (&Scene, &State),
        tangent: &BlockBand,
        condensation: &mut Condensation,
    ) -> Result<CondensedLine, SingularBlock> {
        let coupling = |end: usize| {
            let load = self.now[end].and_then(|_| scene.clamp_load(end, state));
            load.map(|load| load.coupling)
        };
        let couplings = [coupling(0), coupling(1)];
        if couplings == [None; 2] {
            let ends = condensation.condense(tangent)?;
            let beside = None;
            return Ok(CondensedLine { ends, beside });
        }
        let CondensedBeside { blocks, .. } =
            condensation.condense_beside(tangent, &[], Some(&couplings))?;
        let turns = couplings.map(|coupling| coupling.is_some());
        Ok(CondensedLine {
            ends: [0, 1].map(|i| [blocks[i][0], blocks[i][1]]),
            beside: Some(Box::new(CondensedClamps { turns, blocks })),
        })
    }

    /// The displacements of the nodes between for those of the ends in `x`, negative as Newton's, and for the turns since the last solution.
    pub(super) fn respond(&self, condensation: &Condensation, x: &mut [V3]) {
        if self.now == [None; 2] {
            return condensation.respond(x);
        }
        let turned = |end: usize| match (self.last[end], self.now[end]) {
            (Some(last), Some(now)) => last - now,
            _ => V3::zeros(),
        };
        condensation.respond_beside(x, Some(&[turned(0), turned(1)]));
    }

    /// Notes that there is a solution for the directions now.
    pub(super) fn accept(&mut self) {
        self.last = self.now;
    }
}

impl ClampedEquilibrium {
    /// Of a line condensed at its equilibrium; nothing where no clamp turns.
    pub(super) fn of_condensed_line(
        scene: &Scene,
        state: &State,
        condensed: &CondensedLine,
    ) -> Option<Box<Self>> {
        let CondensedClamps { turns, blocks } = condensed.beside.as_deref()?;
        let force = |end: usize| {
            let load = turns[end].then(|| scene.clamp_load(end, state)).flatten();
            load.map_or_else(V3::zeros, |load| -load.residual)
        };
        Some(Box::new(Self {
            force_n_m: [force(0), force(1)],
            stiffness: blocks.map(|row| row.map(|block| -block)),
        }))
    }
}
