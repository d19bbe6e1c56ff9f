//! Lines that are paid out, and points that slide along them: closed forms, balances, order of convergence, refusals.

use seacable::numerics::V3;
use seacable::system::SystemFile;
use seacable::system::motion::run::MotionRun;

use crate::motion::{channel, moved, refused};

const GRAVITY: f64 = 9.81;

const DRY: &str = "
[environment]
water_density_kg_per_m3 = 0.0
gravity_m_per_s2 = 9.81
";

fn wire(mass: f64, damping: f64) -> String {
    format!(
        "[materials.wire]\nmass_kg_per_m = {mass:?}\ndiameter_m = 0.02\nea_n = 6e7\naxial_damping_n_s = {damping:?}\n"
    )
}

fn fixed(name: &str, place: [f64; 3]) -> String {
    format!("[points.{name}]\nkind = \"fixed\"\nposition_m = {place:?}\n")
}

fn line(name: &str, from: &str, to: &str, length: f64, segments: usize) -> String {
    format!(
        "[[lines]]\nname = \"{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"wire\"\nlength_m = {length:?}\nsegments = {segments}\n"
    )
}

fn solver(duration: f64, step: Option<f64>, interval: f64) -> String {
    let step = step.map_or_else(String::new, |step| format!("time_step_s = {step:?}\n"));
    format!(
        "[solver]\nduration_s = {duration:?}\n{step}position_tolerance_m = 1e-10\nerror_estimate = false\n[output]\ninterval_s = {interval:?}\n"
    )
}

/// A mass on a wire from a winch at the origin, at an angle of its first position.
fn lowered(wire_mass: f64, aside: f64, end: &str, payout: &str, solver: &str) -> MotionRun {
    let (from, to) = if end == "a" {
        ("winch", "mass")
    } else {
        ("mass", "winch")
    };
    moved(&format!(
        "{DRY}{}{}[points.mass]\nkind = \"free\"\nmass_kg = 2000.0\nload_n = [{aside:?}, 0.0, 0.0]\n{}\
         [[payouts]]\nline = \"wire\"\nend = \"{end}\"\n{payout}\n{solver}",
        wire(wire_mass, 3e4),
        fixed("winch", [0.0, 0.0, 0.0]),
        line("wire", from, to, 20.0, 10),
    ))
}

#[test]
fn a_mass_paid_out_at_a_rate_hangs_as_its_wire_stretches() {
    let payout = "rate_m_per_s = 0.5\nstart_s = 1.0\nramp_s = 4.0";
    for end in ["a", "b"] {
        let run = lowered(10.0, 0.0, end, payout, &solver(60.0, None, 0.5));
        let (weight, wire, ea) = (2000.0 * GRAVITY, 10.0 * GRAVITY, 6e7);
        let z = channel(&run, "z_m[mass]");
        let lengths = channel(&run, "length_m[wire]");
        let at_winch = channel(&run, &format!("tension_n[wire|{end}]"));
        for (k, time) in run.history.time.iter().enumerate() {
            // Paid out by the ramp less half of it.
            let out = (time - 3.0) * 0.5;
            if *time < 12.0 {
                continue;
            }
            let length = 20.0 + out;
            assert!((lengths[k] / length - 1.0).abs() < 1e-12, "{time}");
            let stretch = (weight * length + 0.5 * wire * length * length) / ea;
            assert!(
                (z[k] + length + stretch).abs() < 2e-6,
                "{time}: {}",
                z[k] + length + stretch
            );
            let pull = weight + wire * length;
            assert!(
                (at_winch[k] / pull - 1.0).abs() < 5e-5,
                "{time}: {} {pull}",
                at_winch[k]
            );
        }
        assert!(run.balance.relative_drift() < 1e-5, "{:?}", run.balance);
    }
}

#[test]
fn what_is_paid_out_and_hauled_in_again_is_as_it_was() {
    // 8 m out and 8 m in, over several segments of 2 m each.
    let rows = 0..=60;
    let out = |k: i32| 4.0 * (1.0 - (f64::from(k.min(40)) / 20.0 * std::f64::consts::PI).cos());
    let times: Vec<f64> = rows.clone().map(f64::from).collect();
    let lengths: Vec<f64> = rows.map(out).collect();
    let payout = format!("table_time_s = {times:?}\ntable_m = {lengths:?}");
    let run = lowered(10.0, 0.0, "a", &payout, &solver(60.0, None, 0.5));
    let (z, pull) = (
        channel(&run, "z_m[mass]"),
        channel(&run, "tension_n[wire|a]"),
    );
    let last = z.len() - 1;
    assert!((z[last] - z[0]).abs() < 1e-5, "{}", z[last] - z[0]);
    assert!((pull[last] / pull[0] - 1.0).abs() < 1e-4);
    assert!(run.balance.relative_drift() < 1e-4, "{:?}", run.balance);
}

/// Bessel functions of order 1 and 2 of both kinds by Hankel's expansion, for great x (Abramowitz and Stegun 9.2.5, 9.2.6).
fn bessel(order: f64, x: f64) -> [f64; 2] {
    let mu = 4.0 * order * order;
    let (mut p, mut q, mut term) = (0.0, 0.0, 1.0);
    for k in 0..20 {
        match k % 4 {
            0 => p += term,
            1 => q += term,
            2 => p -= term,
            _ => q -= term,
        }
        let odd = f64::from(2 * k + 1);
        term *= (mu - odd * odd) / (f64::from(k + 1) * 8.0 * x);
    }
    let chi = x - (0.5 * order + 0.25) * std::f64::consts::PI;
    let size = (2.0 / (std::f64::consts::PI * x)).sqrt();
    [
        size * (p * chi.cos() - q * chi.sin()),
        size * (p * chi.sin() + q * chi.cos()),
    ]
}

#[test]
fn a_pendulum_on_a_wire_that_is_paid_out_swings_by_bessel_functions() {
    // Released from a steady side load by the end of it: the load is taken as the start of the swing.
    let rate = 0.5;
    let text = format!(
        "{DRY}{}{}[points.mass]\nkind = \"free\"\nmass_kg = 2000.0\n\
         [points.aside]\nkind = \"fixed\"\nposition_m = [30.0, 0.0, -19.0]\n{}{}\
         release_b_s = 0.0\n\
         [[payouts]]\nline = \"wire\"\nrate_m_per_s = {rate}\nramp_s = 0.2\n{}",
        wire(1e-2, 1e4),
        fixed("winch", [0.0, 0.0, 0.0]),
        line("wire", "winch", "mass", 20.0, 10),
        line("stay", "aside", "mass", 29.8, 2),
        solver(60.0, Some(0.01), 0.25),
    );
    let run = moved(&text);
    let (x, z) = (channel(&run, "x_m[mass]"), channel(&run, "z_m[mass]"));
    let angle = |k: usize| x[k].atan2(-z[k]);
    let length = |time: f64| 20.0 * (1.0 + 2000.0 * GRAVITY / 6e7) + rate * (time - 0.1);
    // theta = (A J1(s) + B Y1(s)) / s with s = 2 sqrt(g L) / rate: d theta / ds = -(A J2(s) + B Y2(s)) / s.
    let s = |time: f64| 2.0 * (GRAVITY * length(time)).sqrt() / rate;
    let from = 8;
    let (t0, h) = (run.history.time[from], 0.25);
    let slope = (angle(from - 2) - 8.0 * angle(from - 1) + 8.0 * angle(from + 1) - angle(from + 2))
        / (12.0 * h);
    let ([j1, y1], [j2, y2]) = (bessel(1.0, s(t0)), bessel(2.0, s(t0)));
    let rate_of_s = GRAVITY / (GRAVITY * length(t0)).sqrt();
    let (value, turned) = (angle(from) * s(t0), -slope / rate_of_s * s(t0));
    let wronskian = j1 * y2 - j2 * y1;
    let (a, b) = (
        (value * y2 - turned * y1) / wronskian,
        (j1 * turned - j2 * value) / wronskian,
    );
    let swing = (0..x.len()).map(|k| angle(k).abs()).fold(0.0, f64::max);
    assert!(swing > 0.01 && swing < 0.05, "{swing}");
    for (k, time) in run.history.time.iter().enumerate().skip(from) {
        let [j, y] = bessel(1.0, s(*time));
        let expected = (a * j + b * y) / s(*time);
        assert!(
            (angle(k) - expected).abs() < 5e-3 * swing,
            "{time}: {} {expected}",
            angle(k)
        );
    }
}

#[test]
fn a_line_that_is_paid_out_is_of_second_order_in_time() {
    // At the winch, and at the mass, which what passes it accelerates.
    for end in ["a", "b"] {
        let at_end = |step: f64| {
            let run = moved(&format!(
                "{DRY}{}{}[points.mass]\nkind = \"free\"\nmass_kg = 2000.0\nload_n = [3000.0, 0.0, 0.0]\n{}\
                 [[payouts]]\nline = \"wire\"\nend = \"{end}\"\nrate_m_per_s = 0.6\nramp_s = 2.0\n{}",
                wire(10.0, 3e4),
                fixed("winch", [0.0, 0.0, 0.0]),
                line("wire", "winch", "mass", 20.0, 10),
                solver(1.6, Some(step), 0.4),
            ));
            let last = |name: &str| *channel(&run, name).last().unwrap();
            V3::new(
                last("x_m[mass]"),
                last("z_m[mass]"),
                1e-6 * last("tension_n[wire|a]"),
            )
        };
        let [one, two, four] = [1.25e-3, 6.25e-4, 3.125e-4].map(at_end);
        let ratio = (one - two).norm() / (two - four).norm();
        assert!((3.2..5.0).contains(&ratio), "{end}: {ratio}");
    }
}

#[test]
fn both_methods_pay_out_alike() {
    let payout = "rate_m_per_s = 0.6\nramp_s = 1.0";
    let run = |method: &str, step: f64| {
        let solver = solver(8.0, Some(step), 0.5)
            .replace("[solver]\n", &format!("[solver]\nmethod = \"{method}\"\n"));
        lowered(10.0, 3000.0, "a", payout, &solver)
    };
    let (alpha, rk4) = (run("alpha", 5e-4), run("rk4", 2e-4));
    for name in ["z_m[mass]", "tension_n[wire|a]", "tension_n[wire|b]"] {
        let (one, other) = (channel(&alpha, name), channel(&rk4, name));
        for (one, other) in one.iter().zip(other) {
            assert!((one / other - 1.0).abs() < 2e-4, "{name}: {one} {other}");
        }
    }
}

/// A wire from a winch that heaves down to an anchor.
fn anchored(heave: f64, payout: &str, solver: &str) -> MotionRun {
    moved(&format!(
        "{DRY}{}[points.winch]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [0.0, 0.0, {heave:?}]\nperiod_s = 8.0\nramp_s = 8.0\n{}{}\
         [[payouts]]\nline = \"wire\"\n{payout}\n{solver}",
        wire(10.0, 3e4),
        fixed("anchor", [0.0, 0.0, -100.0]),
        line("wire", "winch", "anchor", 99.8, 20),
    ))
}

#[test]
fn a_winch_keeps_its_tension() {
    let mass = 50.0;
    let payout = format!("tension_n = 1.2e5\nramp_s = 5.0\ndrum_mass_kg = {mass:?}");
    let run = anchored(2.0, &payout, &solver(40.0, None, 0.1));
    let pull = channel(&run, "tension_n[wire|a]");
    let time = &run.history.time;
    // The inertia of the drum, which follows the heave, is half of that.
    for (pull, _) in pull.iter().zip(time).filter(|(_, time)| **time > 20.0) {
        assert!((pull - 1.2e5).abs() < 1e-3 * 1.2e5, "{pull}");
    }
    assert!(run.balance.relative_drift() < 1e-3, "{:?}", run.balance);
}

#[test]
fn a_winch_of_limited_speed_falls_behind() {
    let kept = "tension_n = 1.2e5\nramp_s = 5.0\ndrum_mass_kg = 50.0\ngreatest_rate_m_per_s = 1.0";
    let run = anchored(2.0, kept, &solver(40.0, None, 0.1));
    let lengths = channel(&run, "length_m[wire]");
    for pair in lengths.windows(2) {
        assert!((pair[1] - pair[0]).abs() < 0.1 * 1.1, "{pair:?}");
    }
    // Its end heaves at up to 1.57 m/s.
    let pull = channel(&run, "tension_n[wire|a]");
    assert!(pull.iter().copied().fold(0.0, f64::max) > 1.5e5);
}

#[test]
fn a_winch_gives_way_at_its_greatest_tension() {
    // Hauling in against an anchor.
    let payout =
        "rate_m_per_s = -0.05\ngreatest_tension_n = 2e5\nramp_s = 5.0\ndrum_mass_kg = 50.0";
    let run = anchored(0.0, payout, &solver(40.0, None, 0.1));
    let pull = channel(&run, "tension_n[wire|a]");
    let greatest = pull.iter().copied().fold(0.0, f64::max);
    assert!((1.9e5..2.02e5).contains(&greatest), "{greatest}");
}

#[test]
fn compensated_heave_does_not_reach_the_load() {
    let run = |payout: &str| {
        let text = format!(
            "{DRY}{}[points.winch]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [0.0, 0.0, 2.0]\nperiod_s = 8.0\nramp_s = 8.0\n\
             [points.mass]\nkind = \"free\"\nmass_kg = 2000.0\n{}{payout}{}",
            wire(10.0, 3e4),
            line("wire", "winch", "mass", 60.0, 20),
            solver(30.0, None, 0.1),
        );
        let z = channel(&moved(&text), "z_m[mass]").to_vec();
        let (least, most) = (
            z.iter().copied().fold(f64::MAX, f64::min),
            z.iter().copied().fold(f64::MIN, f64::max),
        );
        most - least
    };
    let without = run("");
    let with = run("[[payouts]]\nline = \"wire\"\nheave_compensation = 1.0\n");
    assert!(without > 3.9, "{without}");
    // Wire comes and goes at the top: what is left is its stretch by its own weight.
    assert!(with < 0.01, "{with}");
}

/// A bead on a wire between two points at one height, let go beside the middle.
fn bead(sliding: &str, solver: &str) -> MotionRun {
    moved(&format!(
        "{DRY}{}{}{}[points.bead]\nkind = \"free\"\nmass_kg = 100.0\nposition_m = [-4.0, 0.0, -6.0]\n{}{}\
         [[sliding_points]]\npoint = \"bead\"\nline = \"one\"\nother = \"two\"\n{sliding}\n{solver}",
        wire(0.02, 1e3),
        fixed("left", [-10.0, 0.0, 0.0]),
        fixed("right", [10.0, 0.0, 0.0]),
        line("one", "left", "bead", 9.0, 6),
        line("two", "bead", "right", 15.0, 10),
    ))
}

#[test]
fn a_bead_slides_on_an_ellipse() {
    let run = bead("ramp_s = 0.01", &solver(20.0, Some(0.005), 0.25));
    let (x, z) = (channel(&run, "x_m[bead]"), channel(&run, "z_m[bead]"));
    // Foci at the ends; on it x = a sin p, z = -b cos p: a pendulum by Lagrange's equation.
    let (a, focus) = (12.0_f64, 10.0_f64);
    let b = (a * a - focus * focus).sqrt();
    for (x, z) in x.iter().zip(z) {
        assert!(((x / a).powi(2) + (z / b).powi(2) - 1.0).abs() < 1e-3);
    }
    let rate = |[p, w]: [f64; 2]| {
        let (sin, cos) = p.sin_cos();
        let inertia = (a * cos).powi(2) + (b * sin).powi(2);
        let turning = (b * b - a * a) * sin * cos * w * w;
        [w, (-GRAVITY * b * sin - turning) / inertia]
    };
    let mut at = [(x[0] / a).asin(), 0.0];
    let (h, greatest) = (1e-3, x[0].abs());
    let mut worst = 0.0_f64;
    for (k, x) in x.iter().enumerate() {
        // Let go over a hundredth of a second.
        worst = worst.max((x - a * at[0].sin()).abs());
        if k + 1 == run.history.time.len() {
            break;
        }
        for _ in 0..250 {
            let add = |s: [f64; 2], d: [f64; 2], h: f64| [s[0] + h * d[0], s[1] + h * d[1]];
            let k1 = rate(at);
            let k2 = rate(add(at, k1, 0.5 * h));
            let k3 = rate(add(at, k2, 0.5 * h));
            let k4 = rate(add(at, k3, h));
            at = std::array::from_fn(|i| {
                at[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i])
            });
        }
    }
    assert!(worst < 0.01 * greatest, "{worst}");
    let sum = |k: usize| channel(&run, "length_m[one]")[k] + channel(&run, "length_m[two]")[k];
    assert!((0..x.len()).all(|k| (sum(k) - 24.0).abs() < 1e-10));
    // By the height that it falls.
    let fall = 100.0 * GRAVITY * (z[0] + b);
    assert!(run.balance.drift().abs() < 1e-3 * fall, "{:?}", run.balance);
}

#[test]
fn friction_stops_a_bead_where_the_tensions_differ_by_no_more() {
    let run = bead(
        "friction_n = 40.0\nramp_s = 0.5",
        &solver(60.0, Some(0.01), 0.5),
    );
    let last = |name: &str| *channel(&run, name).last().unwrap();
    let difference = last("tension_n[one|b]") - last("tension_n[two|a]");
    assert!(difference.abs() <= 40.0 * 1.001, "{difference}");
    let x = channel(&run, "x_m[bead]");
    assert!((x[x.len() - 1] - x[x.len() - 3]).abs() < 2e-3);
    assert!(
        run.balance.dissipated() > 0.0 && run.balance.relative_drift() < 2e-3,
        "{:?}",
        run.balance
    );
}

#[test]
fn a_bead_with_friction_by_its_load_comes_to_rest() {
    let run = bead(
        "friction = 0.05\nramp_s = 0.5",
        &solver(60.0, Some(0.01), 0.5),
    );
    let last = |name: &str| *channel(&run, name).last().unwrap();
    let (one, two) = (last("tension_n[one|b]"), last("tension_n[two|a]"));
    // The force across the bead is its weight.
    assert!(
        (one - two).abs() < 0.05 * 100.0 * GRAVITY * 1.01,
        "{one} {two}"
    );
}

#[test]
fn a_winch_that_hauls_in_everything_says_so() {
    let text = format!(
        "[system]\ntitle = \"test\"\n{DRY}{}{}[points.mass]\nkind = \"free\"\nmass_kg = 2000.0\n{}\
         [[payouts]]\nline = \"wire\"\nrate_m_per_s = -2.0\n{}",
        wire(10.0, 3e4),
        fixed("winch", [0.0, 0.0, 0.0]),
        line("wire", "winch", "mass", 20.0, 10),
        solver(20.0, None, 0.5),
    );
    let system = seacable::case::kind::parse::<SystemFile>(&text, "t").unwrap();
    let given = system.file.solver.clone().unwrap();
    let stop = std::sync::atomic::AtomicBool::new(false);
    let run = seacable::system::motion::run::run(&system, &given, &stop, &mut |_| {}).unwrap();
    let why = run.failure.unwrap();
    assert!(
        why.contains("nothing is left of line wire to pass its end A"),
        "{why}"
    );
    assert!(run.history.time.len() > 10);
}

/// A wire from a fixed winch to a fixed anchor, of these segments, and what is said of its ends and its payout.
fn stretched(anchor: [f64; 3], length: f64, segments: usize, ea: f64, more: &str) -> MotionRun {
    moved(&format!(
        "{DRY}{}{}{}{}{more}",
        wire(10.0, 3e4).replace("6e7", &format!("{ea:?}")),
        fixed("winch", [0.0, 0.0, 0.0]),
        fixed("anchor", anchor),
        line("wire", "winch", "anchor", length, segments),
    ))
}

fn greatest(run: &MotionRun, name: &str) -> f64 {
    let found = run
        .channels
        .iter()
        .find(|channel| channel.id.to_string() == name);
    found.unwrap().summary.greatest.0
}

#[test]
fn a_clump_stays_where_it_hangs_as_its_section_grows() {
    let sections = "[[lines]]\nname = \"wire\"\nfrom = \"winch\"\nto = \"mass\"\nsegments = 20\n\
        [[lines.sections]]\nmaterial = \"wire\"\nlength_m = 20.0\nclump_kg = 500.0\n\
        [[lines.sections]]\nmaterial = \"wire\"\nlength_m = 20.0\n";
    let run = moved(&format!(
        "{DRY}{}{}[points.mass]\nkind = \"free\"\nmass_kg = 2000.0\n{sections}\
         [[payouts]]\nline = \"wire\"\nrate_m_per_s = 0.5\nramp_s = 4.0\n{}",
        wire(10.0, 3e4),
        fixed("winch", [0.0, 0.0, 0.0]),
        solver(20.0, None, 0.5),
    ));
    let (upper, lower, ea) = (29.0, 20.0, 6e7);
    let (mass, clump, wire) = (2000.0 * GRAVITY, 500.0 * GRAVITY, 10.0 * GRAVITY);
    let length = upper + lower;
    let stretch = (mass * length + clump * upper + 0.5 * wire * length * length) / ea;
    let z = channel(&run, "z_m[mass]").last().unwrap();
    assert!(
        (z + length + stretch).abs() < 5e-6,
        "{}",
        z + length + stretch
    );
    assert!(run.balance.relative_drift() < 1e-5, "{:?}", run.balance);
}

/// The brake is so steep that what it takes on is a displacement far below Newton's tolerance.
#[test]
fn a_winch_hauls_at_its_greatest_rate_until_it_has_its_tension() {
    let payout = "[[payouts]]\nline = \"wire\"\ntension_n = 1.2e5\ngreatest_rate_m_per_s = 0.1\ndrum_mass_kg = 100.0\n";
    let solver =
        "[solver]\nduration_s = 20.0\nerror_estimate = false\n[output]\ninterval_s = 0.1\n";
    let run = stretched(
        [0.0, 0.0, -100.0],
        101.0,
        20,
        6e7,
        &format!("{payout}{solver}"),
    );
    let lengths = channel(&run, "length_m[wire]");
    for pair in lengths[20..110].windows(2) {
        let rate = (pair[1] - pair[0]) / 0.1;
        assert!((rate / -0.1 - 1.0).abs() < 2e-3, "{rate}");
    }
    let pull = *channel(&run, "tension_n[wire|a]").last().unwrap();
    assert!((pull / 1.2e5 - 1.0).abs() < 1e-3, "{pull}");
    assert!(run.balance.relative_drift() < 2e-3, "{:?}", run.balance);
    assert!(run.work.steps < 10_000, "{}", run.work.steps);
}

/// The force of the drive is flat, steep and flat again: an iteration stops at the corner between.
#[test]
fn an_iteration_stops_where_the_force_of_a_winch_has_a_corner() {
    let text = |payout: &str| {
        format!(
            "[system]\ntitle = \"test\"\n{DRY}{}{}{}{}[[payouts]]\nline = \"wire\"\n{payout}\n{}",
            wire(10.0, 3e4),
            fixed("winch", [0.0, 0.0, 0.0]),
            fixed("anchor", [0.0, 0.0, -100.0]),
            line("wire", "winch", "anchor", 99.8, 20),
            solver(1.0, None, 0.5),
        )
    };
    let towards = |payout: &str, from: f64, to: f64| {
        let parsed = seacable::case::kind::parse::<SystemFile>(&text(payout), "t");
        parsed.unwrap().network.payouts[0].drive.towards(from, to)
    };
    let gives_way = "rate_m_per_s = 0.5\ngreatest_tension_n = 2e5";
    let kept = "tension_n = 2e5\ngreatest_rate_m_per_s = 0.3";
    for (payout, from, to, reached) in [
        (gives_way, 0.0, 2.0, 0.49),
        (gives_way, 2.0, 0.0, 0.5),
        (gives_way, 0.495, 0.497, 0.497),
        (kept, 0.0, 2.0, 0.3),
        (kept, 2.0, -2.0, 0.3),
        (kept, 0.2, -2.0, -0.3),
        ("rate_m_per_s = 0.5", 0.0, 2.0, 2.0),
    ] {
        let found = towards(payout, from, to);
        assert!(
            (found - reached).abs() < 1e-6,
            "{payout} {from} {to}: {found}"
        );
    }
}

#[test]
fn an_end_that_runs_fast_is_followed_segment_by_segment() {
    for (rate, length, segments) in [(20.0, 40.0, 100), (-20.0, 200.0, 400)] {
        let run = moved(&format!(
            "{DRY}{}{}[points.mass]\nkind = \"free\"\nmass_kg = 2000.0\n{}\
             [[payouts]]\nline = \"wire\"\nrate_m_per_s = {rate:?}\nramp_s = 8.0\n\
             [solver]\nduration_s = 8.0\nerror_estimate = false\n",
            wire(10.0, 3e4),
            fixed("winch", [0.0, 0.0, 0.0]),
            line("wire", "winch", "mass", length, segments),
        ));
        let paid = channel(&run, "length_m[wire]").last().unwrap() - length;
        assert!((paid - 4.0 * rate).abs() < 1e-9, "{paid}");
        // At rest 44 kN at most, and the mass is moved at up to 4 m/s².
        assert!(greatest(&run, "tension_n[wire|a]") < 7e4);
        assert!(run.balance.relative_drift() < 1e-4, "{:?}", run.balance);
        assert!(run.work.steps < 10_000, "{}", run.work.steps);
    }
}

#[test]
fn a_stiff_line_that_hangs_slack_is_parted_without_a_jerk() {
    let more = "[[payouts]]\nline = \"wire\"\nrate_m_per_s = 1.0\nramp_s = 2.0\n\
                [solver]\nduration_s = 12.0\nerror_estimate = false\n";
    let run = stretched([100.0, 0.0, -20.0], 102.0, 10, 1e9, more);
    let pull = channel(&run, "tension_n[wire|a]");
    assert!(greatest(&run, "tension_n[wire|a]") <= pull[0] * 1.001);
    assert!(run.balance.relative_drift() < 2e-3, "{:?}", run.balance);
}

/// A segment of 10 m less has 5 mm of slack in it, which is 30 times the tension. The line sags from the start: one let go from where it is
/// taut swings for longer than it takes to part it.
#[test]
fn a_stiff_line_that_sags_is_parted_and_joined_at_its_tension() {
    for (rate, length, segments) in [(1.0, 106.0, 10), (-0.8, 113.0, 11)] {
        let more = format!(
            "[[payouts]]\nline = \"wire\"\nrate_m_per_s = {rate:?}\nramp_s = 2.0\n\
             [solver]\nduration_s = 12.0\nerror_estimate = false\n[output]\ninterval_s = 0.05\n"
        );
        let run = stretched([100.0, 0.0, -20.0], length, segments, 1e9, &more);
        let pull = channel(&run, "tension_n[wire|a]");
        for pair in pull[40..].windows(2) {
            assert!((pair[1] / pair[0] - 1.0).abs() < 0.03, "{pair:?}");
        }
        assert!(greatest(&run, "tension_n[wire|a]") <= pull[0].max(pull[240]) * 1.001);
        assert!(run.balance.relative_drift() < 2e-3, "{:?}", run.balance);
    }
}

/// The mesh runs through the sag, and its segments shake it by the square of their length.
#[test]
fn a_line_passes_from_one_end_to_the_other_as_a_whole() {
    let ends = [("a", -2.0), ("b", 2.0)].map(|(end, rate)| {
        format!(
            "[[payouts]]\nline = \"wire\"\nend = \"{end}\"\nrate_m_per_s = {rate:?}\nramp_s = 2.0\n"
        )
    });
    for (segments, off) in [(20, 0.02), (40, 0.005)] {
        let more = format!("{}{}{}", ends[0], ends[1], solver(30.0, None, 0.5));
        let run = stretched([20.0, 0.0, 0.0], 20.5, segments, 6e7, &more);
        let length = *channel(&run, "length_m[wire]").last().unwrap();
        assert!((length - 20.5).abs() < 1e-9);
        // What runs round a bend is pulled by its momentum, 10 kg/m at 2 m/s.
        let pull = channel(&run, "tension_n[wire|a]");
        for now in &pull[10..] {
            let steady = pull[0] + 40.0;
            assert!((now / steady - 1.0).abs() < off, "{now} {steady}");
        }
        // Of what is put in, most is the start.
        assert!(run.balance.relative_drift() < 0.03, "{:?}", run.balance);
    }
}

/// Its tension is read with the correction of chords that turn: a segment that grows is as taut between as at the end of a step.
#[test]
fn a_line_that_grows_while_it_swings_has_the_tension_of_one_that_does_not() {
    let run = |rate: f64| {
        moved(&format!(
            "{DRY}{}[points.winch]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [6.0, 0.0, 0.0]\nperiod_s = 10.0\nramp_s = 5.0\n\
             [points.mass]\nkind = \"free\"\nmass_kg = 200.0\n{}\
             [[payouts]]\nline = \"wire\"\nrate_m_per_s = {rate:?}\nramp_s = 2.0\n\
             [solver]\nduration_s = 15.0\ntime_step_s = 0.1\nerror_estimate = false\n",
            wire(10.0, 1e5).replace("6e7", "4e8"),
            line("wire", "winch", "mass", 60.0, 20),
        ))
    };
    let [grows, stays] = [0.1, 1e-9].map(|rate| greatest(&run(rate), "tension_n[wire|a]"));
    assert!((grows / stays - 1.0).abs() < 0.05, "{grows} {stays}");
}

/// On a bed so soft that its springs have a share of the energy.
fn laid(bed: &str, payout: &str, duration: f64, to: [f64; 3], length: f64) -> MotionRun {
    moved(&format!(
        "[seabed]\ndepth_m = 50.0\n{bed}\n\
         [materials.wire]\nmass_kg_per_m = 30.0\ndiameter_m = 0.06\nea_n = 6e7\naxial_damping_n_s = 3e4\n{}{}{}\
         [[payouts]]\nline = \"wire\"\n{payout}\n[solver]\nduration_s = {duration:?}\nerror_estimate = false\n",
        fixed("winch", [0.0, 0.0, -50.0]),
        fixed("far", to),
        line("wire", "winch", "far", length, (length / 4.0) as usize),
    ))
}

#[test]
fn a_line_that_lies_on_the_bed_is_parted_on_it() {
    for friction in ["", "friction = 0.5"] {
        let bed = format!("damping_n_s_per_m3 = 1e4\n{friction}");
        let payout = "rate_m_per_s = 1.0\nramp_s = 2.0";
        let run = laid(&bed, payout, 20.0, [150.0, 0.0, -5.0], 160.0);
        let pull = channel(&run, "tension_n[wire|a]");
        assert!(greatest(&run, "tension_n[wire|a]") <= pull[0] * 1.001);
        assert!(run.balance.relative_drift() < 1e-3, "{:?}", run.balance);
    }
}

#[test]
fn what_bears_on_the_bed_and_floats_brings_its_energy_with_it() {
    let bed = "stiffness_n_per_m3 = 1e3\ndamping_n_s_per_m3 = 1e2";
    let payout = "rate_m_per_s = 0.5\nramp_s = 2.0";
    let run = laid(bed, payout, 3.0, [40.0, 0.0, -50.0], 41.0);
    assert!(run.balance.relative_drift() < 5e-4, "{:?}", run.balance);
    let hose = "[materials.hose]\nmass_kg_per_m = 60.0\ndiameter_m = 0.4\nea_n = 1e7\naxial_damping_n_s = 1e5\ndrag_normal = 1.0\n";
    let run = moved(&format!(
        "[environment]\nwater_surface = \"crossed\"\n{hose}{}{}{}[[payouts]]\nline = \"wire\"\nrate_m_per_s = 0.2\n\
         [solver]\nduration_s = 10.0\nerror_estimate = false\n",
        fixed("reel", [0.0, 0.0, -0.05]),
        fixed("end", [40.0, 0.0, -0.05]),
        line("wire", "reel", "end", 41.0, 10).replace("\"wire\"\nlength", "\"hose\"\nlength"),
    ));
    assert!(run.balance.relative_drift() < 1e-3, "{:?}", run.balance);
}

#[test]
fn energy_that_remeshing_takes_asks_for_more_segments() {
    // Heavy rubber on a mesh so coarse that a node more hangs metres lower.
    let rubber = "[materials.wire]\nmass_kg_per_m = 144.0\ndiameter_m = 0.21\nea_n = 6e5\naxial_damping_ratio = 0.3\n";
    let run = moved(&format!(
        "{rubber}{}{}[points.bead]\nkind = \"free\"\nmass_kg = 200.0\n{}{}\
         [[sliding_points]]\npoint = \"bead\"\nline = \"one\"\nother = \"two\"\n\
         [solver]\nduration_s = 4.0\nerror_estimate = false\n",
        fixed("left", [0.0, 0.0, -30.0]),
        fixed("right", [290.0, 0.0, -120.0]),
        line("one", "left", "bead", 100.0, 14),
        line("two", "bead", "right", 275.0, 8),
    ));
    let about = |warning: &&String| warning.contains("energy");
    let warning = run.warnings.iter().find(about).unwrap();
    assert!(warning.contains("more `segments`"), "{warning}");
}

#[test]
fn what_cannot_be_paid_out_is_refused() {
    let base = format!(
        "{}{}{}[points.mass]\nkind = \"free\"\nmass_kg = 2000.0\n{}{}",
        wire(10.0, 3e4),
        fixed("winch", [0.0, 0.0, 0.0]),
        fixed("anchor", [50.0, 0.0, -20.0]),
        line("wire", "winch", "mass", 20.0, 10),
        line("stay", "mass", "anchor", 60.0, 10),
    );
    for (text, wanted) in [
        (
            "[[payouts]]\nline = \"wires\"\nrate_m_per_s = 1.0\n",
            "no line named",
        ),
        (
            "[[payouts]]\nline = \"wire\"\n",
            "nothing pays the line out",
        ),
        (
            "[[payouts]]\nline = \"wire\"\nrate_m_per_s = 1.0\ntension_n = 1e5\n",
            "both `rate_m_per_s` and `tension_n`",
        ),
        (
            "[[payouts]]\nline = \"wire\"\ntension_n = 1e5\nstart_s = 3.0\n",
            "no effect without",
        ),
        (
            "[[payouts]]\nline = \"wire\"\nend = \"b\"\nheave_compensation = 1.0\n",
            "free to move",
        ),
        (
            "[[payouts]]\nline = \"wire\"\nrate_m_per_s = 1.0\n[[payouts]]\nline = \"wire\"\nrate_m_per_s = 2.0\n",
            "already",
        ),
        (
            "[[payouts]]\nline = \"wire\"\ntable_time_s = [0.0, 5.0]\n",
            "table_m",
        ),
        (
            "[[payouts]]\nline = \"wire\"\ntable_time_s = [0.0, 5.0]\ntable_m = [1.0, 2.0]\n",
            "begins with 1 m",
        ),
        (
            "[[payouts]]\nline = \"wire\"\nrate_m_per_s = 1.0\nstart_s = 8.0\nstop_s = 2.0\n",
            "before the start at 8 s",
        ),
        (
            "[[sliding_points]]\npoint = \"mass\"\nline = \"wire\"\nother = \"stay\"\n\
             [[sliding_points]]\npoint = \"mass\"\nline = \"wire\"\nother = \"stay\"\n",
            "another sliding point passes",
        ),
        (
            "[[sliding_points]]\npoint = \"winch\"\nline = \"wire\"\nother = \"stay\"\n",
            "has no end at",
        ),
        (
            "[[sliding_points]]\npoint = \"mass\"\nline = \"wire\"\nother = \"wire\"\n",
            "on the other side too",
        ),
    ] {
        println!("{text}");
        let said = refused(&format!("{base}{text}"));
        assert!(said.contains(wanted), "{wanted}: {said}");
    }
}
