//! From a settled pattern of a composite line to a verified solution, and its drawing.

use super::build::BELIEVED;
use super::chain::{Chain, Part};
use super::composite::{Pattern, Problem};
use super::descent::{Misses, State, misses, relative};
use super::error::CatenaryError;
use super::solution::{Kind, Piece, Pieces, Seed, Shape, Solution};

impl Problem {
    /// Newton steps on the misses with 30 digits until they are rounding; the error left.
    fn verify(&self, pattern: &Pattern) -> (State, f64, [[f64; 2]; 2]) {
        let (chain, bays) = (&self.chain, &pattern.bays);
        let mut best = (pattern.state.clone(), f64::INFINITY);
        let mut state = pattern.state.clone();
        let mut stiffness = [[0.0; 2]; 2];
        for _ in 0..3 {
            let here = misses(chain, bays, &state, self.x);
            let (mut x, z) = chain.misses(bays, state.h, &state.offsets, self.x);
            // Lying all the way, exactly as long as its bed: the rounding of the length is no stretch.
            let rounding = 4.0 * f64::EPSILON * chain.length;
            if pattern.slack || (bays.is_empty() && x.abs() <= rounding) {
                x = 0.0;
            }
            let step = here.step(x, &z);
            let error = relative(&step, &state, self.top(bays, &state));
            if error.is_nan() || error >= best.1 {
                break;
            }
            stiffness = self.stiffness(pattern, &here);
            best = (state.clone(), error);
            if error < 1e-14 || state.h + step.h <= 0.0 || pattern.slack {
                break;
            }
            state.h += step.h;
            for (offset, step) in state.offsets.iter_mut().zip(&step.offsets) {
                *offset += step;
            }
        }
        (best.0, best.1, stiffness)
    }

    /// Change of (H, V) at B per metre of B; along the bed only when B lies on it.
    fn stiffness(&self, pattern: &Pattern, here: &Misses) -> [[f64; 2]; 2] {
        let mut z = vec![0.0; pattern.bays.len()];
        let by_x = here.step(if pattern.slack { 0.0 } else { 1.0 }, &z);
        let to_b = pattern.bays.last().is_some_and(|bay| bay.onto.is_none());
        if !to_b {
            return [[by_x.h, 0.0], [0.0, 0.0]];
        }
        let last = z.len() - 1;
        z[last] = 1.0;
        let by_z = here.step(0.0, &z);
        [[by_x.h, by_z.h], [by_x.offsets[last], by_z.offsets[last]]]
    }

    pub(super) fn finish(&self, pattern: &Pattern) -> Result<Solution, CatenaryError> {
        let (state, residual, stiffness) = self.verify(pattern);
        let on_bed = self.lying(pattern);
        let first = pattern.bays.first().zip(state.offsets.first());
        let v_a = first.map_or(0.0, |(bay, offset)| {
            if bay.from.is_none() {
                *offset
            } else {
                offset.max(0.0)
            }
        });
        let last = pattern.bays.last().zip(state.offsets.last());
        let v_b = last.map_or(0.0, |(bay, offset)| {
            if bay.onto.is_none() {
                offset + self.chain.weight
            } else {
                (offset + self.chain.weight).min(0.0)
            }
        });
        let sound = state.h.is_finite() && v_a.is_finite() && v_b.is_finite();
        if !(sound && residual <= BELIEVED) {
            return Err(CatenaryError::NotVerified {
                error: residual,
                iterations: pattern.looks,
            });
        }
        let up = self.frame.up;
        let [[xx, xz], [zx, zz]] = stiffness;
        Ok(Solution {
            h_a_n: state.h,
            v_a_n: up * v_a,
            h_b_n: state.h,
            v_b_n: up * v_b,
            on_bed_m: on_bed,
            shape: self.shape(pattern, on_bed),
            against_surface: up < 0.0 && on_bed > 0.0,
            iterations: pattern.looks,
            residual,
            stiffness_n_per_m: [[xx, up * xz], [up * zx, zz]],
            frame: self.frame,
            pieces: Pieces::Many(self.pieces(pattern, &state)),
            seed: Seed::None,
        })
    }

    fn shape(&self, pattern: &Pattern, on_bed: f64) -> Shape {
        let from_a = pattern.bays.first().is_none_or(|bay| bay.from.is_some());
        match (pattern.resting.len(), pattern.slack) {
            (0, true) => Shape::HangingDouble,
            (0, false) => Shape::Hanging,
            _ if on_bed <= 0.0 && from_a => Shape::Hanging,
            (1, _) if pattern.bays.is_empty() => Shape::WhollyOnBed,
            (1, slack) if from_a => {
                if slack {
                    Shape::SlackOnBed
                } else {
                    Shape::PartlyOnBed
                }
            }
            (1, true) => Shape::SlackTroughOnBed,
            (1, false) => Shape::TroughOnBed,
            _ => Shape::ManyOnBed,
        }
    }

    /// Hanging and lying stretches in order.
    fn pieces(&self, pattern: &Pattern, state: &State) -> Vec<Piece> {
        let mut drawing = Drawing::new(self, pattern, state.h);
        for (bay, offset) in pattern.bays.iter().zip(&state.offsets) {
            for part in self.chain.parts(bay, *offset) {
                drawing.lie_until(part.element, part.begin);
                drawing.hang(&part);
            }
        }
        drawing.lie_until(self.last() + 1, 0.0);
        drawing.pieces
    }
}

/// Places stretches one after the other.
struct Drawing<'a> {
    chain: &'a Chain,
    h: f64,
    /// How much of the room on the bed a slack metre takes up.
    crowding: f64,
    /// Element reached and how far into it.
    element: usize,
    within: f64,
    arc: f64,
    x: f64,
    z: f64,
    pieces: Vec<Piece>,
}

impl<'a> Drawing<'a> {
    fn new(problem: &'a Problem, pattern: &Pattern, h: f64) -> Self {
        let lying = problem.lying(pattern);
        Self {
            chain: &problem.chain,
            h,
            crowding: if pattern.slack && lying > 0.0 {
                problem.x / lying
            } else {
                1.0
            },
            element: 0,
            within: 0.0,
            arc: 0.0,
            x: 0.0,
            z: 0.0,
            pieces: Vec::new(),
        }
    }

    fn push(&mut self, length: f64, kind: Kind, dx: f64, dz: f64) {
        self.pieces.push(Piece {
            from: self.arc,
            length,
            x: self.x,
            z: self.z,
            kind,
        });
        self.arc += length;
        self.x += dx;
        self.z += dz;
    }

    /// What lies between here and the given place.
    fn lie_until(&mut self, element: usize, within: f64) {
        while self.element < element || (self.element == element && self.within < within) {
            let Some(section) = self.chain.elements.get(self.element) else {
                return;
            };
            let end = if self.element == element {
                within
            } else {
                section.length
            };
            let length = end - self.within;
            if length > 0.0 && self.h > 0.0 {
                let kind = Kind::Lying {
                    end: self.h,
                    loss: 0.0,
                    cos: 1.0,
                    sin: 0.0,
                    ea: section.ea,
                };
                self.push(length, kind, length * (1.0 + self.h / section.ea), 0.0);
            } else if length > 0.0 {
                let dx = length * self.crowding;
                let kind = Kind::Heap {
                    x: self.x + dx,
                    z: self.z,
                };
                self.push(length, kind, dx, 0.0);
            }
            if self.element == element {
                self.within = within;
            } else {
                self.element += 1;
                self.within = 0.0;
            }
        }
    }

    fn hang(&mut self, part: &Part) {
        let span = self.chain.part_span(part);
        let (dx, dz) = span.reach(self.h, part.va);
        let kind = Kind::Hanging {
            h: self.h,
            va: part.va,
            w: span.weight,
            ea: span.ea,
        };
        self.push(span.length, kind, dx, dz);
        self.element = part.element;
        self.within = part.begin + part.length;
    }
}
