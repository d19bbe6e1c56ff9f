//! From the unknowns of a regime to a verified solution.
//!
//! Nothing is returned before the forces, put back into the formulas of `span` with 30 digits, have
//! led to end B. The miss is turned into force by the line's own stiffness: metres say nothing about a
//! stiff line. One step of Newton with that miss mends what rounding spoiled; what then still misses by
//! more than [`BELIEVED`] is refused.

use super::error::CatenaryError;
use super::free::Free;
use super::single::Plane;
use super::solution::{Kind, Piece, Pieces, Seed, Shape, Solution};
use super::span::{Span, length};
use crate::numerics::double_double::DoubleDouble;

/// Largest error of force, over the end tension, that is given out as solved.
pub(super) const BELIEVED: f64 = 1e-7;
/// Errors below this are rounding.
pub(super) const ROUNDING: f64 = 1e-13;

/// What all regimes hand in: forces in the solver's plane.
pub(super) struct Found {
    pub ends: [(f64, f64); 2],
    pub on_bed: f64,
    pub shape: Shape,
    pub iterations: u32,
    pub residual: f64,
    pub stiffness: [[f64; 2]; 2],
    pub seed: Seed,
}

pub(super) fn finish(
    plane: &Plane,
    found: &Found,
    pieces: Pieces,
) -> Result<Solution, CatenaryError> {
    let up = plane.frame.up;
    let [(h_a, v_a), (h_b, v_b)] = found.ends;
    let sound = h_a.is_finite() && v_a.is_finite() && h_b.is_finite() && v_b.is_finite();
    if !(sound && found.residual <= BELIEVED) {
        return Err(CatenaryError::NotVerified {
            error: found.residual,
            iterations: found.iterations,
        });
    }
    let [[xx, xz], [zx, zz]] = found.stiffness;
    Ok(Solution {
        h_a_n: h_a,
        v_a_n: up * v_a,
        h_b_n: h_b,
        v_b_n: up * v_b,
        on_bed_m: found.on_bed,
        shape: found.shape,
        against_surface: up < 0.0 && found.on_bed > 0.0,
        iterations: found.iterations,
        residual: found.residual,
        stiffness_n_per_m: [[xx, up * xz], [up * zx, zz]],
        frame: plane.frame,
        pieces,
        seed: found.seed,
    })
}

/// Up to three pieces, empty ones left out.
pub(super) fn few(pieces: &[Piece]) -> Pieces {
    let mut few = [Piece::default(); 3];
    let mut n = 0;
    for piece in pieces {
        if piece.length > 0.0 && n < few.len() {
            few[n] = *piece;
            n += 1;
        }
    }
    Pieces::Few(few, n)
}

pub(super) fn hanging_piece(
    plane: &Plane,
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
        kind: Kind::Hanging {
            h,
            va,
            w: plane.w,
            ea: plane.ea,
        },
    }
}

fn times(k: &[[f64; 2]; 2], (x, z): (f64, f64)) -> (f64, f64) {
    (k[0][0] * x + k[0][1] * z, k[1][0] * x + k[1][1] * z)
}

/// The line without weight, or so light beside its stretch that sag is nothing; `None` otherwise.
pub(super) fn straight(plane: &Plane) -> Result<Option<Solution>, CatenaryError> {
    let Plane {
        x,
        z,
        length,
        w,
        ea,
        ..
    } = *plane;
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
    let found = Found {
        ends: [(h, v - 0.5 * load), (h, v + 0.5 * load)],
        on_bed: 0.0,
        shape: Shape::Straight,
        iterations: 0,
        residual: 0.0,
        stiffness,
        seed: Seed::None,
    };
    let piece = hanging_piece(plane, 0.0, length, (0.0, 0.0), h, v - 0.5 * load);
    finish(plane, &found, few(&[piece])).map(Some)
}

/// The line that touches nothing.
pub(super) fn hanging(plane: &Plane, free: Free) -> Result<Solution, CatenaryError> {
    let Plane {
        x,
        z,
        length,
        w,
        ea,
        ..
    } = *plane;
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
    let (mut h, mut va) = (free.h, free.v_mean - 0.5 * load);
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
    let found = Found {
        ends: [(h, va), (h, va + load)],
        on_bed: 0.0,
        shape,
        iterations: free.iterations,
        residual,
        stiffness,
        seed: Seed::Free(free.xi),
    };
    let piece = hanging_piece(plane, 0.0, length, (0.0, 0.0), h, va);
    finish(plane, &found, few(&[piece]))
}
