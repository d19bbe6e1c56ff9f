//! Newton's method on the convex energy of `elements`, with a line search on its slope.
//!
//! Along any direction the derivative of a convex function only rises. A step is taken when the
//! derivative at its end is no more than half of what it was at its beginning, turned round; otherwise the step is
//! shortened by the secant. That needs no energy values, only the residuals, and converges from every start
//! to the one minimum. The caller verifies the result, so a search that runs out of steps is detected.

use super::elements::{Bay, BayReach, LineElements};
use crate::numerics::log_newton::{FunctionSample, increasing_root};
use crate::numerics::roots::decreasing_root;

/// Horizontal force and vertical offsets.
#[derive(Debug, Clone)]
pub(super) struct BayUnknowns {
    pub h: f64,
    /// One for each bay.
    pub offsets: Vec<f64>,
}

/// The residuals at a state with their derivatives.
pub(super) struct Residuals {
    /// Distance given minus reached, and the same for the rise of each bay.
    pub x: f64,
    pub z: Vec<f64>,
    spreads: Vec<BayReach>,
    /// ∂x/∂H of the grounded line
    compliance: f64,
}

/// Greatest number of evaluations of the line.
const LIMIT: u32 = 60;

pub(super) fn residuals(
    chain: &LineElements,
    bays: &[Bay],
    state: &BayUnknowns,
    x: f64,
) -> Residuals {
    let mut miss = x - chain.length - state.h * chain.compliance;
    let mut spreads = Vec::with_capacity(bays.len());
    let mut z = Vec::with_capacity(bays.len());
    for (bay, offset) in bays.iter().zip(&state.offsets) {
        let spread = chain.bay_reach(bay, state.h, *offset);
        miss -= spread.x;
        z.push(bay.rise - spread.z);
        spreads.push(spread);
    }
    Residuals {
        x: miss,
        z,
        spreads,
        compliance: chain.compliance,
    }
}

impl Residuals {
    /// ∂x/∂H with every bay keeping its rise.
    fn by_h(&self) -> f64 {
        let kept = |s: &BayReach| s.hh - s.hv * s.hv / s.vv;
        self.compliance + self.spreads.iter().map(kept).sum::<f64>()
    }

    /// Changes of H and of the offsets that remove a residual.
    pub(super) fn step(&self, x: f64, z: &[f64]) -> BayUnknowns {
        let by_h = self.by_h();
        let mut rest = x;
        for (spread, z) in self.spreads.iter().zip(z) {
            rest -= spread.hv / spread.vv * z;
        }
        let h = if by_h.is_finite() { rest / by_h } else { 0.0 };
        let offsets = self
            .spreads
            .iter()
            .zip(z)
            .map(|(spread, z)| (z - spread.hv * h) / spread.vv)
            .collect();
        BayUnknowns { h, offsets }
    }

    /// Whether every bay is off the bed, so that its rise depends on its offset.
    fn is_regular(&self) -> bool {
        self.spreads.iter().all(|spread| spread.vv > 0.0)
    }

    /// Derivative of the energy along a step: negative while the energy falls.
    fn along(&self, step: &BayUnknowns) -> f64 {
        let z: f64 = self.z.iter().zip(&step.offsets).map(|(a, b)| a * b).sum();
        -(self.x * step.h + z)
    }
}

fn moved(state: &BayUnknowns, step: &BayUnknowns, part: f64) -> BayUnknowns {
    BayUnknowns {
        h: state.h + part * step.h,
        offsets: state
            .offsets
            .iter()
            .zip(&step.offsets)
            .map(|(a, b)| a + part * b)
            .collect(),
    }
}

/// Size of a step over the size of the forces at the bays' ends.
pub(super) fn relative(step: &BayUnknowns, state: &BayUnknowns, top: f64) -> f64 {
    // A sum of squares, so that NaN is kept.
    let squares: f64 = step.offsets.iter().map(|v| v * v).sum();
    (step.h * step.h + squares).sqrt() / top.max(state.h).max(1e-200)
}

/// From `start` to the minimum; with the number of evaluations. By Newton's method, and where that
/// converges slowly (nearly slack lines have corners everywhere) by bisection within bisection.
pub(super) fn minimise(
    chain: &LineElements,
    bays: &[Bay],
    start: BayUnknowns,
    x: f64,
    top: impl Fn(&BayUnknowns) -> f64,
) -> (BayUnknowns, u32) {
    let (state, evaluations, done) = newton(chain, bays, start, x, top);
    if done {
        return (state, evaluations);
    }
    match nested_bisection(chain, bays, &state, x) {
        Some((state, more)) => (state, evaluations + more),
        None => (state, evaluations),
    }
}

/// For every H the offsets that give the rises; then the reach rises with H alone.
fn nested_bisection(
    chain: &LineElements,
    bays: &[Bay],
    start: &BayUnknowns,
    x: f64,
) -> Option<(BayUnknowns, u32)> {
    let mut offsets = start.offsets.clone();
    let mut at = |h: f64| {
        for (bay, offset) in bays.iter().zip(&mut offsets) {
            *offset = offset_for_rise(chain, bay, h, *offset).unwrap_or(f64::NAN);
        }
        BayUnknowns {
            h,
            offsets: offsets.clone(),
        }
    };
    let root = increasing_root(start.h.max(1e-200), f64::INFINITY, |h| {
        let here = residuals(chain, bays, &at(h), x);
        FunctionSample {
            value: -here.x,
            log_slope: h * here.by_h(),
            scale: chain.length,
        }
    })?;
    Some((at(root.x), root.evaluations))
}

/// Newton's method, and whether it converged.
fn newton(
    chain: &LineElements,
    bays: &[Bay],
    start: BayUnknowns,
    x: f64,
    top: impl Fn(&BayUnknowns) -> f64,
) -> (BayUnknowns, u32, bool) {
    let mut state = start;
    let mut here = residuals(chain, bays, &state, x);
    let mut evaluations = 1;
    let mut before = f64::INFINITY;
    while evaluations < LIMIT {
        let step = here.step(here.x, &here.z);
        let size = relative(&step, &state, top(&state));
        // Rounding: steps no longer shrink, or vanish.
        if size.is_nan() || size <= 1e-15 || (size < 1e-9 && size > 0.3 * before) {
            return (state, evaluations, size < 1e-9);
        }
        before = size;
        let slope = here.along(&step);
        let mut part = 1.0;
        if state.h + step.h <= 0.0 {
            part = 0.9 * state.h / -step.h;
        }
        loop {
            let next = moved(&state, &step, part);
            let there = residuals(chain, bays, &next, x);
            evaluations += 1;
            let slope_there = there.along(&step);
            let good = slope_there <= -0.5 * slope && there.is_regular();
            if good || size < 1e-9 || evaluations >= LIMIT {
                state = next;
                here = there;
                break;
            }
            part *= (slope / (slope - slope_there)).clamp(0.05, 0.7);
            if slope_there.is_nan() {
                part *= 0.1;
            }
        }
    }
    (state, evaluations, false)
}

/// The offset at which a bay has its rise for a given H, zero included; the rise grows with the offset.
pub(super) fn offset_for_rise(chain: &LineElements, bay: &Bay, h: f64, guess: f64) -> Option<f64> {
    decreasing_root(guess, chain.absolute_weight(), |at| {
        let spread = chain.bay_reach(bay, h, at);
        (bay.rise - spread.z, spread.vv)
    })
}
