//! From the unknowns of a line laid from A to a verified solution, and its drawing.

use super::build::BELIEVED;
use super::error::CatenaryError;
use super::laid::{Laid, State};
use super::solution::{Kind, Piece, Pieces, Seed, Shape, Solution, lying_sum};

impl Laid<'_> {
    pub(super) fn finish(&self, found: State, looks: u32) -> Result<Solution, CatenaryError> {
        let (state, residual) = self.verify(found);
        let at_a = (state.h / self.cos + self.drop() * state.offset).max(0.0);
        let v_b = state.h * self.tan + state.offset + self.chain().weight;
        if !(state.h.is_finite() && v_b.is_finite() && residual <= BELIEVED) {
            return Err(CatenaryError::NotVerified {
                error: residual,
                iterations: looks,
            });
        }
        let hangs: f64 = self.parts(state).map(|part| part.length).sum();
        let slack = state.h <= 0.0;
        Ok(Solution {
            h_a_n: at_a * self.cos,
            v_a_n: at_a * self.sin,
            h_b_n: state.h,
            v_b_n: v_b,
            on_bed_m: self.chain().length - hangs,
            shape: match (slack, self.wholly) {
                (true, _) => Shape::SlackOnBed,
                (false, true) => Shape::WhollyOnBed,
                (false, false) => Shape::PartlyOnBed,
            },
            against_surface: false,
            iterations: looks,
            residual,
            stiffness_n_per_m: self.stiffness(state),
            frame: self.problem.frame,
            pieces: Pieces::Many(self.pieces(state)),
            seed: Seed::None,
        })
    }

    /// Change of (H, V) at B per metre of B.
    fn stiffness(&self, state: State) -> [[f64; 2]; 2] {
        let look = self.look(state);
        let column = |x: f64, z: f64| {
            let (h, offset) = self.step(&look, state, x, z);
            (h, self.tan * h + offset)
        };
        let (by_x, by_z) = (column(1.0, 0.0), column(0.0, 1.0));
        [[by_x.0, by_z.0], [by_x.1, by_z.1]]
    }

    fn pieces(&self, state: State) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let (mut arc, mut x, mut z) = (0.0, 0.0, 0.0);
        let mut push = |length: f64, kind: Kind, dx: f64, dz: f64| {
            pieces.push(Piece {
                from: arc,
                length,
                x,
                z,
                kind,
            });
            (arc, x, z) = (arc + length, x + dx, z + dz);
        };
        let lies: f64 = self.rests(state).map(|rest| rest.length).sum();
        let mut foot = 0.0;
        for rest in self.rests(state) {
            let ea = self.chain().elements[rest.element].ea;
            let end = rest.end.max(0.0);
            if state.h > 0.0 {
                let along = rest.length + lying_sum(end, rest.loss, rest.length) / ea;
                let kind = Kind::Lying {
                    end,
                    loss: rest.loss,
                    cos: self.cos,
                    sin: self.sin,
                    ea,
                };
                push(rest.length, kind, along * self.cos, along * self.sin);
            } else {
                let dx = rest.length / lies * self.problem.x;
                foot += dx;
                let kind = Kind::Heap {
                    x: foot,
                    z: foot * self.tan,
                };
                push(rest.length, kind, dx, dx * self.tan);
            }
        }
        for part in self.parts(state) {
            let span = self.chain().part_span(&part);
            let (dx, dz) = span.reach(state.h, part.va);
            let kind = Kind::Hanging {
                h: state.h,
                va: part.va,
                w: span.weight,
                ea: span.ea,
            };
            push(span.length, kind, dx, dz);
        }
        pieces
    }
}
