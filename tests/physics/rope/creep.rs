//! The law of ropes that creep: the standard linear solid, its limits, energy, and random ropes.

use proptest::prelude::*;
use seacable::physics::rope::creep::CreepState;
use seacable::physics::rope::working_curve::{CurveEnd, CurveShape, MeanCurve, WorkingCurve};
use seacable::physics::rope::{CreepingRope, TensionTable};

const EA: f64 = 1.4e8;
const DYNAMIC: f64 = 4.2e8;
const SLOW: f64 = 4e9;

/// A standard linear solid with this fast damper.
fn solid(fast: f64) -> CreepingRope {
    CreepingRope {
        curve: MeanCurve::Linear(EA),
        dynamic: DYNAMIC,
        per_tension: 0.0,
        slow: SLOW,
        fast,
        peak: 0.0,
        bound: 1e7,
        initial_mean: None,
    }
}

/// A Syrope rope of this shape that was loaded to a mean strain of 0.02.
fn syrope(shape: CurveShape) -> CreepingRope {
    let strain: Vec<f64> = (0..25).map(|i| f64::from(i) * 2.5e-3).collect();
    let tension: Vec<f64> = strain.iter().map(|e| 6e7 * e + 2.5e8 * e * e).collect();
    let table = TensionTable::new(&strain, &tension).unwrap();
    let end = CurveEnd::Ratio(0.3);
    CreepingRope {
        curve: MeanCurve::Syrope(table, WorkingCurve { shape, end }),
        dynamic: 1.6e8,
        per_tension: 23.0,
        slow: 5e10,
        fast: 1e8,
        peak: 0.02,
        bound: 4e6,
        initial_mean: None,
    }
}

/// All kinds of ropes.
fn ropes() -> Vec<CreepingRope> {
    let table = TensionTable::new(&[0.0, 0.02, 0.05], &[0.0, 2e6, 6e6]).unwrap();
    vec![
        solid(0.0),
        solid(3e8),
        CreepingRope {
            per_tension: 8.0,
            ..solid(1e8)
        },
        CreepingRope {
            curve: MeanCurve::Table(table),
            per_tension: 5.0,
            ..solid(1e7)
        },
        syrope(CurveShape::Linear),
        syrope(CurveShape::Quadratic(0.8)),
        syrope(CurveShape::Exponential(1.5)),
    ]
}

/// Marches through strains in steps, and returns what the rope remembers and its tension at the end.
fn marched(
    rope: &CreepingRope,
    start: CreepState,
    steps: u32,
    dt: f64,
    strain: impl Fn(f64) -> f64,
) -> (CreepState, f64) {
    let mut now = start;
    for step in 1..=steps {
        now = rope.after(strain(f64::from(step) * dt), &now, dt);
    }
    let end = f64::from(steps) * dt;
    let rate = (strain(end + 1e-6) - strain(end - 1e-6)) / 2e-6;
    (now, rope.tension(strain(end), rate, &now, 0.0).tension)
}

/// From rest at a strain b that grows as `r t` the mean strain is `b + r t - r (tau - c) (1 - exp(-t/tau))`, with
/// `tau = (S + F) w / K`, `c = F / K` and `w = 1 - EA/K`; where the strain then stays, the tension falls to `EA e` as `exp(-t/tau)`.
#[test]
fn ramp_and_relaxation_are_those_of_the_standard_linear_solid() {
    for fast in [0.0, 2e9] {
        let rope = solid(fast);
        let (w, rest, r, ramp) = (1.0 - EA / DYNAMIC, 0.05, 1e-3, 8.0);
        let (tau, c) = ((SLOW + fast) * w / DYNAMIC, fast / DYNAMIC);
        let top = rest + r * ramp;
        let lag = r * (tau - c) * (1.0 - (-ramp / tau).exp());
        let start = rope.begin(rest);
        let (now, _) = marched(&rope, start, 8000, 1e-3, |t| rest + r * t);
        assert!((now.mean - (top - lag)).abs() < 1e-7 * now.mean);
        for (steps, after) in [(2000, 2.0), (10000, 10.0), (60000, 60.0)] {
            let (later, tension) = marched(&rope, now, steps, 1e-3, |_| top);
            let left = lag * f64::exp(-after / tau);
            assert!((later.mean - (top - left)).abs() < 1e-7 * later.mean);
            let expected = EA * (top - left) + SLOW * w * left / tau;
            assert!(
                (tension / expected - 1.0).abs() < 1e-6,
                "{tension} {expected}"
            );
        }
        let (_, tension) = marched(&rope, now, 40000, 1e-2, |_| top);
        assert!((tension / (EA * top) - 1.0).abs() < 1e-9);
    }
}

/// Under a load that stays, the strain grows as `T/K + T/k (1 - exp(-k t/S))`, `1/k = 1/EA - 1/K`.
#[test]
fn creep_is_that_of_the_standard_linear_solid() {
    let rope = solid(0.0);
    let (load, dt) = (2e6, 0.01);
    let soft = 1.0 / (1.0 / EA - 1.0 / DYNAMIC);
    let mut now = CreepState {
        mean: 0.0,
        strain: load / DYNAMIC,
        peak: 0.0,
    };
    for step in 1..=5000 {
        // The strain of the next step by Newton: tension rises with it.
        let mut strain = now.strain;
        for _ in 0..20 {
            let found = rope.tension(strain, 0.0, &now, dt);
            strain -= (found.tension - load) / found.by_strain;
        }
        now = rope.after(strain, &now, dt);
        let t = f64::from(step) * dt;
        let expected = load / DYNAMIC + load / soft * (1.0 - (-soft * t / SLOW).exp());
        assert!(
            (strain / expected - 1.0).abs() < 1e-6,
            "{t} {strain} {expected}"
        );
    }
}

/// An amplitude of the tension by that of the strain: the static stiffness at a motion much slower than the creep, the dynamic one at a
/// motion much faster.
#[test]
fn slow_motion_meets_the_static_and_fast_motion_the_dynamic_stiffness() {
    for rope in [
        solid(0.0),
        CreepingRope {
            per_tension: 20.0,
            ..solid(0.0)
        },
        syrope(CurveShape::Linear),
    ] {
        let middle = rope.strain_at(9e5);
        let point = rope.curve.at(middle, rope.peak);
        let dynamic = rope.dynamic_stiffness(point.tension);
        for (period, expected, bound) in [(2e6, point.by_strain, 1e-3), (0.1, dynamic, 1e-3)] {
            let amplitude = 1e-4;
            let (omega, dt) = (std::f64::consts::TAU / period, period / 400.0);
            let strain = |t: f64| middle + amplitude * (omega * t).sin();
            let mut now = rope.begin(middle);
            let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
            for step in 1..=800 {
                let t = f64::from(step) * dt;
                now = rope.after(strain(t), &now, dt);
                let rate = amplitude * omega * (omega * t).cos();
                let tension = rope
                    .tension(strain(t), if period > 1.0 { rate } else { 0.0 }, &now, 0.0)
                    .tension;
                if step > 400 {
                    (least, most) = (least.min(tension), most.max(tension));
                }
            }
            let met = (most - least) / (2.0 * amplitude);
            let expected = match period > 1.0 {
                true => expected,
                false => expected * rope.slow / (rope.slow + rope.fast),
            };
            assert!(
                (met / expected - 1.0).abs()
                    < bound + 0.01 * f64::from(u8::from(rope.per_tension > 0.0)),
                "{period} {met} {expected}"
            );
        }
    }
}

/// The mean strain of a Syrope rope on its working curve by an equation of its own, `(S + F) w x' = K (e - x) + F e'` with
/// `w = 1 - T_m'(x) / K`, which the classical Runge-Kutta method solves in this many steps from rest.
fn syrope_equation(
    mean: impl Fn(f64) -> (f64, f64),
    strain: impl Fn(f64) -> (f64, f64),
    (duration, steps): (f64, u32),
) -> f64 {
    let rate = |t: f64, x: f64| {
        let ((tension, slope), (e, de)) = (mean(x), strain(t));
        let fast = 1.6e8 + 23.0 * tension;
        (fast * (e - x) + 1e8 * de) / ((5e10 + 1e8) * (1.0 - slope / fast))
    };
    let (mut x, h) = (strain(0.0).0, duration / f64::from(steps));
    for step in 0..steps {
        let t = f64::from(step) * h;
        let k1 = rate(t, x);
        let k2 = rate(t + 0.5 * h, x + 0.5 * h * k1);
        let k3 = rate(t + 0.5 * h, x + 0.5 * h * k2);
        let k4 = rate(t + h, x + h * k3);
        x += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    x
}

/// Mean strains of Syrope ropes against their equation, whose own error is below 1e-10 by steps half as long.
#[test]
fn a_syrope_rope_follows_its_equation() {
    // The tension and its slope by the mean strain on the working curves from 0.006 to the greatest past strain of 0.02.
    let (peak, greatest, width) = (0.02, 1.3e6, 0.7 * 0.02);
    let place = |x: f64| (x - (peak - width)) / width;
    type Curve = fn(f64) -> (f64, f64);
    let shapes: [(CurveShape, Curve); 3] = [
        (CurveShape::Linear, |s| (s, 1.0)),
        (CurveShape::Quadratic(0.8), |s| {
            (0.8 * s * s + 0.2 * s, 1.6 * s + 0.2)
        }),
        (CurveShape::Exponential(1.5), |s| {
            let whole = 1.5_f64.exp() - 1.0;
            (
                ((1.5 * s).exp() - 1.0) / whole,
                1.5 * (1.5 * s).exp() / whole,
            )
        }),
    ];
    let strain = |t: f64| 0.013 + 0.001 * (0.05 * t).sin();
    let strain_and_rate = |t: f64| (strain(t), 0.001 * 0.05 * (0.05 * t).cos());
    for (shape, curve) in shapes {
        let mean = |x: f64| {
            let (value, slope) = curve(place(x));
            (greatest * value, greatest * slope / width)
        };
        let rope = syrope(shape);
        for duration in [20.0, 100.0, 400.0] {
            let own = |steps| syrope_equation(mean, strain_and_rate, (duration, steps));
            let (expected, coarse) = (own(40_000), own(20_000));
            assert!(
                (coarse / expected - 1.0).abs() < 1e-10,
                "{coarse} {expected}"
            );
            let steps = 40_000;
            let dt = duration / f64::from(steps);
            let (now, tension) = marched(&rope, rope.begin(strain(0.0)), steps, dt, strain);
            let off = now.mean / expected - 1.0;
            assert!(off.abs() < 1e-6, "{shape:?} {duration}: {off:e}");
            // The tension that the parts in series share.
            let ((level, _), (e, de)) = (mean(expected), strain_and_rate(duration));
            let fast = 1.6e8 + 23.0 * level;
            let slow_rate = (fast * (e - expected) + 1e8 * de) / (5e10 + 1e8);
            let shared = level + 5e10 * slow_rate;
            assert!((tension / shared - 1.0).abs() < 1e-6, "{tension} {shared}");
        }
    }
}

/// The midpoint rule is of second order, also with both dampers and a table.
#[test]
fn the_mean_strain_is_of_second_order() {
    for rope in ropes() {
        let strain = |t: f64| 0.012 + 0.004 * (0.3 * t).sin() + 2e-4 * t;
        let start = rope.begin(strain(0.0));
        let end = |steps: u32| {
            marched(&rope, start, steps, 20.0 / f64::from(steps), strain)
                .0
                .mean
        };
        let exact = end(1 << 15);
        let errors = [64, 128, 256].map(|steps| (end(steps) - exact).abs());
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!((order - 2.0).abs() < 0.25, "{rope:?} {errors:?}");
        }
    }
}

/// Work done on the rope is stored or lost, and none is lost twice: the loss is what both dampers and, on its original curve, a rope
/// that yields take.
#[test]
fn work_is_stored_or_lost() {
    for rope in ropes() {
        let strain = |t: f64| 0.015 + 0.009 * (0.8 * t).sin();
        let rate = |t: f64| 0.0072 * (0.8 * t).cos();
        let (steps, dt) = (40_000, 1e-3);
        let mut now = rope.begin(strain(0.0));
        let powers = |t: f64, now: &CreepState| {
            let tension = rope.tension(strain(t), rate(t), now, 0.0).tension;
            let energy = rope.energy(strain(t), now);
            let mean = rope.mean_rate(strain(t), rate(t), now);
            (
                tension * rate(t),
                (tension - energy.elastic) * rate(t) + energy.lost_by_mean * mean,
            )
        };
        let first = rope.energy(strain(0.0), &now).stored;
        let (mut work, mut lost, mut before) = (0.0, 0.0, powers(0.0, &now));
        for step in 1..=steps {
            let t = f64::from(step) * dt;
            now = rope.after(strain(t), &now, dt);
            let here = powers(t, &now);
            assert!(
                here.1 > -1e-9 * here.0.abs() - 1.0 || rope.per_tension > 0.0,
                "{rope:?} {t} {here:?}"
            );
            work += 0.5 * dt * (before.0 + here.0);
            lost += 0.5 * dt * (before.1 + here.1);
            before = here;
        }
        let stored = rope.energy(strain(f64::from(steps) * dt), &now).stored - first;
        let off = work - lost - stored;
        assert!(
            off.abs() < 1e-4 * (lost.abs() + first.abs()),
            "{rope:?} {work} {lost} {stored}"
        );
        assert!(lost > 0.0);
    }
}

/// The derivative by strain within a step, with that of the mean strain, is the difference of tensions.
#[test]
fn the_tangent_within_a_step_is_exact() {
    for rope in ropes() {
        for (from, to, rate, dt) in [
            (0.012, 0.0125, 0.1, 0.05),
            (0.02, 0.019, -0.3, 0.5),
            (0.01, 0.03, 0.4, 2.0),
            (0.02, 0.021, 0.02, 30.0),
        ] {
            let before = rope.begin(from);
            let at = |e: f64, r: f64| rope.tension(e, r, &before, dt).tension;
            let found = rope.tension(to, rate, &before, dt);
            let h = 1e-7;
            let by_strain = (at(to + h, rate) - at(to - h, rate)) / (2.0 * h);
            let by_rate = (at(to, rate + h) - at(to, rate - h)) / (2.0 * h);
            assert!(
                (found.by_strain - by_strain).abs() < 1e-5 * 4e8,
                "{rope:?} {found:?} {by_strain}"
            );
            assert!(
                (found.by_rate - by_rate).abs() < 1e-5 * 4e9,
                "{rope:?} {found:?} {by_rate}"
            );
        }
    }
}

/// A rope that was stretched beyond all past is longer by its permanent strain once it has recovered.
#[test]
fn a_slack_rope_recovers_to_its_permanent_strain() {
    let rope = syrope(CurveShape::Quadratic(0.5));
    let start = rope.begin(rope.strain_at(5e5));
    let (loaded, _) = marched(&rope, start, 4000, 1.0, |t| 0.04 * (t / 1000.0).min(1.0));
    assert!((loaded.peak - 0.04).abs() < 1e-6);
    let (slack, tension) = marched(&rope, loaded, 20_000, 1.0, |_| 0.0);
    assert_eq!(tension, 0.0);
    assert!((slack.mean - 0.3 * loaded.peak).abs() < 1e-6, "{slack:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    #[test]
    fn no_rope_and_no_motion_gives_what_is_not_a_number(
        (curve, k, ratio) in (0usize..6, -50.0f64..50.0, 0.0f64..0.99),
        (dynamic, growth) in (1.0f64..11.0, 0.0f64..1e3),
        (slow, fast) in (-3.0f64..14.0, -3.0f64..12.0),
        (strain, tension) in (1e-4f64..10.0, 1.0f64..1e10),
        past in 0.0f64..2.0,
        path in proptest::collection::vec((-0.5f64..2.0, -4.0f64..4.0), 1..30),
    ) {
        let table = TensionTable::new(&[0.0, strain, 2.5 * strain], &[0.0, tension, 1.1 * tension]).unwrap();
        let working = |shape, end| MeanCurve::Syrope(table.clone(), WorkingCurve { shape, end });
        let curve = match curve {
            0 => MeanCurve::Linear(tension / strain),
            1 => MeanCurve::Table(table.clone()),
            2 => working(CurveShape::Linear, CurveEnd::Stiffness(tension)),
            3 => working(CurveShape::Quadratic(k), CurveEnd::Ratio(ratio)),
            4 => working(CurveShape::Exponential(k), CurveEnd::Ratio(ratio)),
            _ => working(CurveShape::Exponential(k), CurveEnd::Stiffness(tension / strain)),
        };
        let rope = CreepingRope {
            peak: past * strain,
            curve,
            dynamic: 10f64.powf(dynamic),
            per_tension: growth,
            slow: 10f64.powf(slow),
            fast: 10f64.powf(fast),
            bound: tension,
            initial_mean: None,
        };
        let rest = rope.at_rest(0.5 * strain);
        prop_assert!(rest.tension.is_finite() && rest.by_strain.is_finite());
        let mut now = rope.begin(path[0].0 * strain);
        for (e, log_dt) in path {
            let dt = 10f64.powf(log_dt);
            let e = e * strain;
            let found = rope.tension(e, (e - now.strain) / dt, &now, dt);
            let energy = rope.energy(e, &now);
            now = rope.after(e, &now, dt);
            let numbers = [found.tension, found.by_strain, found.by_rate, energy.stored, energy.lost_by_mean, now.mean, now.peak];
            prop_assert!(numbers.iter().all(|v| v.is_finite()), "{:?} {:?}", rope, numbers);
            prop_assert!(found.tension >= 0.0 && now.mean >= rope.curve.slack(now.peak) - 1e-12 * strain);
            prop_assert!(rope.mean_rate(e, 0.0, &now).is_finite());
        }
    }
}
