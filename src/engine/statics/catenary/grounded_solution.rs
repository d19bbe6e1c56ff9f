//! Verified solutions of lines of one section that rest on the bed.

use super::candidate::{Candidate, ROUNDING};
use super::error::CatenaryError;
use super::grounded_span::{GroundedForces, GroundedSpan};
use super::planar_line::PlanarLine;
use super::profile::{PieceLaw, Pieces, ProfilePiece, grounded_tension_sum};
use super::solution::{CatenaryShape, Solution, StartingUnknown};
use super::span::length;
use super::touchdown::{TouchdownLine, TouchdownUnknowns};

/// Grounded from A to the touchdown point, suspended from there to B.
pub(super) fn partial_contact(
    touchdown: &TouchdownLine,
    mut state: TouchdownUnknowns,
    iterations: u32,
) -> Result<Solution, CatenaryError> {
    let line = &touchdown.line;
    let newton_step = |state: TouchdownUnknowns| {
        let leg = touchdown.leg(state);
        let miss = touchdown.residual(state, &leg);
        let step = touchdown.step(&leg, -miss.0, -miss.1);
        let (dh, dv) = TouchdownLine::force_step(state, &leg, step);
        let top = length(state.h, touchdown.v_b(state, &leg));
        (leg, step, length(dh, dv) / top)
    };
    let (mut leg, step, mut residual) = newton_step(state);
    let corrected = TouchdownUnknowns {
        h: state.h + step.0,
        beta: state.beta + step.1,
    };
    if residual > ROUNDING && corrected.h > 0.0 && corrected.beta > 0.0 {
        let better = newton_step(corrected);
        if better.2 < residual {
            (state, leg, residual) = (corrected, better.0, better.2);
        }
    }
    residual += touchdown.slope_rounding(state, &leg) / length(state.h, touchdown.v_b(state, &leg));
    let on_bed = (line.length - leg.s).max(0.0);
    let t0 = state.h / touchdown.slope.cos;
    let t_a = touchdown.tension_a(t0, on_bed);
    let column = |x, z| TouchdownLine::force_step(state, &leg, touchdown.step(&leg, x, z));
    let (by_x, by_z) = (column(1.0, 0.0), column(0.0, 1.0));
    let found = Candidate {
        ends: [
            (t_a * touchdown.slope.cos, t_a * touchdown.slope.sin),
            (state.h, touchdown.v_b(state, &leg)),
        ],
        on_bed,
        shape: CatenaryShape::PartlyOnBed,
        iterations,
        residual,
        stiffness: [[by_x.0, by_z.0], [by_x.1, by_z.1]],
        seed: StartingUnknown::Touchdown(state.beta),
    };
    let lying = touchdown.grounded_length(t0, on_bed);
    let lift_off = (lying * touchdown.slope.cos, lying * touchdown.slope.sin);
    let pieces = [
        grounded_piece(touchdown, on_bed, t0),
        line.suspended_piece(
            on_bed,
            leg.s,
            lift_off,
            state.h,
            state.h * touchdown.slope.tan,
        ),
    ];
    found.verified(line.frame, Pieces::few(&pieces))
}

fn grounded_piece(touchdown: &TouchdownLine, length: f64, end: f64) -> ProfilePiece {
    ProfilePiece {
        length,
        kind: PieceLaw::Grounded {
            end,
            loss: touchdown.loss(),
            cos: touchdown.slope.cos,
            sin: touchdown.slope.sin,
            ea: touchdown.line.ea,
        },
        ..ProfilePiece::default()
    }
}

/// Grounded from end to end. Only the stiffness along the bed is given.
pub(super) fn full_contact(touchdown: &TouchdownLine, t_b: f64) -> Result<Solution, CatenaryError> {
    let line = &touchdown.line;
    let (sin, cos) = (touchdown.slope.sin, touchdown.slope.cos);
    let (length, loss) = (line.length, touchdown.loss());
    let moving = if loss > 0.0 {
        length.min(t_b / loss)
    } else {
        length
    };
    let miss = -touchdown.excess_length() - grounded_tension_sum(t_b, loss, length) / line.ea;
    let k = if moving > 0.0 { line.ea / moving } else { 0.0 };
    let t_a = touchdown.tension_a(t_b, length);
    let blur = length * touchdown.slope.secant_minus_1();
    let rounding = if sin == 0.0 {
        4.0 * f64::EPSILON * length
    } else {
        0.0
    };
    let residual = if miss.abs() <= rounding {
        0.0
    } else {
        k * (miss.abs() + f64::EPSILON * blur) / t_b.max(t_a)
    };
    let found = Candidate {
        ends: [(t_a * cos, t_a * sin), (t_b * cos, t_b * sin)],
        on_bed: length,
        shape: CatenaryShape::WhollyOnBed,
        iterations: 0,
        residual,
        stiffness: [
            [k * cos * cos, k * cos * sin],
            [k * cos * sin, k * sin * sin],
        ],
        seed: StartingUnknown::None,
    };
    found.verified(
        line.frame,
        Pieces::few(&[grounded_piece(touchdown, length, t_b)]),
    )
}

/// Force per metre to lift the top of a vertical leg that carries `v` there.
fn lift_stiffness(line: &PlanarLine, v: f64) -> f64 {
    line.w / (1.0 + v / line.ea)
}

/// Residual height of a vertical leg, as force over its weight.
fn straight_error(line: &PlanarLine, length: f64, height: f64) -> f64 {
    if length <= 0.0 {
        return 0.0;
    }
    let (_, dz) = line.span(length).reach(0.0, 0.0);
    let v = line.w * length;
    (dz - height).abs() * lift_stiffness(line, v) / v
}

/// Slack on the bed, the rest suspended vertically from B.
pub(super) fn slack_contact(
    touchdown: &TouchdownLine,
    straight: f64,
) -> Result<Solution, CatenaryError> {
    let line = &touchdown.line;
    let v = line.w * straight;
    let on_bed = line.length - straight;
    let foot = (line.x, line.x * touchdown.slope.tan);
    let found = Candidate {
        ends: [(0.0, 0.0), (0.0, v)],
        on_bed,
        shape: CatenaryShape::SlackOnBed,
        iterations: 0,
        residual: straight_error(line, straight, touchdown.height),
        stiffness: [[0.0, 0.0], [0.0, lift_stiffness(line, v)]],
        seed: StartingUnknown::None,
    };
    let heap = ProfilePiece {
        length: on_bed,
        kind: PieceLaw::Slack {
            x: foot.0,
            z: foot.1,
        },
        ..ProfilePiece::default()
    };
    let pieces = [heap, line.suspended_piece(on_bed, straight, foot, 0.0, 0.0)];
    found.verified(line.frame, Pieces::few(&pieces))
}

/// Suspended from A, grounded in the middle, suspended to B.
pub(super) fn grounded_span(
    grounded: &GroundedSpan,
    forces: &GroundedForces,
) -> Result<Solution, CatenaryError> {
    let line = &grounded.line;
    let (v_a, v_b) = (forces.legs[0].v, forces.legs[1].v);
    let (s_a, s_b) = (v_a / line.w, v_b / line.w);
    let on_bed = line.length - s_a - s_b;
    let slack = forces.h <= 0.0;
    let (residual, stiffness) = if slack {
        let error = straight_error(line, s_a, grounded.rise[0]).max(straight_error(
            line,
            s_b,
            grounded.rise[1],
        ));
        (error, [[0.0, 0.0], [0.0, lift_stiffness(line, v_b)]])
    } else {
        grounded.verify(forces)
    };
    let found = Candidate {
        ends: [(forces.h, -v_a), (forces.h, v_b)],
        on_bed,
        shape: if slack {
            CatenaryShape::SlackTroughOnBed
        } else {
            CatenaryShape::TroughOnBed
        },
        iterations: forces.iterations,
        residual,
        stiffness,
        seed: if slack {
            StartingUnknown::None
        } else {
            StartingUnknown::GroundedSpan(forces.h)
        },
    };
    found.verified(
        line.frame,
        Pieces::few(&grounded_span_pieces(grounded, forces)),
    )
}

fn grounded_span_pieces(grounded: &GroundedSpan, forces: &GroundedForces) -> [ProfilePiece; 3] {
    let line = &grounded.line;
    let h = forces.h;
    let [(s_a, depth), (s_b, _)] = [0, 1].map(|i| (forces.legs[i].v / line.w, grounded.rise[i]));
    let reach = |s: f64| line.span(s).reach(h, 0.0).0;
    let down = (reach(s_a), -depth);
    let up = (line.x - reach(s_b), -depth);
    let on_bed = line.length - s_a - s_b;
    let kind = if h > 0.0 {
        PieceLaw::Grounded {
            end: h,
            loss: 0.0,
            cos: 1.0,
            sin: 0.0,
            ea: line.ea,
        }
    } else {
        PieceLaw::Slack { x: up.0, z: up.1 }
    };
    let middle = ProfilePiece {
        from: s_a,
        length: on_bed,
        x: down.0,
        z: down.1,
        kind,
    };
    [
        line.suspended_piece(0.0, s_a, (0.0, 0.0), h, -forces.legs[0].v),
        middle,
        line.suspended_piece(s_a + on_bed, s_b, up, h, 0.0),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statics::catenary::solution::LocalFrame;

    #[test]
    fn a_vertical_leg_that_misses_its_height_is_wrong_by_the_force_to_lift_it() {
        let (w, ea, length) = (0.5, 2e4, 100.0);
        let line = PlanarLine {
            x: 0.0,
            z: 0.0,
            length,
            w,
            ea,
            bed: None,
            frame: LocalFrame {
                along: 1.0,
                up: 1.0,
            },
        };
        let height = length + 0.5 * w * length * length / ea;
        assert!(straight_error(&line, length, height) < 1e-15);
        let miss = 1e-3;
        // The top of a longer leg carries what the leg weighs: `d(wL)/dz` over the weight.
        let expected = miss / (length * (1.0 + w * length / ea));
        let found = straight_error(&line, length, height + miss);
        assert!((found - expected).abs() < 1e-9 * expected, "{found}");
        assert_eq!(straight_error(&line, 0.0, 1.0), 0.0);
    }
}
