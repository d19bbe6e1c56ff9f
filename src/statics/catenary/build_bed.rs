//! As `build`, for lines that rest on the bed.

use super::build::{Found, ROUNDING, few, finish, hanging_piece};
use super::error::CatenaryError;
use super::incline::{Incline, State};
use super::single::Plane;
use super::solution::{Kind, Piece, Seed, Shape, Solution, lying_sum};
use super::span::{Span, length};
use super::trough::{Lying, Trough};

/// The line lying from A, then rising to B.
pub(super) fn partly(
    plane: &Plane,
    incline: &Incline,
    mut state: State,
    iterations: u32,
) -> Result<Solution, CatenaryError> {
    let look = |state: State| {
        let leg = incline.leg(state);
        let miss = incline.miss(state, &leg);
        let step = incline.step(&leg, -miss.0, -miss.1);
        let (dh, dv) = Incline::force_step(state, &leg, step);
        let top = length(state.h, incline.v_b(state, &leg));
        (leg, step, length(dh, dv) / top)
    };
    let (mut leg, step, mut residual) = look(state);
    let mended = State {
        h: state.h + step.0,
        beta: state.beta + step.1,
    };
    if residual > ROUNDING && mended.h > 0.0 && mended.beta > 0.0 {
        let better = look(mended);
        if better.2 < residual {
            (state, leg, residual) = (mended, better.0, better.2);
        }
    }
    residual += incline.blur(state, &leg) / length(state.h, incline.v_b(state, &leg));
    let on_bed = (plane.length - leg.s).max(0.0);
    let t0 = state.h / incline.cos;
    let t_a = incline.tension_a(t0, on_bed);
    let column = |x, z| Incline::force_step(state, &leg, incline.step(&leg, x, z));
    let (by_x, by_z) = (column(1.0, 0.0), column(0.0, 1.0));
    let found = Found {
        ends: [
            (t_a * incline.cos, t_a * incline.sin),
            (state.h, incline.v_b(state, &leg)),
        ],
        on_bed,
        shape: Shape::PartlyOnBed,
        iterations,
        residual,
        stiffness: [[by_x.0, by_z.0], [by_x.1, by_z.1]],
        seed: Seed::Leg(state.beta),
    };
    let lying = incline.lying_length(t0, on_bed);
    let lift_off = (lying * incline.cos, lying * incline.sin);
    let pieces = [
        lying_piece(incline, on_bed, t0),
        hanging_piece(
            plane,
            on_bed,
            leg.s,
            lift_off,
            state.h,
            state.h * incline.tan,
        ),
    ];
    finish(plane, &found, few(&pieces))
}

fn lying_piece(incline: &Incline, length: f64, end: f64) -> Piece {
    Piece {
        length,
        kind: Kind::Lying {
            end,
            loss: incline.loss(),
            cos: incline.cos,
            sin: incline.sin,
            ea: incline.ea,
        },
        ..Piece::default()
    }
}

/// The line lying all the way. Only the stiffness along the bed is given.
pub(super) fn wholly(
    plane: &Plane,
    incline: &Incline,
    t_b: f64,
) -> Result<Solution, CatenaryError> {
    let (sin, cos) = (incline.sin, incline.cos);
    let (length, loss) = (plane.length, incline.loss());
    let moving = if loss > 0.0 {
        length.min(t_b / loss)
    } else {
        length
    };
    let miss = -incline.spare() - lying_sum(t_b, loss, length) / plane.ea;
    let k = if moving > 0.0 { plane.ea / moving } else { 0.0 };
    let t_a = incline.tension_a(t_b, length);
    let blur = length * incline.longer();
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
    let found = Found {
        ends: [(t_a * cos, t_a * sin), (t_b * cos, t_b * sin)],
        on_bed: length,
        shape: Shape::WhollyOnBed,
        iterations: 0,
        residual,
        stiffness: [
            [k * cos * cos, k * cos * sin],
            [k * cos * sin, k * sin * sin],
        ],
        seed: Seed::None,
    };
    finish(plane, &found, few(&[lying_piece(incline, length, t_b)]))
}

/// The force per metre that lifts a straight hanging leg with `v` at its top.
fn lift_stiffness(plane: &Plane, v: f64) -> f64 {
    plane.w / (1.0 + v / plane.ea)
}

/// How far a leg hanging straight misses its height, as force over its weight.
fn straight_error(plane: &Plane, length: f64, height: f64) -> f64 {
    if length <= 0.0 {
        return 0.0;
    }
    let span = Span {
        length,
        weight: plane.w,
        ea: plane.ea,
    };
    let (_, dz) = span.reach(0.0, 0.0);
    let v = plane.w * length;
    (dz - height).abs() * lift_stiffness(plane, v) / v
}

/// More line than needed on the bed, the rest straight up to B.
pub(super) fn slack(
    plane: &Plane,
    incline: &Incline,
    straight: f64,
) -> Result<Solution, CatenaryError> {
    let v = plane.w * straight;
    let on_bed = plane.length - straight;
    let foot = (plane.x, plane.x * incline.tan);
    let found = Found {
        ends: [(0.0, 0.0), (0.0, v)],
        on_bed,
        shape: Shape::SlackOnBed,
        iterations: 0,
        residual: straight_error(plane, straight, incline.height),
        stiffness: [[0.0, 0.0], [0.0, lift_stiffness(plane, v)]],
        seed: Seed::None,
    };
    let heap = Piece {
        length: on_bed,
        kind: Kind::Heap {
            x: foot.0,
            z: foot.1,
        },
        ..Piece::default()
    };
    let pieces = [heap, hanging_piece(plane, on_bed, straight, foot, 0.0, 0.0)];
    finish(plane, &found, few(&pieces))
}

/// Down from A, along the bed, up to B.
pub(super) fn trough(
    plane: &Plane,
    trough: &Trough,
    lying: &Lying,
) -> Result<Solution, CatenaryError> {
    let (v_a, v_b) = (lying.legs[0].v, lying.legs[1].v);
    let (s_a, s_b) = (v_a / plane.w, v_b / plane.w);
    let on_bed = plane.length - s_a - s_b;
    let slack = lying.h <= 0.0;
    let (residual, stiffness) = if slack {
        let error = straight_error(plane, s_a, trough.rise[0]).max(straight_error(
            plane,
            s_b,
            trough.rise[1],
        ));
        (error, [[0.0, 0.0], [0.0, lift_stiffness(plane, v_b)]])
    } else {
        trough.verify(lying)
    };
    let found = Found {
        ends: [(lying.h, -v_a), (lying.h, v_b)],
        on_bed,
        shape: if slack {
            Shape::SlackTroughOnBed
        } else {
            Shape::TroughOnBed
        },
        iterations: lying.iterations,
        residual,
        stiffness,
        seed: if slack {
            Seed::None
        } else {
            Seed::Trough(lying.h)
        },
    };
    finish(plane, &found, few(&trough_pieces(plane, trough, lying)))
}

fn trough_pieces(plane: &Plane, trough: &Trough, lying: &Lying) -> [Piece; 3] {
    let h = lying.h;
    let [(s_a, depth), (s_b, _)] = [0, 1].map(|i| (lying.legs[i].v / plane.w, trough.rise[i]));
    let reach = |s: f64| {
        let span = Span {
            length: s,
            weight: plane.w,
            ea: plane.ea,
        };
        span.reach(h, 0.0).0
    };
    let down = (reach(s_a), -depth);
    let up = (plane.x - reach(s_b), -depth);
    let on_bed = plane.length - s_a - s_b;
    let kind = if h > 0.0 {
        Kind::Lying {
            end: h,
            loss: 0.0,
            cos: 1.0,
            sin: 0.0,
            ea: plane.ea,
        }
    } else {
        Kind::Heap { x: up.0, z: up.1 }
    };
    let middle = Piece {
        from: s_a,
        length: on_bed,
        x: down.0,
        z: down.1,
        kind,
    };
    [
        hanging_piece(plane, 0.0, s_a, (0.0, 0.0), h, -lying.legs[0].v),
        middle,
        hanging_piece(plane, s_a + on_bed, s_b, up, h, 0.0),
    ]
}
