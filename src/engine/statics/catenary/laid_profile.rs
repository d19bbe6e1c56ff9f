//! The verified solution of a line of several sections laid on the bed from A, with its profile.

use super::candidate::Candidate;
use super::composite_touchdown::{CompositeTouchdown, CompositeUnknowns};
use super::error::CatenaryError;
use super::profile::{PieceLaw, Pieces, ProfileBuilder, grounded_tension_sum};
use super::solution::{CatenaryShape, Solution, StartingUnknown};

impl CompositeTouchdown<'_> {
    pub(super) fn solution(
        &self,
        found: CompositeUnknowns,
        iterations: u32,
    ) -> Result<Solution, CatenaryError> {
        let (state, residual) = self.verify(found);
        let slope = &self.slope;
        let at_a = (state.h / slope.cos + slope.drop() * state.offset).max(0.0);
        let v_b = state.h * slope.tan + state.offset + self.chain().weight;
        let suspended: f64 = self.parts(state).map(|part| part.length).sum();
        let candidate = Candidate {
            ends: [(at_a * slope.cos, at_a * slope.sin), (state.h, v_b)],
            on_bed: self.chain().length - suspended,
            shape: match (state.h <= 0.0, self.wholly) {
                (true, _) => CatenaryShape::SlackOnBed,
                (false, true) => CatenaryShape::WhollyOnBed,
                (false, false) => CatenaryShape::PartlyOnBed,
            },
            iterations,
            residual,
            stiffness: self.stiffness(state),
            seed: StartingUnknown::None,
        };
        candidate.verified(self.line.frame, self.pieces(state))
    }

    /// Change of (H, V) at B per metre of B.
    fn stiffness(&self, state: CompositeUnknowns) -> [[f64; 2]; 2] {
        let reach = self.end_reach(state);
        let column = |x: f64, z: f64| {
            let (h, offset) = self.step(&reach, state, x, z);
            (h, self.slope.tan * h + offset)
        };
        let (by_x, by_z) = (column(1.0, 0.0), column(0.0, 1.0));
        [[by_x.0, by_z.0], [by_x.1, by_z.1]]
    }

    fn pieces(&self, state: CompositeUnknowns) -> Pieces {
        let mut profile = ProfileBuilder::default();
        let slope = &self.slope;
        let grounded: f64 = self.grounded_parts(state).map(|part| part.length).sum();
        let mut foot = 0.0;
        for part in self.grounded_parts(state) {
            let ea = self.chain().elements[part.element].ea;
            let end = part.end.max(0.0);
            if state.h > 0.0 {
                let along = part.length + grounded_tension_sum(end, part.loss, part.length) / ea;
                let law = PieceLaw::Grounded {
                    end,
                    loss: part.loss,
                    cos: slope.cos,
                    sin: slope.sin,
                    ea,
                };
                profile.push(part.length, law, (along * slope.cos, along * slope.sin));
            } else {
                let dx = part.length / grounded * self.line.x;
                foot += dx;
                profile.slack(part.length, (dx, dx * slope.tan), foot * slope.tan);
            }
        }
        for part in self.parts(state) {
            profile.suspend(&self.chain().part_span(&part), state.h, part.va);
        }
        profile.pieces()
    }
}
