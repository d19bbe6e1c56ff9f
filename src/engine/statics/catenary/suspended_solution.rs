//! Verified solutions of lines that touch nothing: straight without weight, or suspended.

use super::candidate::{Candidate, ROUNDING};
use super::error::CatenaryError;
use super::planar_line::PlanarLine;
use super::profile::Pieces;
use super::solution::{CatenaryShape, Solution, StartingUnknown};
use super::span::{Span, length};
use super::suspended::SuspendedForces;
use crate::numerics::double_double::DoubleDouble;

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
        shape: CatenaryShape::Straight,
        iterations: 0,
        residual: 0.0,
        stiffness,
        seed: StartingUnknown::None,
    };
    let piece = line.suspended_piece(0.0, length, (0.0, 0.0), h, v - 0.5 * load);
    found.verified(line.frame, Pieces::few(&[piece])).map(Some)
}

/// The suspended line.
pub(super) fn suspended(
    line: &PlanarLine,
    forces: SuspendedForces,
) -> Result<Solution, CatenaryError> {
    let (length, load) = (line.length, line.w * line.length);
    let distance = self::length(line.x, line.z);
    if line.ea.is_infinite() && distance > length {
        return Err(CatenaryError::TooShort {
            short_m: distance - length,
        });
    }
    let span = line.span(length);
    let (mut h, mut va) = (forces.h, forces.v_mean - 0.5 * load);
    let stiffness = span.compliance(h, va).stiffness();
    // The Newton step that removes the residual of position, and its size over the end tension.
    let step = |h: f64, va: f64| {
        let (dx, dz) = span.reach_exactly(h, va.into());
        let step = times(&stiffness, ((-dx + line.x).value(), (-dz + line.z).value()));
        let top = self::length(h, va).max(self::length(h, va + load));
        (step, self::length(step.0, step.1) / top)
    };
    let ((dh, dv), mut residual) = step(h, va);
    if residual > ROUNDING && h + dh > 0.0 {
        let better = step(h + dh, va + dv).1;
        if better < residual {
            (h, va, residual) = (h + dh, va + dv, better);
        }
    }
    let found = Candidate {
        ends: [(h, va), (h, va + load)],
        on_bed: 0.0,
        shape: match (h > 0.0 && line.x > 0.0, va < 0.0) {
            (true, _) => CatenaryShape::Hanging,
            (false, true) if va + load > 0.0 => CatenaryShape::HangingDouble,
            (false, _) => CatenaryShape::Vertical,
        },
        iterations: forces.iterations,
        residual,
        stiffness,
        seed: StartingUnknown::Suspended(forces.xi),
    };
    let piece = line.suspended_piece(0.0, length, (0.0, 0.0), h, va);
    found.verified(line.frame, Pieces::few(&[piece]))
}
