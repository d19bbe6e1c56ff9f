//! Verified solutions of lines that touch nothing: straight without weight, or suspended.

use super::candidate::{Candidate, ROUNDING};
use super::error::CatenaryError;
use super::profile::{Piece, PieceLaw, Pieces};
use super::single::PlanarLine;
use super::solution::{Seed, Shape, Solution};
use super::span::{Span, length};
use super::suspended::SuspendedForces;
use crate::numerics::double_double::DoubleDouble;

pub(super) fn suspended_piece(
    line: &PlanarLine,
    from: f64,
    length: f64,
    at: (f64, f64),
    h: f64,
    va: f64,
) -> Piece {
    Piece {
        from,
        length,
        x: at.0,
        z: at.1,
        kind: PieceLaw::Suspended {
            h,
            va,
            w: line.w,
            ea: line.ea,
        },
    }
}

fn times(k: &[[f64; 2]; 2], (x, z): (f64, f64)) -> (f64, f64) {
    (k[0][0] * x + k[0][1] * z, k[1][0] * x + k[1][1] * z)
}

/// The line without weight, or so light beside its stretch that it has no sag; `None` otherwise.
pub(super) fn straight(line: &PlanarLine) -> Result<Option<Solution>, CatenaryError> {
    let PlanarLine {
        x,
        z,
        length,
        w,
        ea,
        ..
    } = *line;
    let square = |a: f64| DoubleDouble::from(a) * a;
    let over = (square(x) + square(z) - square(length)).value();
    let load = w * length;
    if load > 1e-200 * ea || (over < 0.0 && w > 0.0) {
        return Ok(None);
    }
    let distance = self::length(x, z);
    if ea.is_infinite() && over >= 0.0 {
        return Err(CatenaryError::TooShort {
            short_m: distance - length,
        });
    }
    if over < 0.0 {
        return Err(CatenaryError::ShapeUndetermined);
    }
    let tension = ea * over / (distance + length) / length;
    let (h, v) = (tension * x / distance, tension * z / distance);
    let span = Span {
        length,
        weight: 0.0,
        ea,
    };
    let stiffness = if tension > 0.0 {
        span.compliance(h, v).stiffness()
    } else {
        [[0.0; 2]; 2]
    };
    let found = Candidate {
        ends: [(h, v - 0.5 * load), (h, v + 0.5 * load)],
        on_bed: 0.0,
        shape: Shape::Straight,
        iterations: 0,
        residual: 0.0,
        stiffness,
        seed: Seed::None,
    };
    let piece = suspended_piece(line, 0.0, length, (0.0, 0.0), h, v - 0.5 * load);
    found.verified(line.frame, Pieces::few(&[piece])).map(Some)
}

/// The suspended line.
pub(super) fn suspended(
    line: &PlanarLine,
    forces: SuspendedForces,
) -> Result<Solution, CatenaryError> {
    let PlanarLine {
        x,
        z,
        length,
        w,
        ea,
        ..
    } = *line;
    let load = w * length;
    if ea.is_infinite() {
        let distance = self::length(x, z);
        if distance > length {
            return Err(CatenaryError::TooShort {
                short_m: distance - length,
            });
        }
    }
    let span = Span {
        length,
        weight: w,
        ea,
    };
    let (mut h, mut va) = (forces.h, forces.v_mean - 0.5 * load);
    let miss = |h: f64, va: f64| {
        let (dx, dz) = span.reach_exactly(h, va.into());
        ((-dx + x).value(), (-dz + z).value())
    };
    let stiffness = span.compliance(h, va).stiffness();
    let error = |h: f64, va: f64| {
        let step = times(&stiffness, miss(h, va));
        let top = self::length(h, va).max(self::length(h, va + load));
        (step, self::length(step.0, step.1) / top)
    };
    let (step, mut residual) = error(h, va);
    if residual > ROUNDING && h + step.0 > 0.0 {
        let better = error(h + step.0, va + step.1).1;
        if better < residual {
            (h, va, residual) = (h + step.0, va + step.1, better);
        }
    }
    let shape = match (h > 0.0 && x > 0.0, va < 0.0) {
        (true, _) => Shape::Hanging,
        (false, true) if va + load > 0.0 => Shape::HangingDouble,
        (false, _) => Shape::Vertical,
    };
    let found = Candidate {
        ends: [(h, va), (h, va + load)],
        on_bed: 0.0,
        shape,
        iterations: forces.iterations,
        residual,
        stiffness,
        seed: Seed::Suspended(forces.xi),
    };
    let piece = suspended_piece(line, 0.0, length, (0.0, 0.0), h, va);
    found.verified(line.frame, Pieces::few(&[piece]))
}
