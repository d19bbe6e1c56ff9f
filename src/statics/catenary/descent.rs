//! Newton's method on the convex energy of `chain`, with a line search that cannot be fooled.
//!
//! Along any direction the derivative of a convex function only rises. A step is taken when the
//! derivative at its end is no more than half of what it was at its beginning, turned round; otherwise the step is
//! shortened by the secant. That needs no energy values, only the misses, and drives every start
//! to the one minimum. What comes out is verified by the caller, so running out of steps is told.

use super::chain::{Bay, Chain, Spread};
use crate::numerics::log_newton::{Sample, increasing_root};

/// The unknowns.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub h: f64,
    /// One for each bay.
    pub offsets: Vec<f64>,
}

/// The misses at a state and what answers them.
pub(super) struct Misses {
    /// Distance asked for less reached; and the same for the rise of each bay.
    pub x: f64,
    pub z: Vec<f64>,
    spreads: Vec<Spread>,
    /// ∂x/∂H of what lies
    give: f64,
}

/// Steps enough for any line met; each costs one look at the line.
const LIMIT: u32 = 60;

pub(super) fn misses(chain: &Chain, bays: &[Bay], state: &State, x: f64) -> Misses {
    let mut miss = x - chain.length - state.h * chain.give;
    let mut spreads = Vec::with_capacity(bays.len());
    let mut z = Vec::with_capacity(bays.len());
    for (bay, offset) in bays.iter().zip(&state.offsets) {
        let spread = chain.spread(bay, state.h, *offset);
        miss -= spread.x;
        z.push(bay.rise - spread.z);
        spreads.push(spread);
    }
    Misses {
        x: miss,
        z,
        spreads,
        give: chain.give,
    }
}

impl Misses {
    /// ∂x/∂H with every bay keeping its rise.
    fn by_h(&self) -> f64 {
        let kept = |s: &Spread| s.hh - s.hv * s.hv / s.vv;
        self.give + self.spreads.iter().map(kept).sum::<f64>()
    }

    /// Changes of H and of the offsets that answer a miss.
    pub(super) fn step(&self, x: f64, z: &[f64]) -> State {
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
        State { h, offsets }
    }

    /// Whether every bay is off the bed, so that its rise answers to its offset.
    fn answers(&self) -> bool {
        self.spreads.iter().all(|spread| spread.vv > 0.0)
    }

    /// Derivative of the energy along a step: less than zero while it pays to go on.
    fn along(&self, step: &State) -> f64 {
        let z: f64 = self.z.iter().zip(&step.offsets).map(|(a, b)| a * b).sum();
        -(self.x * step.h + z)
    }
}

fn moved(state: &State, step: &State, part: f64) -> State {
    State {
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
pub(super) fn relative(step: &State, state: &State, top: f64) -> f64 {
    // A sum of squares, so that what is not a number stays so.
    let squares: f64 = step.offsets.iter().map(|v| v * v).sum();
    (step.h * step.h + squares).sqrt() / top.max(state.h).max(1e-200)
}

/// From `start` to the minimum; the number of looks at the line taken. By Newton's method, and where that
/// dawdles (nearly slack lines are all corners) by bisection within bisection, which cannot.
pub(super) fn settle(
    chain: &Chain,
    bays: &[Bay],
    start: State,
    x: f64,
    top: impl Fn(&State) -> f64,
) -> (State, u32) {
    let (state, looks, done) = descend(chain, bays, start, x, top);
    if done {
        return (state, looks);
    }
    match nested(chain, bays, &state, x) {
        Some((state, more)) => (state, looks + more),
        None => (state, looks),
    }
}

/// For every H the offsets that give the rises; then the reach rises with H alone.
fn nested(chain: &Chain, bays: &[Bay], start: &State, x: f64) -> Option<(State, u32)> {
    let mut offsets = start.offsets.clone();
    let mut at = |h: f64| {
        for (bay, offset) in bays.iter().zip(&mut offsets) {
            *offset = lift(chain, bay, h, *offset).unwrap_or(f64::NAN);
        }
        State {
            h,
            offsets: offsets.clone(),
        }
    };
    let root = increasing_root(start.h.max(1e-200), f64::INFINITY, |h| {
        let here = misses(chain, bays, &at(h), x);
        Sample {
            value: -here.x,
            log_slope: h * here.by_h(),
            scale: chain.length,
        }
    })?;
    Some((at(root.x), root.evaluations))
}

/// Newton's method; tells whether it arrived.
fn descend(
    chain: &Chain,
    bays: &[Bay],
    start: State,
    x: f64,
    top: impl Fn(&State) -> f64,
) -> (State, u32, bool) {
    let mut state = start;
    let mut here = misses(chain, bays, &state, x);
    let mut looks = 1;
    let mut before = f64::INFINITY;
    while looks < LIMIT {
        let step = here.step(here.x, &here.z);
        let size = relative(&step, &state, top(&state));
        // Rounding: steps no longer shrink, or are nothing.
        if size.is_nan() || size <= 1e-15 || (size < 1e-9 && size > 0.3 * before) {
            return (state, looks, size < 1e-9);
        }
        before = size;
        let slope = here.along(&step);
        let mut part = 1.0;
        if state.h + step.h <= 0.0 {
            part = 0.9 * state.h / -step.h;
        }
        loop {
            let next = moved(&state, &step, part);
            let there = misses(chain, bays, &next, x);
            looks += 1;
            let slope_there = there.along(&step);
            let good = slope_there <= -0.5 * slope && there.answers();
            if good || size < 1e-9 || looks >= LIMIT {
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
    (state, looks, false)
}

/// The offset at which a bay has its rise for a given H, zero included; the rise grows with the offset.
pub(super) fn lift(chain: &Chain, bay: &Bay, h: f64, guess: f64) -> Option<f64> {
    climb(chain, guess, |at| {
        let spread = chain.spread(bay, h, at);
        (bay.rise - spread.z, spread.vv)
    })
}

/// The offset at which a miss that falls with it is zero; `look` gives the miss and how fast it falls.
pub(super) fn climb(
    chain: &Chain,
    guess: f64,
    mut look: impl FnMut(f64) -> (f64, f64),
) -> Option<f64> {
    let weight: f64 = chain.elements.iter().map(|e| e.total().abs()).sum();
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let (mut at, mut reach) = (guess, weight);
    for _ in 0..2000 {
        let (miss, slope) = look(at);
        if miss > 0.0 {
            low = at;
        } else {
            high = at;
        }
        let step = miss / slope;
        if miss == 0.0 || step.abs() <= f64::EPSILON * at.abs() {
            return Some(at + if step.is_finite() { step } else { 0.0 });
        }
        let mut next = at + step;
        if !(next > low && next < high) {
            next = match (low.is_finite(), high.is_finite()) {
                (true, true) => 0.5 * (low + high),
                (true, false) => at + reach,
                _ => at - reach,
            };
            reach *= 2.0;
        }
        if next <= low || next >= high {
            return Some(at);
        }
        at = next;
    }
    None
}
