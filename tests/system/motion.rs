//! Systems in motion: against single lines, closed forms and conservation, orders of convergence.

use std::sync::atomic::AtomicBool;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use seacable::dynamics::generalized_alpha::GeneralizedAlpha;
use seacable::dynamics::rk4::Rk4;
use seacable::dynamics::{Stepper, TimeStep};
use seacable::solve::{Marched, State};
use seacable::system::motion::body_equation::MovingBody;
use seacable::system::motion::border::Border;
use seacable::system::motion::run::{MotionRun, run};
use seacable::system::motion::{MovingSystem, SystemState};
use seacable::system::network::{Body, Network};
use seacable::system::pose::Pose;

use crate::{HEAD, solved};

type V3 = Vector3<f64>;

/// A system run in time.
pub(crate) fn moved(text: &str) -> MotionRun {
    let system = solved(&format!("{HEAD}{text}"));
    let given = system.file.solver.clone().unwrap();
    let run = run(&system, &given, &AtomicBool::new(false), &mut |_| {}).unwrap();
    assert_eq!(run.failure, None);
    run
}

/// The values of a channel.
pub(crate) fn channel<'a>(run: &'a MotionRun, name: &str) -> &'a [f64] {
    &run.history.channel(name).unwrap().values
}

/// What is wrong with a system.
pub(crate) fn refused(text: &str) -> String {
    let text = format!("{HEAD}{text}");
    let errors =
        seacable::case::kind::parse::<seacable::system::SystemFile>(&text, "t").unwrap_err();
    errors.iter().map(ToString::to_string).collect::<String>()
}

const WIRE: &str = "
[materials.wire]
mass_kg_per_m = 20.0
diameter_m = 0.06
ea_n = 1e8
drag_normal = 1.2
drag_tangential = 0.01
added_mass_normal = 1.0
axial_damping_n_s = 1e5
";

fn solver(duration: f64, step: f64) -> String {
    format!(
        "[solver]\nduration_s = {duration}\ntime_step_s = {step:?}\nposition_tolerance_m = 1e-10\nerror_estimate = false\n\
         [output]\ninterval_s = 0.25\n"
    )
}

#[test]
fn a_line_in_two_parts_moves_as_one() {
    let head = format!(
        "{WIRE}
        [points.top]\nkind = \"moved\"\nposition_m = [60.0, 0.0, 0.0]\namplitude_m = [1.0, 0.5, 2.0]\nperiod_s = [9.0, 11.0, 7.0]\nramp_s = 5.0
        [points.bottom]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -100.0]
        {}",
        solver(20.0, 0.05)
    );
    let whole = moved(&format!(
        "{head}[[lines]]\nname = \"one\"\nfrom = \"bottom\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 130.0\nsegments = 26\n"
    ));
    let halves = moved(&format!(
        "{head}[points.middle]\nkind = \"free\"
        [[lines]]\nname = \"low\"\nfrom = \"bottom\"\nto = \"middle\"\nmaterial = \"wire\"\nlength_m = 50.0\nsegments = 10
        [[lines]]\nname = \"high\"\nfrom = \"middle\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 80.0\nsegments = 16\n"
    ));
    for (one, other) in [
        ("tension_n[one|a]", "tension_n[low|a]"),
        ("tension_n[one|b]", "tension_n[high|b]"),
    ] {
        let pairs = channel(&whole, one).iter().zip(channel(&halves, other));
        for (one, other) in pairs {
            assert!((one - other).abs() < 1e-6 * one.abs(), "{one} {other}");
        }
    }
    let both = ["tension_n[low|b]", "tension_n[high|a]"].map(|name| channel(&halves, name));
    for (low, high) in both[0].iter().zip(both[1]) {
        // Forces balance between the steps, and at their ends to second order.
        assert!((low - high).abs() < 1e-4 * low, "{low} {high}");
    }
}

/// A manifold on a bridle, hung from a heaving top.
fn bridle(step: f64) -> MotionRun {
    let solver = solver(16.0, step);
    let (_, settings) = solver.split_once("[solver]\n").unwrap();
    moved(&bridle_of(settings))
}

fn bridle_of(settings: &str) -> String {
    format!(
        "{WIRE}
        [points.top]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [0.5, 0.0, 1.0]\nperiod_s = 8.0\nramp_s = 8.0
        [points.junction]\nkind = \"free\"\nmass_kg = 300.0
        [points.fore]\nkind = \"body\"\nbody = \"manifold\"\nposition_m = [3.0, 0.0, 1.0]
        [points.aft]\nkind = \"body\"\nbody = \"manifold\"\nposition_m = [-3.0, 0.2, 1.0]
        [bodies.manifold]\nkind = \"free\"\nposition_m = [0.0, 0.0, -60.0]\nmass_kg = 2e4\ninertia_kg_m2 = [3e4, 1e5, 1e5]
        volume_m3 = 2.5\nadded_mass = [5e3, 8e3, 1e4, 1e4, 2e4, 2e4]\ndrag_area_m2 = [6.0, 8.0, 12.0]
        quadratic_damping = [0.0, 0.0, 0.0, 1e4, 4e4, 4e4]
        [[lines]]\nname = \"lift\"\nfrom = \"junction\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 50.0\nsegments = 10
        [[lines]]\nname = \"fore\"\nfrom = \"fore\"\nto = \"junction\"\nmaterial = \"wire\"\nlength_m = 8.0\nsegments = 4
        [[lines]]\nname = \"aft\"\nfrom = \"aft\"\nto = \"junction\"\nmaterial = \"wire\"\nlength_m = 8.1\nsegments = 4
        [solver]\n{settings}"
    )
}

/// A body on two lines below a top that moves, all of it turned about the vertical.
fn turned_by(angle_deg: f64) -> MotionRun {
    let (sin, cos) = angle_deg.to_radians().sin_cos();
    let at = |x: f64, y: f64, z: f64| {
        format!("[{:?}, {:?}, {z:?}]", cos * x - sin * y, sin * x + cos * y)
    };
    moved(&format!(
        "{WIRE}
        [points.left]\nkind = \"moved\"\nposition_m = {}\namplitude_m = {}\nperiod_s = 8.0\nramp_s = 8.0
        [points.right]\nkind = \"fixed\"\nposition_m = {}
        [points.fore]\nkind = \"body\"\nbody = \"box\"\nposition_m = [3.0, 0.5, 1.0]
        [points.aft]\nkind = \"body\"\nbody = \"box\"\nposition_m = [-3.0, 0.0, 1.0]
        [bodies.box]\nkind = \"free\"\nposition_m = {}\nyaw_deg = {angle_deg:?}\nmass_kg = 1e4\ninertia_kg_m2 = [1e4, 4e4, 4e4]
        volume_m3 = 1.5\nadded_mass = [2e3, 3e3, 4e3, 1e3, 5e3, 5e3]\ndrag_area_m2 = [3.0, 4.0, 6.0]
        [[lines]]\nname = \"left\"\nfrom = \"fore\"\nto = \"left\"\nmaterial = \"wire\"\nlength_m = 41.0\nsegments = 8
        [[lines]]\nname = \"right\"\nfrom = \"aft\"\nto = \"right\"\nmaterial = \"wire\"\nlength_m = 40.0\nsegments = 8
        {}",
        at(6.0, 2.0, 0.0), at(0.6, 0.2, 1.0), at(-6.0, 0.0, 0.0), at(0.0, 0.0, -40.0),
        solver(16.0, 0.02)
    ))
}

#[test]
fn the_heading_of_a_system_changes_no_tension() {
    let straight = turned_by(0.0);
    for angle in [90.0, 137.0, -90.0] {
        let turned = turned_by(angle);
        for name in [
            "tension_n[left|a]",
            "tension_n[right|b]",
            "z_m[box]",
            "pitch_deg[box]",
        ] {
            for (one, other) in channel(&straight, name).iter().zip(channel(&turned, name)) {
                assert!(
                    (one - other).abs() < 1e-6 * (1.0 + one.abs()),
                    "{angle} {name}: {one} {other}"
                );
            }
        }
    }
}

#[test]
fn a_body_on_a_bridle_is_of_second_order_in_time() {
    let runs = [0.04, 0.02, 0.01].map(bridle);
    for name in ["tension_n[lift|b]", "z_m[manifold]", "pitch_deg[manifold]"] {
        let [coarse, middle, fine] = [0, 1, 2].map(|k| channel(&runs[k], name));
        let off = |one: &[f64], other: &[f64]| {
            let each = one.iter().zip(other).map(|(a, b)| (a - b).powi(2));
            each.sum::<f64>().sqrt()
        };
        let order = (off(coarse, middle) / off(middle, fine)).log2();
        assert!((1.8..2.4).contains(&order), "{name}: {order}");
    }
}

#[test]
fn the_energy_of_a_body_on_a_bridle_balances() {
    let drifts = [0.04, 0.02].map(|step| bridle(step).balance.relative_drift());
    assert!(drifts[1] < 1e-3, "{drifts:?}");
    assert!(drifts[1] < 0.4 * drifts[0], "{drifts:?}");
}

/// A body alone in empty space, spinning.
fn spinning(inertia: V3, spin: V3) -> (MovingSystem, SystemState) {
    let network = Network {
        bodies: vec![Body {
            name: "body".to_owned(),
            free: true,
            mass: 1.0,
            inertia: Matrix3::from_diagonal(&inertia),
            ..Body::default()
        }],
        ..Network::default()
    };
    let system = MovingSystem::new(network, Vec::new());
    let mut joints = State::at_rest(vec![V3::zeros(); 2]);
    joints.v[1] = spin;
    let state = SystemState {
        body_flow: Vec::new(),
        flow_loads: Vec::new(),
        velocities: Vec::new(),
        lines: Vec::new(),
        joints,
        bases: vec![UnitQuaternion::identity()],
        attached: Vec::new(),
        kinks_passed_s: 0.0,
        paid: Vec::new(),
        added: Vec::new(),
        surplus: Vec::new(),
        drive_excess: Vec::new(),
    };
    (system, state)
}

fn spin_energy(system: &MovingSystem, state: &SystemState) -> f64 {
    let body = MovingBody::new(&system.network, 0, &Pose::default());
    body.kinetic_energy(&system.body(state, 0))
}

type Spinner = (MovingSystem, SystemState);

/// Steps a spinning body, and calls for every state.
fn spin<M: Stepper<MovingSystem>>(
    (system, state): &mut Spinner,
    method: &mut M,
    (step, steps): (f64, usize),
    mut seen: impl FnMut(&MovingSystem, &SystemState),
) {
    method.restart(system, 0.0, state);
    for k in 0..steps {
        let at = TimeStep {
            t: k as f64 * step,
            dt: step,
            reject: false,
        };
        method.step(system, at, state).unwrap();
        system.commit(at.t + step, step, state);
        seen(system, state);
    }
}

fn alpha((system, state): &Spinner) -> GeneralizedAlpha<SystemState, Border> {
    GeneralizedAlpha::new(system, state, 0.4, 1e-13, 30)
}

/// Greatest change of the energy over 1e5 steps at 200 a turn about the middle axis, which is unstable.
fn lost<M: Stepper<MovingSystem>>(made: impl Fn(&Spinner) -> M) -> f64 {
    let mut spinner = spinning(V3::new(1.0, 2.0, 3.0), V3::new(0.01, 1.0, 0.01));
    let before = spin_energy(&spinner.0, &spinner.1);
    let mut method = made(&spinner);
    let mut worst = 0.0_f64;
    let step = std::f64::consts::TAU / 200.0;
    spin(
        &mut spinner,
        &mut method,
        (step, 100_000),
        |system, state| {
            let norm = state.bases[0].as_ref().norm();
            assert!((norm - 1.0).abs() < 1e-12);
            worst = worst.max((spin_energy(system, state) / before - 1.0).abs());
        },
    );
    worst
}

#[test]
fn a_spinning_body_keeps_its_energy() {
    let by_alpha = lost(alpha);
    assert!(by_alpha < 3e-3, "{by_alpha}");
    let by_rk4 = lost(|(system, state)| Rk4::new(system, state));
    assert!(by_rk4 < 1e-6, "{by_rk4}");
}

/// Where a spinning body points after a time, in this many steps.
fn turned<M: Stepper<MovingSystem>>(
    steps: usize,
    made: impl Fn(&Spinner) -> M,
) -> UnitQuaternion<f64> {
    let mut spinner = spinning(V3::new(1.0, 2.0, 3.0), V3::new(0.6, 0.8, 0.3));
    let mut method = made(&spinner);
    let step = 4.0 / steps as f64;
    spin(&mut spinner, &mut method, (step, steps), |_, _| ());
    spinner.1.bases[0]
}

#[test]
fn rotations_are_of_the_order_of_the_method() {
    let order = |turned: [UnitQuaternion<f64>; 3]| {
        let [coarse, middle, fine] = turned;
        (coarse.angle_to(&middle) / middle.angle_to(&fine)).log2()
    };
    let second = order([100, 200, 400].map(|steps| turned(steps, alpha)));
    assert!((1.9..2.1).contains(&second), "{second}");
    let rk4 = |(system, state): &Spinner| Rk4::new(system, state);
    let fourth = order([20, 40, 80].map(|steps| turned(steps, rk4)));
    assert!((3.8..4.3).contains(&fourth), "{fourth}");
}

#[test]
fn both_methods_move_a_bridle_alike() {
    let implicit = bridle(0.01);
    let explicit = moved(&bridle_of(
        "method = \"rk4\"\nduration_s = 16.0\nerror_estimate = false\n[output]\ninterval_s = 0.25\n",
    ));
    assert!(explicit.work.evaluations > 0 && explicit.work.rejections == 0);
    for name in [
        "tension_n[lift|b]",
        "tension_n[fore|a]",
        "pitch_deg[manifold]",
    ] {
        let (one, other) = (channel(&implicit, name), channel(&explicit, name));
        let size = one.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        for (one, other) in one.iter().zip(other) {
            assert!((one - other).abs() < 2e-3 * size, "{name}: {one} {other}");
        }
    }
}

#[test]
fn an_end_that_is_let_go_falls_and_its_energy_balances() {
    let run = moved(&format!(
        "{WIRE}
        [points.top]\nkind = \"fixed\"\nposition_m = [60.0, 0.0, 0.0]
        [points.bottom]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -50.0]
        [[lines]]\nname = \"one\"\nfrom = \"bottom\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 85.0\nsegments = 20\nrelease_a_s = 2.0
        [solver]\nduration_s = 30.0\nerror_estimate = false\n[output]\ninterval_s = 0.25\n"
    ));
    let (a, b) = (
        channel(&run, "tension_n[one|a]"),
        channel(&run, "tension_n[one|b]"),
    );
    assert!(a[4] > 500.0, "{}", a[4]);
    assert!(a[12..].iter().all(|tension| tension.abs() < 0.05 * b[0]));
    // It hangs straight down in the end, by its weight in water.
    let weight = 85.0 * (20.0 - 1025.0 * 0.25 * std::f64::consts::PI * 0.06 * 0.06) * 9.80665;
    assert!(
        (b.last().unwrap() / weight - 1.0).abs() < 0.02,
        "{:?}",
        b.last()
    );
    assert!(run.balance.relative_drift() < 5e-3, "{:?}", run.balance);
}

/// The end of a vertical tether recoils from its anchor and crumples, segments taut and slack by turns.
#[test]
fn a_tether_that_crumples_gains_no_energy() {
    let run = moved(
        "[environment]\ndrag_length = \"unstretched\"
        [materials.wire]\nmass_kg_per_m = 6.0\ndiameter_m = 0.04\nea_n = 3e7\naxial_damping_n_s = 3e4\ndrag_normal = 1.2\ndrag_tangential = 0.01
        [points.buoy]\nkind = \"free\"\nmass_kg = 1500.0\nvolume_m3 = 4.0\nadded_mass_kg = 2050.0\ndrag_area_m2 = 2.5
        [points.clamp]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -100.0]
        [points.anchor]\nkind = \"fixed\"\nposition_m = [40.0, 0.0, -100.0]
        [[lines]]\nname = \"tether\"\nfrom = \"clamp\"\nto = \"buoy\"\nmaterial = \"wire\"\nlength_m = 40.0\nsegments = 80\nrelease_a_s = 0.5
        [[lines]]\nname = \"guy\"\nfrom = \"anchor\"\nto = \"buoy\"\nmaterial = \"wire\"\nlength_m = 66.0\nsegments = 20
        [solver]\nduration_s = 3.0\nerror_estimate = false\n[output]\ninterval_s = 0.1\n",
    );
    assert!(run.balance.relative_drift() < 5e-3, "{:?}", run.balance);
    assert!(run.work.steps < 10_000, "{}", run.work.steps);
}

#[test]
fn a_moored_body_decays_with_its_natural_period() {
    // Pulled aside by a line that is let go.
    let text = format!(
        "{HEAD}
        [materials.line]\nmass_kg_per_m = 1.0\ndiameter_m = 0.02\nea_n = 2e5
        [bodies.buoy]\nkind = \"free\"\nmass_kg = 5e4\ninertia_kg_m2 = [2e5, 2e5, 2e5]\nvolume_m3 = 60.0
        centre_of_buoyancy_m = [0.0, 0.0, 0.5]\nwaterplane_stiffness = [0.0, 0.0, 0.0, 1e6, 1e6, 0.0]\nposition_m = [0.0, 0.0, -10.0]
        [points.low]\nkind = \"body\"\nbody = \"buoy\"\nposition_m = [0.0, 0.0, 0.0]
        [points.anchor]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -110.0]
        [points.aside]\nkind = \"fixed\"\nposition_m = [102.0, 0.0, -10.0]
        [[lines]]\nname = \"tether\"\nfrom = \"anchor\"\nto = \"low\"\nmaterial = \"line\"\nlength_m = 70.0\nsegments = 10
        [[lines]]\nname = \"tug\"\nfrom = \"aside\"\nto = \"low\"\nmaterial = \"line\"\nlength_m = 100.0\nsegments = 10\nrelease_b_s = 1.0
        {}",
        solver(120.0, 0.05)
    );
    let system = solved(&text);
    let given = system.file.solver.clone().unwrap();
    let run = run(&system, &given, &AtomicBool::new(false), &mut |_| {}).unwrap();
    assert_eq!(run.failure, None);
    // A pendulum upside down: tension over length and mass, that of the tether counted by a third.
    let t = channel(&run, "tension_n[tether|b]");
    let (z, x) = (channel(&run, "z_m[buoy]"), channel(&run, "x_m[buoy]"));
    let n = t.len();
    let mean = |list: &[f64]| list[n / 2..].iter().sum::<f64>() / (n - n / 2) as f64;
    let mass = 5e4 + 70.0 / 3.0;
    let period = std::f64::consts::TAU * (mass * (mean(z) + 110.0) / mean(t)).sqrt();
    let crossings: Vec<f64> = (n / 10..n)
        .filter(|k| x[k - 1] < 0.0 && x[*k] >= 0.0)
        .map(|k| run.history.time[k - 1] - x[k - 1] / (x[k] - x[k - 1]) * 0.25)
        .collect();
    let cycles = (crossings.len() - 1) as f64;
    let found = (crossings.last().unwrap() - crossings[0]) / cycles;
    assert!((found / period - 1.0).abs() < 0.01, "{found} {period}");
}

#[test]
fn a_line_breaks_where_its_tension_comes_to_the_limit() {
    let line = |more: &str| {
        moved(&format!(
            "{WIRE}
            [points.top]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [0.0, 0.0, 2.0]\nperiod_s = 6.0\nramp_s = 6.0
            [points.weight]\nkind = \"free\"\nmass_kg = 2e3\nvolume_m3 = 0.3\ndrag_area_m2 = 1.0
            [[lines]]\nname = \"wire\"\nfrom = \"weight\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 60.0\nsegments = 12\n{more}
            [solver]\nduration_s = 12.0\nerror_estimate = false\n[output]\ninterval_s = 0.1\n"
        ))
    };
    let whole = line("");
    assert!(whole.happened.is_empty());
    let greatest = channel(&whole, "tension_n[wire|b]")
        .iter()
        .copied()
        .fold(0.0, f64::max);
    // Just above the weight of the lower part by what heave adds.
    let broken = line("break_at_m = 20.0\nbreak_n = 2.2e4");
    assert_eq!(broken.happened.len(), 1, "{:?}", broken.happened);
    assert!(broken.happened[0].ends_with("line wire breaks"));
    let time: f64 = broken.happened[0]
        .split(' ')
        .next()
        .unwrap()
        .parse()
        .unwrap();
    let (b, a) = (
        channel(&broken, "tension_n[wire|b]"),
        channel(&broken, "tension_n[wire|a]"),
    );
    // The same until then; after it the top bears what is left of the line, and the weight falls.
    for (k, (whole, broken)) in channel(&whole, "tension_n[wire|b]")
        .iter()
        .zip(b)
        .enumerate()
    {
        if (k as f64) * 0.1 < time - 0.1 {
            assert!(
                (whole - broken).abs() < 2e-3 * greatest,
                "{k} {whole} {broken}"
            );
        }
    }
    assert!(*b.last().unwrap() < 0.5 * greatest);
    assert!(a.last().unwrap().abs() < 0.5 * a[0]);
    assert!(
        broken.balance.relative_drift() < 0.01,
        "{:?}",
        broken.balance
    );
    assert!(
        broken
            .channels
            .iter()
            .all(|c| !c.id.place.contains("break"))
    );
    let by_time = line("break_at_m = 20.0\nbreak_s = 3.0");
    assert_eq!(by_time.happened, ["3.000000 s: line wire breaks"]);
}

/// A line whose top moves as this says.
fn pulled(motion: &str) -> MotionRun {
    moved(&format!(
        "{WIRE}
        [points.top]\nkind = \"moved\"\nposition_m = [60.0, 0.0, 0.0]\n{motion}
        [points.bottom]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -100.0]
        [[lines]]\nname = \"one\"\nfrom = \"bottom\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 130.0\nsegments = 20
        {}",
        solver(16.0, 0.05)
    ))
}

#[test]
fn a_table_of_a_swing_moves_as_the_swing() {
    let swing = pulled("amplitude_m = [0.0, 0.0, 1.5]\nperiod_s = 8.0\nramp_s = 4.0");
    let times: Vec<f64> = (0..=80).map(|k| 0.2 * k as f64).collect();
    let heights: Vec<f64> = times
        .iter()
        .map(|t| 1.5 * (std::f64::consts::TAU * t / 8.0).sin())
        .collect();
    let table = pulled(&format!(
        "table_time_s = {times:?}\ntable_z_m = {heights:?}\nramp_s = 4.0"
    ));
    let (swing, table) = (
        channel(&swing, "tension_n[one|b]"),
        channel(&table, "tension_n[one|b]"),
    );
    for (swing, table) in swing.iter().zip(table) {
        assert!((swing - table).abs() < 2e-3 * swing, "{swing} {table}");
    }
}

#[test]
fn motions_and_breaks_that_do_not_fit_are_refused() {
    let refused = |table: &str, line: &str| {
        refused(&format!(
            "{WIRE}[points.top]\nkind = \"moved\"\nposition_m = [60.0, 0.0, 0.0]\n{table}
            [points.bottom]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -100.0]
            [[lines]]\nname = \"one\"\nfrom = \"bottom\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 130.0\n{line}
            [solver]\nduration_s = 10.0\n"
        ))
    };
    let short = refused("table_time_s = [0.0, 5.0]\ntable_z_m = [0.0, 1.0]", "");
    assert!(
        short.contains("must increase from 0 or before to the end of the run"),
        "{short}"
    );
    let uneven = refused(
        "table_time_s = [0.0, 5.0, 10.0]\ntable_z_m = [0.0, 1.0]",
        "",
    );
    assert!(uneven.contains("another number of rows"), "{uneven}");
    let lost = refused("table_z_m = [0.0, 1.0]", "");
    assert!(lost.contains("table_time_s"), "{lost}");
    let beyond = refused("", "break_at_m = 130.0\nbreak_s = 1.0");
    assert!(
        beyond.contains("lies beyond the line, which is 130 m long"),
        "{beyond}"
    );
    let aged = refused(
        "",
        "break_at_m = 13.0\nbreak_s = 1.0\n[ageing]\nyears = 5.0\n[[ageing.growth]]\nthickness_m = [0.01]",
    );
    assert!(aged.contains("is not covered where lines age"), "{aged}");
    let rod = refused(
        "",
        "[rods.spool]\nkind = \"moved\"\nend_a_m = [0.0, 0.0, -9.0]\nend_b_m = [5.0, 0.0, -9.0]\nmass_kg = 1e3\ndiameter_m = 0.5",
    );
    assert!(rod.contains("is not covered for a rod"), "{rod}");
}

#[test]
fn motion_without_a_run_in_time_is_said_to_have_no_effect() {
    let system = solved(&format!(
        "{HEAD}{WIRE}[points.top]\nkind = \"moved\"\nposition_m = [60.0, 0.0, 0.0]
        [points.bottom]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -100.0]
        [[lines]]\nname = \"one\"\nfrom = \"bottom\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 130.0\nrelease_b_s = 3.0\n"
    ));
    let warnings = seacable::system::warnings::warnings(&system);
    assert!(
        warnings.iter().any(|w| w.starts_with("top does not move")),
        "{warnings:?}"
    );
    assert!(
        warnings
            .iter()
            .any(|w| w.starts_with("Line one is not released")),
        "{warnings:?}"
    );
}

/// Drag slows a light ball in less than a step, which is halved until it is stable; before, it reached 1e81 m/s.
#[test]
fn an_explicit_step_is_halved_where_drag_is_fast() {
    let text = |method: &str| {
        format!(
            "[points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -5.0]
            [points.ball]\nkind = \"free\"\nposition_m = [0.0, 0.0, -15.0]\nmass_kg = 60.0\nvolume_m3 = 0.02\ndrag_area_m2 = 1.5\nstart_velocity_m_per_s = [0.0, 6.0, 0.0]
            [materials.wire]\nmass_kg_per_m = 2.0\ndiameter_m = 0.02\nea_n = 3e2\ndrag_normal = 1.2\naxial_damping_n_s = 10.0
            [[lines]]\nname = \"wire\"\nfrom = \"top\"\nto = \"ball\"\nmaterial = \"wire\"\nlength_m = 10.0\nsegments = 2
            [solver]\nmethod = \"{method}\"\nduration_s = 6.0\ntime_step_s = 0.06\nerror_estimate = false\n[output]\ninterval_s = 0.1\n"
        )
    };
    let explicit = moved(&text("rk4"));
    assert!(explicit.work.rejections > 0);
    let implicit = moved(&text("alpha").replace("0.06", "0.002"));
    let paths = [&explicit, &implicit].map(|run| channel(run, "y_m[ball]"));
    let range = paths[1].iter().fold(0.0_f64, |most, y| most.max(y.abs()));
    for (explicit, implicit) in paths[0].iter().zip(paths[1]) {
        assert!(
            (explicit - implicit).abs() < 1e-2 * range,
            "{explicit} {implicit}"
        );
    }
}
