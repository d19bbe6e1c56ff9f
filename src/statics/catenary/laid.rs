//! A line of several sections that lies from A on a bed with a slope or friction, then rises to B.
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
//! What hangs reaches (dx, dz), what lies `n + Σ ∫ T/EA ds` along the slope. The height of B rises with the offset for
//! any H, and its distance at that height with H: without friction both are derivatives of a convex energy, as in
//! `chain`, and friction adds stretch that rises with H. For one section this is `incline` (Jonkman 2007, eqs 2-37 and 2-38, on a level bed).

use super::chain::{Bay, Chain, Part};
use super::composite::Problem;
use super::descent::climb;
use super::error::CatenaryError;
use super::line::Bed;
use super::solution::Solution;
use super::span::{Span, length};
use crate::numerics::double_double::DoubleDouble;
use crate::numerics::log_newton::{Sample, increasing_root};

/// The line in the solver's plane with the bed through A.
pub(super) struct Laid<'a> {
    pub problem: &'a Problem,
    bay: Bay,
    pub sin: f64,
    pub cos: f64,
    pub tan: f64,
    friction: f64,
    /// Height of B above the bed's line.
    height: f64,
    /// Whether all of it sinks and B is on the bed as well.
    pub wholly: bool,
}

/// The unknowns.
#[derive(Debug, Clone, Copy)]
pub(super) struct State {
    pub h: f64,
    pub offset: f64,
}

/// A lying stretch of an element.
pub(super) struct Rest {
    pub element: usize,
    pub length: f64,
    /// Tension at its end, and what it loses per metre towards A.
    pub end: f64,
    pub loss: f64,
}

/// Where B is beyond lying unstretched along the bed, with derivatives by H and by the offset.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Look {
    x: f64,
    z: f64,
    x_by: [f64; 2],
    z_by: [f64; 2],
    /// Size of what `x` is made of.
    scale: f64,
}

pub(super) const SEVERAL: CatenaryError = CatenaryError::Pattern(
    "a line of several sections comes down in more than one place, or buoyant from its end on the bed; with \
     friction or a slope it is solved where it lies from end A in one stretch",
);

/// The line lying from A, or `None` when it touches the bed at A at most.
pub(super) fn solve(problem: &Problem, bed: Bed) -> Result<Option<Solution>, CatenaryError> {
    if problem.chain.elements[0].total() <= 0.0 {
        return Ok(None);
    }
    let laid = Laid::new(problem, bed);
    let slack = laid.slack()?.map(|state| (state, 0));
    let Some((state, looks)) = slack.or_else(|| laid.settle()) else {
        return Ok(None);
    };
    if state.offset >= 0.0 {
        return Ok(None);
    }
    let at_a = state.h / laid.cos + laid.drop() * state.offset;
    if at_a < 0.0 && !laid.holds() {
        return Err(laid.slides());
    }
    if sinks(problem, laid.parts(state), state.h, 0.0, laid.tan) {
        return Err(SEVERAL);
    }
    laid.finish(state, looks).map(Some)
}

/// Whether parts hanging in order, the first beginning `above` the bed's line, pass below that line between them.
pub(super) fn sinks(
    problem: &Problem,
    parts: impl Iterator<Item = Part>,
    h: f64,
    above: f64,
    tan: f64,
) -> bool {
    let least = -1e-9 * (problem.chain.length + problem.z.abs());
    let (mut height, mut before) = (above, f64::INFINITY);
    for part in parts {
        let span = problem.chain.part_span(&part);
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

impl<'a> Laid<'a> {
    fn new(problem: &'a Problem, bed: Bed) -> Self {
        let (sin, cos) = bed.slope_rad.sin_cos();
        let tan = bed.slope_rad.tan();
        let run = problem.run(0);
        let height = problem.z - problem.x * tan;
        let slip = 1e-12 * (problem.chain.length + problem.z.abs());
        Self {
            problem,
            bay: Bay {
                over: (0, problem.last()),
                from: Some(run),
                onto: None,
                rise: 0.0,
            },
            sin,
            cos,
            tan,
            friction: bed.friction,
            height,
            wholly: run.1 == problem.last() && height <= slip,
        }
    }

    pub(super) fn chain(&self) -> &Chain {
        &self.problem.chain
    }

    /// Tension lost towards A per weight on the bed.
    pub(super) fn drop(&self) -> f64 {
        self.sin + self.friction * self.cos
    }

    fn holds(&self) -> bool {
        self.friction >= self.tan.abs()
    }

    fn slides(&self) -> CatenaryError {
        CatenaryError::SlackOnSlope {
            needed: self.tan.abs(),
        }
    }

    /// The hanging parts with their true vertical force.
    pub(super) fn parts(&self, state: State) -> impl Iterator<Item = Part> + '_ {
        let lift = state.h * self.tan;
        let all = (!self.wholly).then(|| self.chain().parts(&self.bay, state.offset));
        all.into_iter().flatten().map(move |part| Part {
            va: part.va + lift,
            ..part
        })
    }

    /// The lying stretches, in order from A.
    pub(super) fn rests(&self, state: State) -> impl Iterator<Item = Rest> + '_ {
        let first = self.parts(state).next();
        let (last, within) = first.map_or((self.chain().elements.len(), 0.0), |part| {
            (part.element, part.begin)
        });
        let elements = self.chain().elements.iter().enumerate();
        elements.take(last + 1).filter_map(move |(i, element)| {
            let length = if i < last { element.length } else { within };
            let end = state.offset + self.chain().weight_before[i] + element.weight * length;
            (length > 0.0).then(|| Rest {
                element: i,
                length,
                end: state.h / self.cos + self.drop() * end.min(0.0),
                loss: self.drop() * element.weight,
            })
        })
    }

    /// What of a lying stretch is under tension, from its end.
    fn tight(&self, rest: &Rest) -> f64 {
        if !self.holds() || rest.end - rest.loss * rest.length >= 0.0 {
            rest.length
        } else if rest.end <= 0.0 {
            0.0
        } else {
            rest.end / rest.loss
        }
    }

    /// Stretch of all that lies, and its derivatives by H and by the offset.
    fn stretch(&self, state: State) -> (f64, [f64; 2]) {
        let (mut sum, mut give) = (0.0, 0.0);
        for rest in self.rests(state) {
            let (ea, n) = (self.chain().elements[rest.element].ea, self.tight(&rest));
            sum += n * (rest.end - 0.5 * rest.loss * n) / ea;
            give += n / ea;
        }
        (sum, [give / self.cos, give * self.drop()])
    }

    pub(super) fn look(&self, state: State) -> Look {
        let (stretch, [by_h, by_offset]) = self.stretch(state);
        let mut look = Look {
            x: stretch * self.cos,
            z: stretch * self.sin,
            x_by: [by_h * self.cos, by_offset * self.cos],
            z_by: [by_h * self.sin, by_offset * self.sin],
            scale: stretch.abs(),
        };
        for part in self.parts(state) {
            let span = self.chain().part_span(&part);
            let (dx, dz) = span.reach(state.h, part.va);
            let c = span.compliance(state.h, part.va);
            look.x += dx - span.length * self.cos;
            look.z += dz - span.length * self.sin;
            look.scale += span.length;
            look.x_by[0] += c.hh + c.hv * self.tan;
            look.x_by[1] += c.hv;
            look.z_by[0] += c.hv + c.vv * self.tan;
            look.z_by[1] += c.vv;
        }
        look
    }

    /// The offset that lifts B to its height.
    fn lifted(&self, h: f64, guess: f64) -> Option<f64> {
        if self.wholly {
            return Some(-self.chain().weight);
        }
        let wanted = self.wanted().1;
        climb(self.chain(), guess, |offset| {
            let look = self.look(State { h, offset });
            (wanted - look.z, look.z_by[1])
        })
    }

    /// B beyond lying unstretched along the bed.
    fn wanted(&self) -> (f64, f64) {
        let (chain, problem) = (self.chain(), self.problem);
        (
            problem.x - chain.length * self.cos,
            problem.z - chain.length * self.sin,
        )
    }

    /// Unstretched length beyond the distance along the bed.
    fn spare(&self) -> f64 {
        (self.chain().length - self.problem.x) - self.problem.x * self.longer()
    }

    /// Everything hanging straight from B, if enough is left on the bed.
    fn slack(&self) -> Result<Option<State>, CatenaryError> {
        let Some(offset) = self.straight() else {
            return Ok(None);
        };
        let state = State { h: 0.0, offset };
        let hangs: f64 = self.parts(state).map(|part| part.length).sum();
        if offset >= 0.0 || self.spare() < hangs {
            Ok(None)
        } else if self.holds() {
            Ok(Some(state))
        } else {
            Err(self.slides())
        }
    }

    /// The offset at which the line hangs straight down from B to the bed under it.
    fn straight(&self) -> Option<f64> {
        if self.wholly {
            return Some(-self.chain().weight);
        }
        climb(self.chain(), -0.5 * self.chain().weight, |offset| {
            let (mut miss, mut slope) = (self.height, 0.0);
            for part in self.parts(State { h: 0.0, offset }) {
                let span = self.chain().part_span(&part);
                miss -= span.reach(0.0, part.va).1;
                slope += span.compliance(0.0, part.va).vv;
            }
            (miss, slope)
        })
    }

    /// The state at which B is where it is asked for.
    fn settle(&self) -> Option<(State, u32)> {
        let (guess, offset) = self.problem.guess();
        let (mut at, wanted) = (offset.min(0.0), self.wanted().0);
        let root = increasing_root(guess, f64::INFINITY, |h| {
            at = self.lifted(h, at).unwrap_or(f64::NAN);
            let look = self.look(State { h, offset: at });
            let held = if self.wholly {
                0.0
            } else {
                look.x_by[1] * look.z_by[0] / look.z_by[1]
            };
            Sample {
                value: look.x - wanted,
                log_slope: h * (look.x_by[0] - held),
                scale: look.scale + wanted.abs(),
            }
        })?;
        let offset = self.lifted(root.x, at)?;
        Some((State { h: root.x, offset }, root.evaluations))
    }

    /// How far B is missed, to 30 digits on a level bed.
    fn misses(&self, state: State) -> (f64, f64) {
        let lift = DoubleDouble::from(state.h) * self.tan;
        let mut along = DoubleDouble::from(self.chain().length) + self.stretch(state).0;
        let mut x = DoubleDouble::from(-self.problem.x);
        let mut z = DoubleDouble::from(-self.problem.z);
        for part in self.parts(state) {
            let va = lift + (part.va - state.h * self.tan);
            let span = self.chain().part_span(&part);
            let (dx, dz) = span.reach_exactly(state.h, va);
            along = along + -part.length;
            (x, z) = (x + dx, z + dz);
        }
        if state.h <= 0.0 {
            // Slack: the heap reaches as far as the foot of what hangs.
            return (0.0, -(z + self.problem.x * self.tan).value());
        }
        let x = x + along + -(along.value() * self.longer() * self.cos);
        let z = z + along * self.sin;
        (-x.value(), -z.value())
    }

    /// 1/cos θ - 1
    fn longer(&self) -> f64 {
        self.tan * self.tan / (1.0 + 1.0 / self.cos)
    }

    /// Changes of H and of the offset that move B by (x, z); by z alone where the line is slack.
    pub(super) fn step(&self, look: &Look, state: State, x: f64, z: f64) -> (f64, f64) {
        let ([a, b], [c, d]) = (look.x_by, look.z_by);
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

    fn top(&self, state: State) -> f64 {
        let v = state.h * self.tan + state.offset + self.chain().weight;
        let at_a = state.h / self.cos + self.drop() * state.offset;
        length(state.h, v).max(at_a)
    }

    /// Newton's steps on the misses with 30 digits; what is left as error of force over the larger tension.
    pub(super) fn verify(&self, mut state: State) -> (State, f64) {
        let mut best = (state, f64::INFINITY);
        // On a slope B is where it is asked for only to 16 digits of the distance.
        let blur = f64::EPSILON * self.problem.x * self.longer();
        for _ in 0..3 {
            let look = self.look(state);
            let force = |step: (f64, f64)| length(step.0, self.tan * step.0 + step.1);
            let (x, z) = self.misses(state);
            let step = self.step(&look, state, x, z);
            let blurred = self.step(&look, state, blur * self.cos, blur * self.sin);
            let error = (force(step) + force(blurred)) / self.top(state);
            if error.is_nan() || error >= best.1 {
                break;
            }
            best = (state, error);
            if error < 1e-14 || state.h + step.0 <= 0.0 {
                break;
            }
            state = State {
                h: state.h + step.0,
                offset: state.offset + step.1,
            };
        }
        best
    }
}
