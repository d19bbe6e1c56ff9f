//! From a settled pattern of a composite line to a verified solution, and its drawing.

use super::candidate::Candidate;
use super::composite_line::{CompositeLine, ContactPattern};
use super::convex_newton::{BayUnknowns, Residuals, relative, residuals};
use super::elements::{LineElements, SuspendedPart};
use super::error::CatenaryError;
use super::profile::{PieceLaw, Pieces, ProfileBuilder};
use super::solution::{CatenaryShape, Solution, StartingUnknown};

impl CompositeLine {
    /// Newton steps on the misses with 30 digits until they are rounding; the error left.
    fn verify(&self, pattern: &ContactPattern) -> (BayUnknowns, f64, [[f64; 2]; 2]) {
        let (chain, bays) = (&self.chain, &pattern.bays);
        let mut best = (pattern.state.clone(), f64::INFINITY);
        let mut state = pattern.state.clone();
        let mut stiffness = [[0.0; 2]; 2];
        for _ in 0..3 {
            let here = residuals(chain, bays, &state, self.x);
            let (mut x, z) = chain.residuals(bays, state.h, &state.offsets, self.x);
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
    fn stiffness(&self, pattern: &ContactPattern, here: &Residuals) -> [[f64; 2]; 2] {
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

    pub(super) fn finish(&self, pattern: &ContactPattern) -> Result<Solution, CatenaryError> {
        let (state, residual, stiffness) = self.verify(pattern);
        let on_bed = self.grounded_length(pattern);
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
        let candidate = Candidate {
            ends: [(state.h, v_a), (state.h, v_b)],
            on_bed,
            shape: self.shape(pattern, on_bed),
            iterations: pattern.evaluations,
            residual,
            stiffness,
            seed: StartingUnknown::None,
        };
        candidate.verified(self.frame, self.pieces(pattern, &state))
    }

    fn shape(&self, pattern: &ContactPattern, on_bed: f64) -> CatenaryShape {
        let from_a = pattern.bays.first().is_none_or(|bay| bay.from.is_some());
        match (pattern.grounded.len(), pattern.slack) {
            (0, true) => CatenaryShape::HangingDouble,
            (0, false) => CatenaryShape::Hanging,
            _ if on_bed <= 0.0 && from_a => CatenaryShape::Hanging,
            (1, _) if pattern.bays.is_empty() => CatenaryShape::WhollyOnBed,
            (1, slack) if from_a => {
                if slack {
                    CatenaryShape::SlackOnBed
                } else {
                    CatenaryShape::PartlyOnBed
                }
            }
            (1, true) => CatenaryShape::SlackTroughOnBed,
            (1, false) => CatenaryShape::TroughOnBed,
            _ => CatenaryShape::ManyOnBed,
        }
    }

    /// Suspended and grounded parts in order.
    fn pieces(&self, pattern: &ContactPattern, state: &BayUnknowns) -> Pieces {
        let mut profile = CompositeProfile::new(self, pattern, state.h);
        for (index, (bay, offset)) in pattern.bays.iter().zip(&state.offsets).enumerate() {
            if index > 0 {
                profile.touch();
            }
            for part in self.chain.parts(bay, *offset) {
                profile.ground_until(part.element, part.begin);
                profile.suspend(&part);
            }
        }
        profile.ground_until(self.last() + 1, 0.0);
        profile.builder.pieces()
    }
}

/// The profile of a line up to a point of one of its elements.
struct CompositeProfile<'a> {
    chain: &'a LineElements,
    h: f64,
    /// Distance on the bed that a slack metre takes up.
    crowding: f64,
    /// Element reached and how far into it.
    element: usize,
    within: f64,
    builder: ProfileBuilder,
}

impl<'a> CompositeProfile<'a> {
    fn new(line: &'a CompositeLine, pattern: &ContactPattern, h: f64) -> Self {
        let grounded = line.grounded_length(pattern);
        Self {
            chain: &line.chain,
            h,
            crowding: if pattern.slack && grounded > 0.0 {
                line.x / grounded
            } else {
                1.0
            },
            element: 0,
            within: 0.0,
            builder: ProfileBuilder::default(),
        }
    }

    /// The grounded part from here to the given point.
    fn ground_until(&mut self, element: usize, within: f64) {
        while self.element < element || (self.element == element && self.within < within) {
            let Some(section) = self.chain.elements.get(self.element) else {
                return;
            };
            let end = if self.element == element {
                within
            } else {
                section.length
            };
            self.ground(end - self.within, section.ea);
            if self.element == element {
                self.within = within;
            } else {
                self.element += 1;
                self.within = 0.0;
            }
        }
    }

    /// The line comes down to the bed here, if only at a body: a grounded piece without length.
    fn touch(&mut self) {
        let z = self.builder.z();
        self.builder.slack(0.0, (0.0, 0.0), z);
    }

    fn ground(&mut self, length: f64, ea: f64) {
        if length > 0.0 && self.h > 0.0 {
            let law = PieceLaw::Grounded {
                end: self.h,
                loss: 0.0,
                cos: 1.0,
                sin: 0.0,
                ea,
            };
            let dx = length * (1.0 + self.h / ea);
            self.builder.push(length, law, (dx, 0.0));
        } else if length > 0.0 {
            let (dx, z) = (length * self.crowding, self.builder.z());
            self.builder.slack(length, (dx, 0.0), z);
        }
    }

    fn suspend(&mut self, part: &SuspendedPart) {
        let span = self.chain.part_span(part);
        self.builder.suspend(&span, self.h, part.va);
        self.element = part.element;
        self.within = part.begin + part.length;
    }
}
