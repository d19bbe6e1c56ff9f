//! Points that are hauled along a line: a moving mass on a taut string, balances, order of convergence, refusals.

use std::f64::consts::PI;

use seacable::system::motion::run::MotionRun;

use crate::motion::{channel, moved, refused};

const GRAVITY: f64 = 9.81;
const SPAN: f64 = 100.0;
const MASS: f64 = 10.0;
/// String that is drawn by a tenth: its tension hardly changes under the mass.
const EA: f64 = 1e5;
const STRING: f64 = 1e-3;
const LENGTH: f64 = SPAN / 1.1;

/// A mass on a string between two points at one height, at first at a share of it, hauled along.
fn hauled(share: f64, string: (f64, f64), haul: &str, solver: &str) -> MotionRun {
    let (mass, damping) = string;
    let line = |name: &str, from: &str, to: &str, share: f64| {
        let (length, segments) = (share * LENGTH, (40.0 * share).round());
        format!(
            "[[lines]]\nname = \"{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"string\"\nlength_m = {length:?}\nsegments = {segments}\n"
        )
    };
    moved(&format!(
        "[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = {GRAVITY}\n\
         [materials.string]\nmass_kg_per_m = {mass:?}\ndiameter_m = 0.01\nea_n = {EA:?}\naxial_damping_n_s = {damping:?}\n\
         [points.left]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n\
         [points.right]\nkind = \"fixed\"\nposition_m = [{SPAN:?}, 0.0, 0.0]\n\
         [points.mass]\nkind = \"free\"\nmass_kg = {MASS:?}\n{}{}\
         [[sliding_points]]\npoint = \"mass\"\nline = \"one\"\nother = \"two\"\n{haul}\n\
         [solver]\nposition_tolerance_m = 1e-10\nerror_estimate = false\n{solver}",
        line("one", "left", "mass", share),
        line("two", "mass", "right", 1.0 - share),
    ))
}

/// Sag of a string under its own weight and a weight at x, of small slope.
fn sag(x: f64, weight: f64) -> f64 {
    let tension = EA * (SPAN / LENGTH - 1.0);
    let own = STRING * LENGTH / SPAN * GRAVITY;
    x * (SPAN - x) * (weight / SPAN + 0.5 * own) / tension
}

#[test]
fn a_mass_hauled_slowly_goes_along_the_parabola() {
    let haul = "rate_m_per_s = 0.5\nstart_s = 2.0\nramp_s = 6.0";
    let solver = "duration_s = 120.0\n[output]\ninterval_s = 1.0\n";
    let run = hauled(0.2, (STRING, 2e3), haul, solver);
    let (x, z) = (channel(&run, "x_m[mass]"), channel(&run, "z_m[mass]"));
    for (x, z) in x.iter().zip(z) {
        let closed = sag(*x, MASS * GRAVITY);
        assert!((-z / closed - 1.0).abs() < 5e-3, "{x}: {z} {closed}");
    }
    let [one, two] = ["length_m[one]", "length_m[two]"].map(|name| channel(&run, name));
    for (k, time) in run.history.time.iter().enumerate() {
        assert!((one[k] + two[k] - LENGTH).abs() < 1e-9, "{time}");
    }
    // By the rate, less half of its ramp.
    let way = one[one.len() - 1] - one[0];
    assert!((way - 0.5 * (118.0 - 3.0)).abs() < 1e-9, "{way}");
    assert!(run.balance.relative_drift() < 2e-3, "{:?}", run.balance);
}

/// A string without mass is two springs beside the mass, of the lengths that are prescribed: `m x'' = T2 e2 - T1 e1 - m g`.
#[test]
fn a_mass_hauled_fast_goes_along_the_path_of_a_mass_between_two_springs() {
    let (rate, ramp, damping) = (15.0, 1.5, 500.0);
    let haul = format!("rate_m_per_s = {rate:?}\nramp_s = {ramp:?}");
    let solver = "duration_s = 4.5\ntime_step_s = 0.0025\n[output]\ninterval_s = 0.05\n";
    let run = hauled(0.2, (1e-4, damping), &haul, solver);
    let (x, z) = (channel(&run, "x_m[mass]"), channel(&run, "z_m[mass]"));
    // Length of the first string, and its rate.
    let first = |t: f64| {
        let turn = PI * t / ramp;
        let (out, share) = match t < ramp {
            true => (0.5 * (t - ramp / PI * turn.sin()), 0.5 * (1.0 - turn.cos())),
            false => (t - 0.5 * ramp, 1.0),
        };
        (0.2 * LENGTH + rate * out, rate * share)
    };
    let pull = |[dx, dz, wx, wz]: [f64; 4], (l, q): (f64, f64)| {
        let r = dx.hypot(dz);
        let opening = (dx * wx + dz * wz) / r;
        let tension = EA * (r / l - 1.0) + damping * (opening - r / l * q) / l;
        [tension * dx / r, tension * dz / r]
    };
    let f = |t: f64, [x, z, wx, wz]: [f64; 4]| {
        let (l, q) = first(t);
        let left = pull([-x, -z, -wx, -wz], (l, q));
        let right = pull([SPAN - x, -z, -wx, -wz], (LENGTH - l, -q));
        [
            wx,
            wz,
            (left[0] + right[0]) / MASS,
            (left[1] + right[1]) / MASS - GRAVITY,
        ]
    };
    let add = |s: [f64; 4], d: [f64; 4], h: f64| std::array::from_fn(|i| s[i] + h * d[i]);
    let (mut at, h) = ([x[0], z[0], 0.0, 0.0], 5e-4);
    let mut worst = 0.0_f64;
    for (k, time) in run.history.time.iter().enumerate() {
        worst = worst.max((z[k] - at[1]).abs()).max((x[k] - at[0]).abs());
        for step in 0..100 {
            let t = time + f64::from(step) * h;
            let k1 = f(t, at);
            let k2 = f(t + 0.5 * h, add(at, k1, 0.5 * h));
            let k3 = f(t + 0.5 * h, add(at, k2, 0.5 * h));
            let k4 = f(t + h, add(at, k3, h));
            at = std::array::from_fn(|i| {
                at[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i])
            });
        }
    }
    let deepest = z.iter().copied().fold(0.0, f64::min);
    assert!(worst < 5e-3 * deepest.abs(), "{worst} {deepest}");
    assert!(run.balance.relative_drift() < 2e-3, "{:?}", run.balance);
}

#[test]
fn a_table_hauls_to_and_fro() {
    let times: Vec<f64> = (0..=40).map(f64::from).collect();
    let ways: Vec<f64> = times
        .iter()
        .map(|t| 10.0 * (1.0 - (PI * t / 20.0).cos()))
        .collect();
    let haul = format!("table_time_s = {times:?}\ntable_m = {ways:?}");
    let solver = "duration_s = 40.0\n[output]\ninterval_s = 1.0\n";
    let run = hauled(0.2, (STRING, 2e3), &haul, solver);
    let (x, length) = (channel(&run, "x_m[mass]"), channel(&run, "length_m[one]"));
    assert!((length[20] - length[0] - 20.0).abs() < 1e-9);
    assert!((x[20] - x[0] - 22.0).abs() < 0.05, "{}", x[20] - x[0]);
    assert!((x[40] - x[0]).abs() < 1e-2, "{}", x[40] - x[0]);
    assert!((channel(&run, "z_m[mass]")[40] / channel(&run, "z_m[mass]")[0] - 1.0).abs() < 5e-3);
}

/// A string with a mass of its own.
fn heavy(rate: f64, solver: &str) -> MotionRun {
    let haul = format!("rate_m_per_s = {rate:?}\nramp_s = 1.0");
    hauled(0.3, (0.5, 2e3), &haul, solver)
}

#[test]
fn hauling_is_of_second_order_in_time() {
    let at_end = |step: f64| {
        // Less than a segment passes: the mesh stays.
        let run = heavy(1.0, &format!("duration_s = 1.6\ntime_step_s = {step:?}\n"));
        let last = |name: &str| *channel(&run, name).last().unwrap();
        let tension = 1e-4 * last("tension_n[one|b]");
        nalgebra::Vector3::new(last("x_m[mass]"), last("z_m[mass]"), tension)
    };
    let [one, two, four] = [1.25e-3, 6.25e-4, 3.125e-4].map(at_end);
    let ratio = (one - two).norm() / (two - four).norm();
    assert!((3.2..5.0).contains(&ratio), "{ratio}");
}

#[test]
fn both_methods_haul_alike() {
    let [alpha, rk4] = [("alpha", 1e-3), ("rk4", 5e-4)].map(|(method, step)| {
        let solver = format!("method = \"{method}\"\nduration_s = 5.0\ntime_step_s = {step:?}\n");
        heavy(2.0, &solver)
    });
    for name in [
        "x_m[mass]",
        "z_m[mass]",
        "tension_n[one|a]",
        "tension_n[two|b]",
    ] {
        let pairs = channel(&alpha, name).iter().zip(channel(&rk4, name));
        for (one, other) in pairs {
            assert!((one / other - 1.0).abs() < 2e-4, "{name}: {one} {other}");
        }
    }
}

#[test]
fn what_hauls_twice_or_to_no_effect_is_refused() {
    let base = "[materials.string]\nmass_kg_per_m = 1.0\ndiameter_m = 0.01\nea_n = 1e6\n\
        [points.left]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n\
        [points.right]\nkind = \"fixed\"\nposition_m = [90.0, 0.0, 0.0]\n\
        [points.mass]\nkind = \"free\"\nmass_kg = 10.0\n\
        [[lines]]\nname = \"one\"\nfrom = \"left\"\nto = \"mass\"\nmaterial = \"string\"\nlength_m = 50.0\n\
        [[lines]]\nname = \"two\"\nfrom = \"mass\"\nto = \"right\"\nmaterial = \"string\"\nlength_m = 50.0\n\
        [solver]\nduration_s = 10.0\n\
        [[sliding_points]]\npoint = \"mass\"\nline = \"one\"\nother = \"two\"\n";
    let table = "table_time_s = [0.0, 10.0]\ntable_m = [0.0, 5.0]\n";
    for (text, wanted) in [
        (
            &*format!("rate_m_per_s = 1.0\n{table}"),
            "both `rate_m_per_s` and `table_time_s`",
        ),
        (
            &*table.replace("[0.0, 5.0]", "[1.0, 5.0]"),
            "begins with 1 m",
        ),
        ("table_time_s = [0.0, 10.0]\n", "table_m"),
        (
            "table_time_s = [0.0, 5.0]\ntable_m = [0.0, 1.0]\n",
            "end of the run",
        ),
        (
            "rate_m_per_s = 1.0\nfriction = 0.1\n",
            "point that is hauled",
        ),
        (
            &*format!("{table}friction_n = 10.0\n"),
            "point that is hauled",
        ),
        ("start_s = 2.0\n", "no effect without `rate_m_per_s`"),
        (
            "rate_m_per_s = 1.0\nstart_s = 8.0\nstop_s = 2.0\n",
            "before the start",
        ),
    ] {
        let said = refused(&format!("{base}{text}"));
        assert!(said.contains(wanted), "{wanted}: {said}");
    }
}
