//! Touchdown of a line of several sections: grounded from A on a bed with a slope or friction, then suspended to B.
//!
//! The line leaves the bed along it, where `V = H tan θ`. Beyond, `V = H tan θ + U` with `U(s) = offset + W(s)` and W
//! the weight from A up to s; on the bed `-U(s)` is the weight that the bed carries between s and the lift-off. Bodies
//! included, a line pulled towards B has there the tension
//!
//! ```text
//! T(s) = H/cos θ + U(s) (sin θ + μ cos θ)
//! ```
//!
//! and none where that falls below zero and friction holds the slope (μ >= |tan θ|). The unknowns are H and the offset.
//! The suspended parts reach (dx, dz), the grounded ones `n + Σ ∫ T/EA ds` along the slope. The height of B rises with the offset for
//! any H, and its distance at that height with H: without friction both are derivatives of a convex energy, as in
//! `elements`, and friction adds stretch that rises with H. For one section this is `touchdown` (Jonkman 2007, eqs 2-37 and 2-38, on a level bed).

use super::composite_line::CompositeLine;
use super::elements::{Bay, LineElements, SuspendedPart};
use super::error::CatenaryError;
use super::line::RigidBed;
use super::slope::Slope;
use super::solution::Solution;
use super::span::{Span, length};
use crate::numerics::double_double::DoubleDouble;
use crate::numerics::log_newton::{FunctionSample, increasing_root};
use crate::numerics::roots::decreasing_root;

/// The line in the local frame with the bed through A.
pub(super) struct CompositeTouchdown<'a> {
    pub line: &'a CompositeLine,
    bay: Bay,
    pub slope: Slope,
    /// Height of B above the bed's line.
    height: f64,
    /// Whether every element sinks and B is on the bed as well.
    pub wholly: bool,
}

/// Horizontal force, and vertical offset of the suspended bay.
#[derive(Debug, Clone, Copy)]
pub(super) struct CompositeUnknowns {
    pub h: f64,
    pub offset: f64,
}

/// The grounded part of an element.
pub(super) struct GroundedPart {
    pub element: usize,
    pub length: f64,
    /// Tension at its end, and what it loses per metre towards A.
    pub end: f64,
    pub loss: f64,
}

/// Where B is beyond lying unstretched along the bed, with derivatives by H and by the offset.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct EndReach {
    x: f64,
    z: f64,
    x_by: [f64; 2],
    z_by: [f64; 2],
    /// Sum of the magnitudes of the terms of `x`.
    scale: f64,
}

pub(super) const SEVERAL_TOUCHDOWNS: CatenaryError = CatenaryError::UnsupportedContact(
    "a line of several sections comes down in more than one place, or buoyant from its end on the bed; with \
     friction or a slope it is solved where it lies from end A in one stretch",
);

/// The line grounded from A, or `None` when it touches the bed at A at most.
pub(super) fn solve(
    line: &CompositeLine,
    bed: RigidBed,
) -> Result<Option<Solution>, CatenaryError> {
    if line.chain.elements[0].total() <= 0.0 {
        return Ok(None);
    }
    let laid = CompositeTouchdown::new(line, bed);
    let slack = laid.slack()?.map(|state| (state, 0));
    let Some((state, evaluations)) = slack.or_else(|| laid.solve_unknowns()) else {
        return Ok(None);
    };
    if state.offset >= 0.0 {
        return Ok(None);
    }
    let at_a = state.h / laid.slope.cos + laid.slope.drop() * state.offset;
    if at_a < 0.0 && !laid.slope.holds() {
        return Err(laid.slope.slides());
    }
    if passes_below_bed(line, laid.parts(state), state.h, 0.0, laid.slope.tan) {
        return Err(SEVERAL_TOUCHDOWNS);
    }
    laid.solution(state, evaluations).map(Some)
}

/// Whether suspended parts in order, the first beginning `above` the bed's line, pass below that line between them.
pub(super) fn passes_below_bed(
    line: &CompositeLine,
    parts: impl Iterator<Item = SuspendedPart>,
    h: f64,
    above: f64,
    tan: f64,
) -> bool {
    let least = -1e-9 * (line.chain.length + line.z.abs());
    let (mut height, mut before) = (above, f64::INFINITY);
    for part in parts {
        let span = line.chain.part_span(&part);
        let turn = h * tan - part.va;
        let over = |span: &Span| {
            let (dx, dz) = span.reach(h, part.va);
            dz - dx * tan
        };
        // Lowest where the line runs along the bed: at a body, or within the part.
        if before < h * tan && turn <= 0.0 && height < least {
            return true;
        }
        if turn > 0.0 && turn < span.weight * span.length {
            let low = Span {
                length: turn / span.weight,
                ..span
            };
            if height + over(&low) < least {
                return true;
            }
        }
        height += over(&span);
        before = part.va + span.weight * span.length;
    }
    false
}

impl<'a> CompositeTouchdown<'a> {
    fn new(line: &'a CompositeLine, bed: RigidBed) -> Self {
        let slope = Slope::new(&bed);
        let run = line.run(0);
        let height = line.z - line.x * slope.tan;
        let slip = 1e-12 * (line.chain.length + line.z.abs());
        Self {
            line,
            bay: Bay {
                over: (0, line.last()),
                from: Some(run),
                onto: None,
                rise: 0.0,
            },
            slope,
            height,
            wholly: run.1 == line.last() && height <= slip,
        }
    }

    pub(super) fn chain(&self) -> &LineElements {
        &self.line.chain
    }

    /// The suspended parts with their true vertical force.
    pub(super) fn parts(
        &self,
        state: CompositeUnknowns,
    ) -> impl Iterator<Item = SuspendedPart> + '_ {
        let lift = state.h * self.slope.tan;
        let all = (!self.wholly).then(|| self.chain().parts(&self.bay, state.offset));
        all.into_iter().flatten().map(move |part| SuspendedPart {
            va: part.va + lift,
            ..part
        })
    }

    /// The grounded parts, in order from A.
    pub(super) fn grounded_parts(
        &self,
        state: CompositeUnknowns,
    ) -> impl Iterator<Item = GroundedPart> + '_ {
        let first = self.parts(state).next();
        let (last, within) = first.map_or((self.chain().elements.len(), 0.0), |part| {
            (part.element, part.begin)
        });
        let elements = self.chain().elements.iter().enumerate();
        elements.take(last + 1).filter_map(move |(i, element)| {
            let length = if i < last { element.length } else { within };
            let end = state.offset + self.chain().weight_before[i] + element.weight * length;
            (length > 0.0).then(|| GroundedPart {
                element: i,
                length,
                end: state.h / self.slope.cos + self.slope.drop() * end.min(0.0),
                loss: self.slope.drop() * element.weight,
            })
        })
    }

    /// Length of a grounded part under tension, from its end.
    fn tensioned(&self, part: &GroundedPart) -> f64 {
        if !self.slope.holds() || part.end - part.loss * part.length >= 0.0 {
            part.length
        } else if part.end <= 0.0 {
            0.0
        } else {
            part.end / part.loss
        }
    }

    /// Stretch of the grounded parts, and its derivatives by H and by the offset.
    fn stretch(&self, state: CompositeUnknowns) -> (f64, [f64; 2]) {
        let (mut sum, mut give) = (0.0, 0.0);
        for part in self.grounded_parts(state) {
            let (ea, n) = (
                self.chain().elements[part.element].ea,
                self.tensioned(&part),
            );
            sum += n * (part.end - 0.5 * part.loss * n) / ea;
            give += n / ea;
        }
        (sum, [give / self.slope.cos, give * self.slope.drop()])
    }

    pub(super) fn end_reach(&self, state: CompositeUnknowns) -> EndReach {
        let (stretch, [by_h, by_offset]) = self.stretch(state);
        let mut reach = EndReach {
            x: stretch * self.slope.cos,
            z: stretch * self.slope.sin,
            x_by: [by_h * self.slope.cos, by_offset * self.slope.cos],
            z_by: [by_h * self.slope.sin, by_offset * self.slope.sin],
            scale: stretch.abs(),
        };
        for part in self.parts(state) {
            let span = self.chain().part_span(&part);
            let (dx, dz) = span.reach(state.h, part.va);
            let c = span.compliance(state.h, part.va);
            reach.x += dx - span.length * self.slope.cos;
            reach.z += dz - span.length * self.slope.sin;
            reach.scale += span.length;
            reach.x_by[0] += c.hh + c.hv * self.slope.tan;
            reach.x_by[1] += c.hv;
            reach.z_by[0] += c.hv + c.vv * self.slope.tan;
            reach.z_by[1] += c.vv;
        }
        reach
    }

    /// The offset at which B has its height.
    fn offset_at(&self, h: f64, guess: f64) -> Option<f64> {
        if self.wholly {
            return Some(-self.chain().weight);
        }
        let wanted = self.wanted().1;
        decreasing_root(guess, self.chain().absolute_weight(), |offset| {
            let reach = self.end_reach(CompositeUnknowns { h, offset });
            (wanted - reach.z, reach.z_by[1])
        })
    }

    /// B beyond lying unstretched along the bed.
    fn wanted(&self) -> (f64, f64) {
        let (chain, line) = (self.chain(), self.line);
        (
            line.x - chain.length * self.slope.cos,
            line.z - chain.length * self.slope.sin,
        )
    }

    /// Unstretched length beyond the distance along the bed.
    fn excess_length(&self) -> f64 {
        (self.chain().length - self.line.x) - self.line.x * self.slope.secant_minus_1()
    }

    /// Everything suspended vertically from B, if enough is left on the bed.
    fn slack(&self) -> Result<Option<CompositeUnknowns>, CatenaryError> {
        let Some(offset) = self.straight() else {
            return Ok(None);
        };
        let state = CompositeUnknowns { h: 0.0, offset };
        let hangs: f64 = self.parts(state).map(|part| part.length).sum();
        if offset >= 0.0 || self.excess_length() < hangs {
            Ok(None)
        } else if self.slope.holds() {
            Ok(Some(state))
        } else {
            Err(self.slope.slides())
        }
    }

    /// The offset at which the line hangs vertically from B to the bed under it.
    fn straight(&self) -> Option<f64> {
        if self.wholly {
            return Some(-self.chain().weight);
        }
        let chain = self.chain();
        decreasing_root(-0.5 * chain.weight, chain.absolute_weight(), |offset| {
            let (mut miss, mut slope) = (self.height, 0.0);
            for part in self.parts(CompositeUnknowns { h: 0.0, offset }) {
                let span = self.chain().part_span(&part);
                miss -= span.reach(0.0, part.va).1;
                slope += span.compliance(0.0, part.va).vv;
            }
            (miss, slope)
        })
    }

    /// The unknowns at which B has its position.
    fn solve_unknowns(&self) -> Option<(CompositeUnknowns, u32)> {
        let (guess, offset) = self.line.guess();
        let (mut at, wanted) = (offset.min(0.0), self.wanted().0);
        let root = increasing_root(guess, f64::INFINITY, |h| {
            at = self.offset_at(h, at).unwrap_or(f64::NAN);
            let reach = self.end_reach(CompositeUnknowns { h, offset: at });
            let held = if self.wholly {
                0.0
            } else {
                reach.x_by[1] * reach.z_by[0] / reach.z_by[1]
            };
            FunctionSample {
                value: reach.x - wanted,
                log_slope: h * (reach.x_by[0] - held),
                scale: reach.scale + wanted.abs(),
            }
        })?;
        let offset = self.offset_at(root.x, at)?;
        Some((CompositeUnknowns { h: root.x, offset }, root.evaluations))
    }

    /// Position of B minus position reached, to 30 digits on a level bed.
    fn residuals(&self, state: CompositeUnknowns) -> (f64, f64) {
        let lift = DoubleDouble::from(state.h) * self.slope.tan;
        let mut along = DoubleDouble::from(self.chain().length) + self.stretch(state).0;
        let mut x = DoubleDouble::from(-self.line.x);
        let mut z = DoubleDouble::from(-self.line.z);
        for part in self.parts(state) {
            let va = lift + (part.va - state.h * self.slope.tan);
            let span = self.chain().part_span(&part);
            let (dx, dz) = span.reach_exactly(state.h, va);
            along = along + -part.length;
            (x, z) = (x + dx, z + dz);
        }
        if state.h <= 0.0 {
            // Slack: the heap reaches to the foot of the suspended part.
            return (0.0, -(z + self.line.x * self.slope.tan).value());
        }
        let x = x + along + -(along.value() * self.slope.secant_minus_1() * self.slope.cos);
        let z = z + along * self.slope.sin;
        (-x.value(), -z.value())
    }

    /// Changes of H and of the offset that move B by (x, z); by z alone where the line is slack.
    pub(super) fn step(
        &self,
        reach: &EndReach,
        state: CompositeUnknowns,
        x: f64,
        z: f64,
    ) -> (f64, f64) {
        let ([a, b], [c, d]) = (reach.x_by, reach.z_by);
        match (self.wholly, state.h > 0.0) {
            (true, true) => (x / a, 0.0),
            (true, false) => (0.0, 0.0),
            (false, false) => (0.0, z / d),
            (false, true) => {
                let det = a * d - b * c;
                ((x * d - b * z) / det, (a * z - c * x) / det)
            }
        }
    }

    fn top(&self, state: CompositeUnknowns) -> f64 {
        let v = state.h * self.slope.tan + state.offset + self.chain().weight;
        let at_a = state.h / self.slope.cos + self.slope.drop() * state.offset;
        length(state.h, v).max(at_a)
    }

    /// Newton steps on the residuals with 30 digits; the rest as error of force over the larger tension.
    pub(super) fn verify(&self, mut state: CompositeUnknowns) -> (CompositeUnknowns, f64) {
        let mut best = (state, f64::INFINITY);
        // On a slope the position of B has 16 digits.
        let blur = f64::EPSILON * self.line.x * self.slope.secant_minus_1();
        for _ in 0..3 {
            let reach = self.end_reach(state);
            let force = |step: (f64, f64)| length(step.0, self.slope.tan * step.0 + step.1);
            let (x, z) = self.residuals(state);
            let step = self.step(&reach, state, x, z);
            let blurred = self.step(&reach, state, blur * self.slope.cos, blur * self.slope.sin);
            let error = (force(step) + force(blurred)) / self.top(state);
            if error.is_nan() || error >= best.1 {
                break;
            }
            best = (state, error);
            if error < 1e-14 || state.h + step.0 <= 0.0 {
                break;
            }
            state = CompositeUnknowns {
                h: state.h + step.0,
                offset: state.offset + step.1,
            };
        }
        best
    }
}
