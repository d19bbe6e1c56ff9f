//! Bodies and rods that are pinned, and systems without lines: equilibria, periods and swings by their closed forms.

use std::f64::consts::{PI, TAU};

use seacable::numerics::V3;
use seacable::system::SolvedSystem;
use seacable::system::motion::run::MotionRun;
use seacable::system::quantities::value;
use seacable::system::stability::Stability;

use crate::motion::{channel, moved, refused};
use crate::{HEAD, solved};

const G: f64 = 9.80665;
const FRESH: &str = "[environment]\nwater_density_kg_per_m3 = 1000.0\n";
const AIR: &str = "[environment]\nwater_density_kg_per_m3 = 0.0\n";

fn at_rest(text: &str) -> SolvedSystem {
    solved(&format!("{HEAD}{text}"))
}

fn results<const N: usize>(system: &SolvedSystem, names: [&str; N]) -> [f64; N] {
    names.map(|name| value(system, name).unwrap())
}

fn assert_near(found: f64, known: f64, share: f64) {
    let off = (found - known).abs();
    assert!(off <= share * known.abs(), "{found} is not {known}");
}

/// A rod that is pinned at its end A.
fn rod(ends: [[f64; 3]; 2], diameter: f64, mass: f64, added_mass: f64) -> String {
    let [a, b] = ends;
    format!(
        "[rods.rod]\nkind = \"pinned\"\nend_a_m = {a:?}\nend_b_m = {b:?}\ndiameter_m = {diameter:?}\nmass_kg = {mass:?}
        added_mass_normal = {added_mass:?}\n"
    )
}

#[test]
fn a_pinned_rod_under_water_stands_or_hangs_by_what_is_heavier() {
    let (long, diameter, added) = (1.2, 0.25, 0.7);
    let displaced = 1000.0 * 0.25 * PI * diameter * diameter * long;
    for mass in [10.0, 140.0] {
        let system = at_rest(&format!(
            "{FRESH}{}",
            rod([[2.0, 1.0, -5.0], [3.2, 1.0, -5.0]], diameter, mass, added)
        ));
        let net = (mass - displaced) * G;
        let end = crate::place(&system, "rod-b");
        let upright = -5.0 - long * net.signum();
        assert!((end[0] - 2.0).abs() < 1e-9 && (end[2] - upright).abs() < 1e-9);
        assert_eq!(crate::place(&system, "rod-a"), [2.0, 1.0, -5.0]);
        let force = results(
            &system,
            [
                "pin_force_x_n[rod]",
                "pin_force_y_n[rod]",
                "pin_force_z_n[rod]",
            ],
        );
        assert!(force[0].abs() < 1e-9 && force[1].abs() < 1e-9);
        assert_near(force[2], net, 1e-12);
        assert_eq!(system.stability, Stability::Stable);
        // A physical pendulum about its end, with the added mass of its length.
        let radius = 0.5 * diameter;
        let inertia = mass * (0.25 * radius * radius + long * long / 3.0);
        let with_water = inertia + added * displaced * long * long / 3.0;
        let period = TAU * (with_water / (net.abs() * 0.5 * long)).sqrt();
        for found in results(&system, ["period_s[1]", "period_s[2]"]) {
            assert_near(found, period, 1e-9);
        }
        assert!(value(&system, "period_s[3]").is_err());
    }
}

#[test]
fn a_light_rod_pinned_under_the_surface_leans_until_weight_and_buoyancy_balance() {
    let (long, diameter, deep) = (10.0, 0.02, 4.0);
    let section = 0.25 * PI * diameter * diameter;
    let mass = 0.36 * 1000.0 * section * long;
    let ends = [[0.0, 0.0, -deep], [6.0, 0.0, 4.0]];
    let system = at_rest(&format!("{FRESH}{}", rod(ends, diameter, mass, 1.0)));
    // The moments of half its length and of half its wet length balance: the wet length is 0.6 of it.
    let [x, y, z] = crate::place(&system, "rod-b");
    assert_near(z + deep, long * deep / 6.0, 1e-5);
    assert_near(
        x.hypot(y),
        long * (1.0 - (4.0_f64 / 6.0).powi(2)).sqrt(),
        1e-5,
    );
    let [force] = results(&system, ["pin_force_z_n[rod]"]);
    assert_near(force, (mass - 1000.0 * section * 6.0) * G, 1e-5);
}

/// An arm of 400 kg and 6 m in air, pinned at one end, its other end on a wire.
fn arm(keys: &str) -> String {
    format!(
        "{AIR}[materials.wire]\nmass_kg_per_m = 0.5\ndiameter_m = 0.02\nea_n = 1e5\naxial_damping_n_s = 1e3
        [points.top]\nkind = \"fixed\"\nposition_m = [5.0, 1.0, 12.0]
        [points.tip]\nkind = \"body\"\nbody = \"arm\"\nposition_m = [6.0, 0.0, 0.0]
        [bodies.arm]\nkind = \"pinned\"\nposition_m = [0.0, 0.0, 0.0]\nmass_kg = 400.0\ncentre_of_gravity_m = [3.0, 0.0, 0.0]
        inertia_kg_m2 = [20.0, 1200.0, 1200.0]\n{keys}
        [[lines]]\nname = \"wire\"\nfrom = \"tip\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 12.0\nsegments = 6\n"
    )
}

#[test]
fn a_line_at_a_lever_balances_a_pinned_body() {
    let system = at_rest(&arm(""));
    let line = &system.rest.balance.lines[0];
    let weight = 400.0 * G;
    let tip = nalgebra::Vector3::from(crate::place(&system, "tip"));
    let moment =
        tip.cross(&line.force_a) + (tip * 0.5).cross(&nalgebra::Vector3::new(0.0, 0.0, -weight));
    assert!(moment.norm() < 1e-7 * weight, "{moment}");
    assert_near(tip.norm(), 6.0, 1e-12);
    let force = results(
        &system,
        [
            "pin_force_x_n[arm]",
            "pin_force_y_n[arm]",
            "pin_force_z_n[arm]",
        ],
    );
    let out = nalgebra::Vector3::from(force) + line.force_a - nalgebra::Vector3::z() * weight;
    assert!(out.norm() < 1e-9 * weight, "{out}");
    // It may turn about its own axis.
    assert_eq!(
        system.stability,
        Stability::Neutral("roll of arm".to_owned())
    );
}

const MASS: f64 = 50.0;
const ARM: f64 = 1.5;
/// About the pin.
const INERTIA: f64 = 20.0 + MASS * ARM * ARM;

/// A body that hangs from its origin in air.
fn pendulum(keys: &str, solver: &str) -> String {
    format!(
        "{AIR}[bodies.bob]\nkind = \"pinned\"\nposition_m = [3.0, -2.0, -4.0]\nmass_kg = {MASS:?}\ncentre_of_gravity_m = [0.0, 0.0, {:?}]
        inertia_kg_m2 = [20.0, 20.0, 5.0]\n{keys}\n[solver]\nerror_estimate = false\n{solver}\n",
        -ARM
    )
}

fn fixed_steps(method: &str, duration: f64, step: f64, rho: f64) -> String {
    format!(
        "method = \"{method}\"\nduration_s = {duration:?}\ntime_step_s = {step:?}\nrho_inf = {rho:?}\nposition_tolerance_m = 1e-12\n[output]\ninterval_s = {step:?}"
    )
}

/// Complete elliptic integral of the first kind by the arithmetic-geometric mean.
fn elliptic(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    0.5 * PI / a
}

#[test]
fn a_swing_from_far_aside_has_the_period_and_the_pull_of_its_closed_form() {
    let aside = 70.0_f64.to_radians();
    let omega = (MASS * G * ARM / INERTIA).sqrt();
    let period = 4.0 / omega * elliptic((0.5 * aside).sin());
    for method in ["alpha", "rk4"] {
        let run = moved(&pendulum(
            "start_offset_deg = [0.0, 70.0, 0.0]",
            &fixed_steps(method, period, period / 4000.0, 1.0),
        ));
        let pitch = channel(&run, "pitch_deg[bob]");
        assert_near(*pitch.last().unwrap(), 70.0, 1e-5);
        assert_near(pitch[2000], -70.0, 1e-5);
        let place = ["x_m[bob]", "y_m[bob]", "z_m[bob]"].map(|name| channel(&run, name));
        for (place, known) in place.iter().zip([3.0, -2.0, -4.0]) {
            assert!(place.iter().all(|value| *value == known));
        }
        // At the lowest place its weight and what turns it.
        let rate2 = 2.0 * omega * omega * (1.0 - aside.cos());
        let pull = channel(&run, "pin_force_z_n[bob]");
        assert_near(pull[1000], MASS * (G + ARM * rate2), 1e-5);
        // At the turning points along the arm the part of the weight, across it that of the acceleration.
        let gain = omega * omega * aside.sin();
        let (sin, cos) = aside.sin_cos();
        assert_near(pull[0], MASS * G - MASS * ARM * gain * sin, 1e-6);
        let across = channel(&run, "pin_force_x_n[bob]")[0];
        assert_near(across, MASS * ARM * gain * cos, 1e-6);
        assert!(run.balance.relative_drift() < 1e-5, "{:?}", run.balance);
    }
}

/// Angles after a swing in space of one second in so many steps.
fn swung(method: &str, steps: f64) -> [f64; 3] {
    let run = moved(&pendulum(
        "start_offset_deg = [50.0, 40.0, 20.0]\ndamping = [0.0, 0.0, 0.0, 30.0, 30.0, 5.0]",
        &fixed_steps(method, 1.5, 1.5 / steps, 0.4),
    ));
    ["roll_deg[bob]", "pitch_deg[bob]", "yaw_deg[bob]"]
        .map(|name| *channel(&run, name).last().unwrap())
}

#[test]
fn a_swing_in_space_is_of_the_order_of_the_method() {
    let truth = swung("rk4", 1600.0);
    for (method, steps, known) in [("alpha", 100.0, 2.0), ("rk4", 25.0, 4.0)] {
        let off = |steps: f64| {
            let found = swung(method, steps);
            let parts = found.iter().zip(&truth).map(|(a, b)| (a - b).powi(2));
            parts.sum::<f64>().sqrt()
        };
        let order = (off(steps) / off(4.0 * steps)).log2() / 2.0;
        assert!((order - known).abs() < 0.3, "{method}: {order}");
    }
}

#[test]
fn a_pin_that_moves_drives_its_body() {
    let (size, omega) = (0.002, 3.0);
    let own = (MASS * G * ARM / INERTIA).sqrt();
    let run = moved(&pendulum(
        &format!(
            "amplitude_m = [{size:?}, 0.0, 0.0]\nperiod_s = [{:?}]",
            TAU / omega
        ),
        &fixed_steps("alpha", 8.0, 0.002, 1.0),
    ));
    let gain = -MASS * ARM / INERTIA * size * omega * omega / (own * own - omega * omega);
    let time = &run.history.time;
    let (pitch, x) = (channel(&run, "pitch_deg[bob]"), channel(&run, "x_m[bob]"));
    for (row, t) in time.iter().enumerate() {
        let angle = gain * ((omega * t).sin() - omega / own * (own * t).sin());
        assert!(
            (pitch[row].to_radians() - angle).abs() < 2e-3 * gain.abs(),
            "{t}"
        );
        assert!((x[row] - 3.0 - size * (omega * t).sin()).abs() < 1e-12);
    }
    assert!(run.balance.relative_drift() < 1e-4, "{:?}", run.balance);
}

/// The arm let go aside of its equilibrium.
fn dropped(method: &str, step: f64) -> MotionRun {
    let solver = fixed_steps(method, 2.0, step, 0.9)
        .replace(&format!("interval_s = {step:?}"), "interval_s = 0.1");
    let text =
        arm("start_offset_deg = [0.0, 1.0, 4.0]\ndamping = [0.0, 0.0, 0.0, 10.0, 50.0, 50.0]");
    moved(&format!(
        "{text}[solver]\nerror_estimate = false\n{solver}\n"
    ))
}

#[test]
fn both_methods_move_a_pinned_body_on_a_line_alike() {
    let (one, other) = (dropped("alpha", 5e-4), dropped("rk4", 1e-4));
    for name in [
        "pitch_deg[arm]",
        "yaw_deg[arm]",
        "z_m[tip]",
        "tension_n[wire|a]",
        "pin_force_x_n[arm]",
        "pin_force_z_n[arm]",
    ] {
        let (one, other) = (channel(&one, name), channel(&other, name));
        let size = other
            .iter()
            .map(|v| (v - other[0]).abs())
            .fold(0.0, f64::max);
        assert!(size > 0.0 && size.is_finite(), "{name}");
        for (a, b) in one.iter().zip(other) {
            assert!((a - b).abs() < 5e-3 * size, "{name}: {a} {b} of {size}");
        }
    }
    assert!(one.balance.relative_drift() < 1e-3, "{:?}", one.balance);
}

/// Two arms in air, the second pinned to the end of the first; `first` is what holds that.
fn two_arms(first: &str, second: &str) -> String {
    format!(
        "{AIR}[bodies.upper]\n{first}\nmass_kg = 80.0\ncentre_of_gravity_m = [0.0, 0.0, -1.0]\ninertia_kg_m2 = [40.0, 40.0, 4.0]
        [bodies.lower]\nkind = \"pinned\"\npinned_to = \"upper\"\nposition_m = [0.0, 0.0, -2.0]\nmass_kg = 30.0\ncentre_of_gravity_m = [0.0, 0.0, -0.5]
        inertia_kg_m2 = [6.0, 6.0, 1.0]\n{second}\n"
    )
}

const PINNED: &str = "kind = \"pinned\"\nposition_m = [1.0, 2.0, 3.0]";

#[test]
fn a_body_pinned_to_a_pinned_body_is_a_double_pendulum() {
    let system = at_rest(&two_arms(PINNED, "pitch_deg = 40.0\nroll_deg = 10.0"));
    let pins =
        ["upper", "lower"].map(|name| value(&system, &format!("pin_force_z_n[{name}]")).unwrap());
    assert_near(pins[0], 110.0 * G, 1e-12);
    assert_near(pins[1], 30.0 * G, 1e-12);
    let lower = system.rest.placement.bodies[system.network.body("lower").unwrap()];
    assert!((lower.origin - nalgebra::Vector3::new(1.0, 2.0, 1.0)).norm() < 1e-9);
    // (I1 + m2 L^2) a" + m2 L l2 b" + (m1 l1 + m2 L) g a = 0 and m2 L l2 a" + I2 b" + m2 l2 g b = 0, inertias about the pins.
    let (a, b, c) = (120.0 + 30.0 * 4.0, 30.0 * 2.0 * 0.5, 6.0 + 30.0 * 0.25);
    let (k, l) = ((80.0 + 60.0) * G, 15.0 * G);
    let (p, q, r) = (a * c - b * b, -(a * l + c * k), k * l);
    let root = (q * q - 4.0 * p * r).sqrt();
    let slow = TAU / ((-q - root) / (2.0 * p)).sqrt();
    let fast = TAU / ((-q + root) / (2.0 * p)).sqrt();
    let names = ["period_s[1]", "period_s[2]", "period_s[3]", "period_s[4]"];
    for (found, known) in results(&system, names).iter().zip([slow, slow, fast, fast]) {
        assert_near(*found, known, 1e-8);
    }
}

#[test]
fn a_double_pendulum_keeps_its_energy_and_both_methods_move_it_alike() {
    let text = |method: &str, step: f64| {
        let solver = fixed_steps(method, 3.0, step, 1.0)
            .replace(&format!("interval_s = {step:?}"), "interval_s = 0.05");
        let first = format!("{PINNED}\nstart_offset_deg = [30.0, 40.0, 0.0]");
        let arms = two_arms(&first, "start_offset_deg = [10.0, -50.0, 0.0]");
        format!("{arms}[solver]\nerror_estimate = false\n{solver}\n")
    };
    let runs = [("alpha", 1e-3), ("alpha", 5e-4), ("rk4", 1e-3)]
        .map(|(method, step)| moved(&text(method, step)));
    for name in [
        "x_m[lower]",
        "z_m[lower]",
        "pin_force_z_n[lower]",
        "pin_force_x_n[upper]",
    ] {
        let [coarse, fine, truth] = [0, 1, 2].map(|run| channel(&runs[run], name));
        let range = |values: &[f64]| {
            values
                .iter()
                .map(|v| (v - truth[0]).abs())
                .fold(0.0, f64::max)
        };
        let off = |values: &[f64]| {
            let parts = values.iter().zip(truth).map(|(a, b)| (a - b).abs());
            parts.fold(0.0, f64::max)
        };
        assert!(
            off(fine) < 2e-3 * range(truth),
            "{name}: {} of {}",
            off(fine),
            range(truth)
        );
        let order = (off(coarse) / off(fine)).log2();
        assert!((1.8..2.2).contains(&order), "{name}: {order}");
    }
    for run in &runs {
        assert!(run.balance.relative_drift() < 1e-4, "{:?}", run.balance);
    }
    assert!(runs[2].balance.relative_drift() < 1e-6);
}

#[test]
fn a_body_pinned_to_a_held_or_moved_one_is_pinned_to_the_place() {
    let moves = "amplitude_m = [0.2, 0.0, 0.1]\nperiod_s = [2.0]\nramp_s = 1.0\n";
    let solver = "[solver]\nduration_s = 3.0\ntime_step_s = 0.002\nrho_inf = 1.0\nerror_estimate = false\n[output]\ninterval_s = 0.1\n";
    let run = |first: &str| {
        let arms = two_arms(first, "start_offset_deg = [0.0, 20.0, 0.0]");
        moved(&format!("{arms}{solver}"))
    };
    let place = "position_m = [1.0, 2.0, 3.0]";
    let alone = |motion: &str| {
        moved(&format!(
            "{AIR}[bodies.lower]\nkind = \"pinned\"\nposition_m = [1.0, 2.0, 1.0]\nmass_kg = 30.0\ncentre_of_gravity_m = [0.0, 0.0, -0.5]
            inertia_kg_m2 = [6.0, 6.0, 1.0]\nstart_offset_deg = [0.0, 20.0, 0.0]\n{motion}{solver}"
        ))
    };
    let pairs = [
        (run(&format!("kind = \"held\"\n{place}")), alone("")),
        (
            run(&format!("kind = \"moved\"\n{place}\n{moves}")),
            alone(moves),
        ),
    ];
    for (on_body, alone) in pairs {
        for name in ["pitch_deg[lower]", "pin_force_z_n[lower]", "x_m[lower]"] {
            for (a, b) in channel(&on_body, name).iter().zip(channel(&alone, name)) {
                assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{name}: {a} {b}");
            }
        }
        for run in [on_body, alone] {
            assert!(run.balance.relative_drift() < 1e-4, "{:?}", run.balance);
        }
    }
}

/// A body on a line, with a rod on it, and a line from the far end of the rod to the earth.
fn crane(more: &str) -> String {
    format!(
        "{FRESH}[materials.wire]\nmass_kg_per_m = 5.0\ndiameter_m = 0.03\nea_n = 2e6\naxial_damping_n_s = 1e4
        [points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -5.0]\n[points.side]\nkind = \"fixed\"\nposition_m = [25.0, 4.0, -30.0]
        [points.eye]\nkind = \"body\"\nbody = \"hull\"\nposition_m = [0.2, 0.0, 2.0]
        [bodies.hull]\nkind = \"free\"\nposition_m = [0.0, 0.0, -28.0]\nmass_kg = 6e3\nvolume_m3 = 3.0\ninertia_kg_m2 = [5e3, 6e3, 7e3]
        added_mass = [2e3, 2e3, 3e3, 1e3, 1e3, 1e3]\n{more}
        [rods.jib]\nkind = \"pinned\"\npinned_to = \"hull\"\nend_a_m = [1.5, 0.0, 0.0]\nend_b_m = [6.0, 1.0, -1.0]\ndiameter_m = 0.3\nmass_kg = 900.0
        [[lines]]\nname = \"hoist\"\nfrom = \"eye\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 20.0\nsegments = 8
        [[lines]]\nname = \"guy\"\nfrom = \"jib-b\"\nto = \"side\"\nmaterial = \"wire\"\nlength_m = 19.0\nsegments = 8\n"
    )
}

#[test]
fn a_rod_pinned_to_a_free_body_balances_with_it() {
    let system = at_rest(&crane(""));
    let network = &system.network;
    let [hull, jib] = ["hull", "jib"].map(|name| network.body(name).unwrap());
    let lines = &system.rest.balance.lines;
    let [hoist, guy] = ["hoist", "guy"].map(|name| lines[network.line(name).unwrap()].force_a);
    let up = nalgebra::Vector3::z();
    let on_jib = (0.25 * PI * 0.09 * 1000.0 * (4.5_f64.powi(2) + 2.0).sqrt() - 900.0) * G;
    let of_pin =
        ["x", "y", "z"].map(|axis| value(&system, &format!("pin_force_{axis}_n[jib]")).unwrap());
    let of_pin = nalgebra::Vector3::from(of_pin);
    let scale = 6e3 * G;
    assert!((of_pin + guy + up * on_jib).norm() < 1e-7 * scale);
    assert!((hoist - of_pin + up * ((3e3 - 6e3) * G)).norm() < 1e-7 * scale);
    let pose = system.rest.placement.bodies[jib];
    let end = nalgebra::Vector3::from(crate::place(&system, "jib-b")) - pose.origin;
    let moment = end.cross(&guy) + (end * 0.5).cross(&(up * on_jib));
    assert!(moment.norm() < 1e-6 * scale, "{moment}");
    let carrier = system.rest.placement.bodies[hull];
    let pin = carrier.arm(&nalgebra::Vector3::new(1.5, 0.0, 0.0));
    assert!((carrier.origin + pin - pose.origin).norm() < 1e-12);
    let eye = carrier.arm(&nalgebra::Vector3::new(0.2, 0.0, 2.0));
    let moment = eye.cross(&hoist) - pin.cross(&of_pin);
    assert!(moment.norm() < 1e-6 * scale, "{moment}");
}

#[test]
fn a_rod_pinned_to_a_free_body_moves_alike_by_both_methods() {
    let run = |method: &str, step: f64| {
        let solver = fixed_steps(method, 4.0, step, 0.9)
            .replace(&format!("interval_s = {step:?}"), "interval_s = 0.1");
        let aside = crane("start_offset_deg = [2.0, 4.0, 5.0]\n");
        moved(&format!(
            "{aside}[solver]\nerror_estimate = false\n{solver}\n"
        ))
    };
    let (one, other) = (run("alpha", 2e-3), run("rk4", 5e-4));
    for name in [
        "pitch_deg[hull]",
        "z_m[jib-b]",
        "x_m[jib]",
        "tension_n[guy|a]",
        "pin_force_z_n[jib]",
    ] {
        let (one, other) = (channel(&one, name), channel(&other, name));
        let size = other
            .iter()
            .map(|v| (v - other[0]).abs())
            .fold(0.0, f64::max);
        assert!(size > 0.0 && size.is_finite(), "{name}");
        for (a, b) in one.iter().zip(other) {
            assert!((a - b).abs() < 1e-2 * size, "{name}: {a} {b} of {size}");
        }
    }
    assert!(one.balance.relative_drift() < 2e-3, "{:?}", one.balance);
    assert!(other.balance.relative_drift() < 1e-4, "{:?}", other.balance);
}

#[test]
fn a_pinned_rod_stays_where_it_rests() {
    let text = format!(
        "{FRESH}{}[solver]\nduration_s = 5.0\nerror_estimate = false\n",
        rod([[0.0, 0.0, -5.0], [1.0, 0.0, -5.0]], 0.25, 10.0, 0.0)
    );
    let run = moved(&text);
    let end = channel(&run, "z_m[rod-b]");
    assert!(end.iter().all(|z| (z + 4.0).abs() < 1e-9), "{end:?}");
    let net = (10.0 - 1000.0 * 0.25 * PI * 0.0625) * G;
    let pull = channel(&run, "pin_force_z_n[rod]");
    assert!(
        pull.iter().all(|force| (force - net).abs() < 1e-6),
        "{pull:?}"
    );
}

#[test]
fn a_body_afloat_without_lines_heaves_with_its_period() {
    let text = "[bodies.buoy]\nkind = \"free\"\nposition_m = [0.0, 0.0, 0.0]\nmass_kg = 1e4\nvolume_m3 = 9.75609756097561
        inertia_kg_m2 = [1e4, 1e4, 1e4]\nwaterplane_stiffness = [0.0, 0.0, 5e4, 1e5, 1e5, 0.0]\nadded_mass = [2e3, 2e3, 5e3, 1e3, 1e3, 1e3]
        start_offset_m = [0.0, 0.0, 0.1]\n";
    let system = at_rest(text);
    assert!(matches!(system.stability, Stability::Neutral(_)));
    let period = TAU * (1.5e4_f64 / 5e4).sqrt();
    let solver = fixed_steps("alpha", 2.0 * period, period / 500.0, 1.0);
    let run = moved(&format!(
        "{text}[solver]\nerror_estimate = false\n{solver}\n"
    ));
    let heave = channel(&run, "z_m[buoy]");
    assert_near(*heave.last().unwrap(), 0.1, 1e-3);
    assert_near(heave[250], -0.1, 1e-3);
}

#[test]
fn what_cannot_be_pinned_or_computed_is_refused() {
    let sinks = "[rods.r]\nkind = \"free\"\nend_a_m = [0.0, 0.0, -5.0]\nend_b_m = [1.0, 0.0, -5.0]\ndiameter_m = 0.1\nmass_kg = 100.0\n";
    let held = sinks.replace("free", "held");
    let loaded = sinks.replace("free", "pinned") + "load_n = [1.0, 0.0, 0.0]\n";
    let bare = "[bodies.b]\nkind = \"pinned\"\n";
    let bottom = "[bodies.b]\nkind = \"pinned\"\nmass_kg = 1.0\nbottom_m = 1.0\nstart_offset_m = [1.0, 0.0, 0.0]\namplitude_deg = [1.0, 0.0, 0.0]\n";
    for (text, said) in [
        (sinks, "nothing holds \"r\""),
        (
            held.as_str(),
            "nothing in the system moves or comes to an equilibrium",
        ),
        (loaded.as_str(), "is not covered for a pinned rod"),
        (bare, "a pinned body needs its mass: add `mass_kg`"),
        (bottom, "is not covered for a pinned body"),
        (
            bottom,
            "the origin of a pinned body is where its position and its motion have it",
        ),
        (bottom, "a pinned body is free to turn"),
    ] {
        let found = refused(text);
        assert!(found.contains(said), "{said}: {found}");
    }
}

/// Munk's moment turns a flat body, of more added mass along its axis than across it, along the flow: `(A_t - A_n) U² sin cos` of its tilt
/// holds the balance with the moment of its weight about the pin (Lamb 1932, art. 124).
#[test]
fn a_flat_body_leans_in_a_current_by_munks_moment() {
    let (mass, below, aside, speed) = (500.0, 0.6, 0.06, 0.7);
    let (across, along) = (1000.0, 4000.0);
    for (direction, at) in [(0.0_f64, -0.4), (50.0, 0.7)] {
        let system = at_rest(&format!(
            "{FRESH}[current]\nspeed_m_per_s = {speed:?}\ndirection_deg = {direction:?}
            [bodies.plate]\nkind = \"pinned\"\nposition_m = [0.0, 0.0, -20.0]\nyaw_deg = {direction:?}\nmass_kg = {mass:?}
            centre_of_gravity_m = [{aside:?}, 0.0, {:?}]\ninertia_kg_m2 = [50.0, 50.0, 80.0]
            added_mass = [{across:?}, {across:?}, {along:?}, 100.0, 100.0, 0.0]\ncentre_of_added_mass_m = [0.0, 0.0, {at:?}]\n",
            -below
        ));
        let axis = system.rest.placement.bodies[0].arm(&V3::z());
        let (sin, cos) = (axis.xy().norm(), axis.z);
        let weight = mass * G * (below * sin - aside * cos);
        let munk = (along - across) * speed * speed * sin * cos;
        assert!(
            (weight - munk).abs() < 1e-6 * mass * G * below,
            "{weight} {munk}"
        );
        // Half as far again as without the current.
        assert!(sin / cos > 1.5 * aside / below, "{axis}");
    }
}
