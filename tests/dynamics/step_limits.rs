//! Steps that are too long: refused before the run where the limit is known, halved and counted where a step fails,
//! and given up in words that name time and node.

use crate::lines;
use std::sync::atomic::AtomicBool;

use crate::march::{alpha, march, rk4};
use crate::rest::{at_rest, build};
use seacable::case::{self, Case};
use seacable::dynamics::{Integrator, March, StepError, Stepper, TimeStep, WorkCounts};
use seacable::numerics::V3;
use seacable::run::job::{Request, execute};
use seacable::run::{Run, RunState};
use seacable::solve::{AcceptedStep, Marched, NewtonError, Progressing, State};

fn run(changes: &str) -> Run {
    computed(lines::line(changes))
}

fn computed(case: Case) -> Run {
    let request = Request {
        case,
        text: String::new(),
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    execute(&request, &AtomicBool::new(false), &mut |_| {})
}

/// Rope and wire; the wire's short segments set the limit: between two nodes of 10 kg, or 10 and 7.5 kg.
const TWO_PARTS: &str = r#"
    materials.wire = { diameter_m = 0.05, mass_kg_per_m = 5.0, ea_n = 1e8, added_mass_normal = 0.0 }
    line = [
        { name = "rope", material = "rope", length_m = 100.0, segments = 10 },
        { name = "wire", material = "wire", length_m = 6.0, segments = 3 },
    ]
    solver = { method = "rk4", duration_s = 1.0, time_step_s = 0.01 }
"#;

/// `omega² = 2 EA/l (1/m1 + 1/m2)`; the last node carries half a segment, 5 kg, its neighbour 10 kg.
#[test]
fn a_step_above_the_stability_limit_is_refused_with_the_limit_and_its_place() {
    let run = run(TWO_PARTS);
    let omega = f64::sqrt(2.0 * 1e8 / 2.0 * (1.0 / 5.0 + 1.0 / 10.0));
    let limit = 2.785 / omega;
    assert_eq!(run.info.state, RunState::Failed);
    assert_eq!(
        run.info.failure.unwrap(),
        format!(
            "time step 0.01 s is above the stability limit of RK4, {limit:.3e} s, set by segment 12 (wire); \
             choose a smaller step, leave it open, or use the solver `alpha`"
        )
    );
    assert_eq!(run.info.work.steps, 0);
    assert!((run.info.settings.stability_limit_s.unwrap() / limit - 1.0).abs() < 1e-12);
}

/// Left open, the step is below the limit, with room for the companion that takes twice as long ones.
#[test]
fn a_step_left_open_is_stable_and_so_is_twice_that() {
    let run = run(&TWO_PARTS.replace(", time_step_s = 0.01", ", error_estimate = true"));
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    let settings = run.info.settings;
    assert!(settings.time_step_automatic);
    assert!(2.0 * settings.time_step_s < settings.stability_limit_s.unwrap());
    assert!(
        run.summary.iter().any(|q| q.time_error.is_some()),
        "{:?}",
        run.info.warnings
    );
}

/// A uniform line without damping bears the limit and no more; with damping the given limit is on the safe side.
/// Generalized-alpha bears ten times the limit.
#[test]
fn the_stability_limit_is_one() {
    for damping in [0.0, 0.05, 0.3] {
        let scene = build(&format!(
            r#"
            line.segments = 40
            materials.rope.axial_damping_ratio = {damping:?}
            ends.b = {{ name = "bob", kind = "payload" }}
            payload = {{ dry_mass_kg = 1000.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }}
            "#
        ));
        let limit = scene.explicit_limit().0;
        let start = || {
            let mut state = at_rest(&scene);
            // The highest mode, neighbours against each other, just taut.
            for (i, v) in state.v.iter_mut().enumerate().skip(1) {
                v.z = if i % 2 == 0 { 0.01 } else { -0.01 };
            }
            state
        };
        let fastest = |state: &State| state.v.iter().map(V3::norm).fold(0.0, f64::max);
        let explicit = |share: f64| {
            let (mut state, mut method, dt) = (start(), rk4(&scene), share * limit);
            for k in 0..600 {
                let t = f64::from(k) * dt;
                method
                    .step(
                        &scene,
                        TimeStep {
                            t,
                            dt,
                            reject: false,
                        },
                        &mut state,
                    )
                    .unwrap();
            }
            fastest(&state)
        };
        let mut implicit = start();
        march(
            alpha(&scene, 0.4),
            &scene,
            &mut implicit,
            (600.0 * limit, 10.0 * limit),
            |_, _| (),
        );
        assert!(
            explicit(0.99) < 0.01,
            "damping {damping}: {}",
            explicit(0.99)
        );
        assert!(damping > 0.0 || explicit(1.05) > 1.0, "{}", explicit(1.05));
        assert!(
            fastest(&implicit) < 0.01,
            "damping {damping}: {}",
            fastest(&implicit)
        );
    }
}

/// A payload that falls fast through water on a soft line: its drag decays faster than steps made for the line can
/// follow. Such steps are refused as it speeds up, and it falls no faster than its weight drives it.
#[test]
fn runge_kutta_halves_its_steps_where_drag_decays_fast() {
    let run = run(r#"
        environment.water_density_kg_per_m3 = 1025.0
        materials.rope.ea_n = 1e4
        line.segments = 4
        ends.b = { name = "bob", kind = "payload" }
        payload = { dry_mass_kg = 1.0, wet_mass_kg = 0.0, drag_area_m2 = 50.0, added_mass_kg = 0.0 }
        start = { shape = "straight", elevation_deg = 20.0 }
        solver = { method = "rk4", duration_s = 20.0 }
        "#);
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    assert!(run.info.work.rejections > 0);
    // Driven by the lift of the rope, 8.05 kg/m of water less 2 kg/m; the soft rope bounces on top of that.
    let fastest = f64::sqrt((8.05 - 2.0) * 100.0 * 9.80665 / (0.5 * 1025.0 * 50.0));
    let speed = run.history.channel("speed_m_per_s[bob]").unwrap().peak.0;

    assert!(speed < 1.5 * fastest, "{speed} m/s, {fastest} m/s");
}

/// A slack line that nothing slows along itself: without inertia its equations have roots hundreds of kilometres away,
/// which are not where it goes.
#[test]
fn a_quasi_static_line_is_not_let_astray() {
    let run = run(r#"
        environment.water_density_kg_per_m3 = 1025.0
        materials.rope = { ea_n = 1e9, diameter_m = 0.2, mass_kg_per_m = 3.0, drag_normal = 1.2, added_mass_normal = 1.0 }
        line = { length_m = 374.5, segments = 11 }
        ends.b = { name = "bob", kind = "payload" }
        payload = { dry_mass_kg = 4878.0, wet_mass_kg = -2738.0, drag_area_m2 = 79.0, added_mass_kg = 0.0 }
        start = { shape = "straight", azimuth_deg = -131.6, elevation_deg = -1.1 }
        solver = { method = "quasi", duration_s = 10.0 }
        "#);
    let far = run
        .profile()
        .nodes
        .iter()
        .flatten()
        .fold(0.0, |far: f64, x| far.max(x.abs()));
    match run.info.state {
        RunState::Done => assert!(far < 400.0, "{far} m"),
        _ => assert!(
            run.info
                .failure
                .unwrap()
                .contains("too little slows it along the line")
        ),
    }
}

/// A method that can take steps up to some length, from time to time.
struct Choosy {
    longest: f64,
    share: f64,
    taken: Vec<(f64, f64)>,
}

impl<S: Marched> Stepper<S> for Choosy {
    fn step(&mut self, _: &S, at: TimeStep, _: &mut S::State) -> Result<f64, StepError> {
        if at.dt > self.longest {
            return Err(NewtonError::NotConverged {
                iterations: 9,
                node: 4,
                moved: 0.5,
            }
            .into());
        }
        self.taken.push((at.t, at.dt));
        Ok(self.share)
    }
    fn restart(&mut self, _system: &S, _t: f64, _state: &mut S::State) {}
    fn pass_kink(&mut self, _system: &S, _t: f64, _state: &mut S::State) -> bool {
        false
    }
}

impl Integrator for Choosy {
    fn work_counts(&self) -> WorkCounts {
        WorkCounts::default()
    }
}

#[test]
fn a_step_that_fails_is_halved_and_counted() {
    let scene = build("");
    let mut state = scene.initial_state();
    let mut method = Choosy {
        longest: 0.3,
        share: 0.5,
        taken: Vec::new(),
    };
    let march = March {
        duration: 4.0,
        step: 1.0,
    };
    let mut outputs = Vec::new();
    let outcome = march
        .run(&mut method, &scene, &mut state, &mut |i: AcceptedStep<
            '_,
        >| {
            if i.whole {
                outputs.push(i.time);
            }
            Progressing::Continue
        })
        .unwrap();
    // Halved twice, and kept so: with an error of half of what is allowed there is no room for longer steps.
    assert_eq!((outcome.steps, outcome.rejections), (16, 2));
    assert_eq!(outputs, [0.0, 1.0, 2.0, 3.0, 4.0]);
    let quarters: Vec<(f64, f64)> = (0..16).map(|k| (0.25 * f64::from(k), 0.25)).collect();
    assert_eq!(method.taken, quarters);
}

#[test]
fn a_step_that_fails_at_every_length_ends_the_march_with_time_and_node() {
    let scene = build("");
    let mut state = scene.initial_state();
    let mut method = Choosy {
        longest: 0.0,
        share: 0.5,
        taken: Vec::new(),
    };
    let march = March {
        duration: 4.0,
        step: 1.0,
    };
    let error = march
        .run(&mut method, &scene, &mut state, &mut |_: AcceptedStep<
            '_,
        >| {
            Progressing::Continue
        })
        .unwrap_err();
    assert_eq!((error.steps, error.rejections, error.time), (0, 15, 0.0));
    assert_eq!(error.step, 0.5_f64.powi(14));
    let message = error.to_string();
    assert!(
        message.starts_with("at t = 0.000000 s, node 4: Newton did not converge"),
        "{message}"
    );
}

/// A line that comes taut with a jerk, and too few iterations for it.
#[test]
fn a_real_step_that_fails_is_halved_and_the_run_continues() {
    let snap = r#"
        ends.b = { name = "bob", kind = "payload" }
        payload = { dry_mass_kg = 1000.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }
        start = { shape = "straight", elevation_deg = -20.0 }
        solver = { method = "alpha", duration_s = 10.0, time_step_s = 0.1, max_iterations = 4 }
    "#;
    let run = run(snap);
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    let work = run.info.work;
    assert!(work.rejections > 0 && work.steps > 100, "{work:?}");
    assert_eq!(run.history.time.len(), 21);
    let times: Vec<f64> = (0..=20).map(|k| 0.5 * f64::from(k)).collect();
    for (a, b) in run.history.time.iter().zip(&times) {
        assert!((a - b).abs() < 1e-12);
    }
}

/// A weight that bounces on its rope once in 0.4 s, its top moved once in a second; the tension there: last, greatest and
/// smallest value, each with its error, and the values over the last bounce.
fn bounce(solver: &str) -> ([(f64, f64); 3], Vec<f64>) {
    let run = run(&format!(
        r#"
        materials.rope.ea_n = 5.0e6
        materials.rope.wet_weight_kg_per_m = 2.0
        ends.a = {{ name = "top", kind = "moving", position_m = [0.0, 0.0, 0.0], amplitude_m = [0.0, 0.0, 0.02], period_s = 1.0, ramp_s = 2.0 }}
        ends.b = {{ name = "bob", kind = "payload" }}
        payload = {{ dry_mass_kg = 200.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }}
        solver = {{ duration_s = 6.0, error_estimate = true, {solver} }}
        output.interval_s = 0.05
        "#
    ));
    let numbers = ["final", "max", "min"].map(|statistic| {
        let name = format!("tension_n[top|rope].{statistic}");
        let reported = run.summary.iter().find(|q| q.name() == name).unwrap();
        (reported.value, reported.time_error.unwrap())
    });
    let values = &run.history.channel("tension_n[top|rope]").unwrap().values;
    (numbers, values[values.len() - 8..].to_vec())
}

/// The greatest difference of two records.
fn farthest(a: &[f64], b: &[f64]) -> f64 {
    let apart = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    apart.fold(0.0, f64::max)
}

/// Neither the output interval nor the duration is a multiple of the step or of twice the step, and yet what the steps are off
/// by is stated, with a factor of safety. A companion with fewer than sixteen steps a period is too coarse to show the order: the coarsest has steps
/// nine times as long.
#[test]
fn the_time_error_is_estimated_at_any_step() {
    let (fine, fine_bounce) = bounce("time_step_s = 0.0005");
    assert!(fine.iter().all(|(_, error)| *error < 0.1), "{fine:?}");
    for solver in [
        "time_step_s = 0.0065",
        "time_step_s = 0.0027",
        "step_tolerance = 1e-4",
    ] {
        // The last instant may come out well by chance, the last bounce does not.
        let (coarse, last_bounce) = bounce(solver);
        let error: f64 = coarse.iter().map(|(_, error)| error).sum();
        let extremes = coarse[1..].iter().zip(&fine[1..]);
        let off: f64 = extremes.map(|(a, b)| (a.0 - b.0).abs()).sum();
        let off = off + farthest(&last_bounce, &fine_bounce);
        assert!(
            error > off && error < 12.0 * off,
            "{solver}: {error} N estimated, {off} N off"
        );
    }
}

/// A heavy module let go at the end of a slack line: at a first step far too long Newton strays by kilometres before it fails. The
/// rate of convergence measured there once let every later step stop after one iteration, decimetres from balance: 6.4 MN and
/// 37 steps a second at one tolerance, 1.7 MN at the next.
#[test]
fn a_first_step_far_too_long_spoils_none_of_the_others() {
    let greatest = ["2e-5", "5e-7"].map(|tolerance| {
        let text = LOWERING.replace("TOLERANCE", tolerance);
        let run = computed(case::parse(&text, "test.toml").unwrap());
        assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
        run.quantity("tension_n.max").unwrap().value
    });
    assert!(
        (greatest[0] / greatest[1] - 1.0).abs() < 1e-3,
        "{greatest:?}"
    );
}

const LOWERING: &str = r#"
case.title = "lowering"
environment = { water_density_kg_per_m3 = 1025.0, kinematic_viscosity_m2_per_s = 1.33e-6 }
current.speed_m_per_s = 0.2
materials.chain = { diameter_m = 0.105, mass_kg_per_m = 222.8, wet_weight_kg_per_m = 193.8, ea_n = 9.4e8, axial_damping_n_s = 8.34e4, drag_normal = "jia-2019-normal", drag_tangential = "jia-2019-tangential", added_mass_normal = 1.0 }
materials.polyester = { diameter_m = 0.21, mass_kg_per_m = 28.8, wet_weight_kg_per_m = 7.4, ea_n = 33000000.000000004, axial_damping_n_s = 3.98e4, drag_normal = "jia-2019-normal", drag_tangential = "jia-2019-tangential", added_mass_normal = 1.0 }
materials.wire = { diameter_m = 0.127, mass_kg_per_m = 58.0, wet_weight_kg_per_m = 44.7, ea_n = 6.2e8, axial_damping_n_s = 8.34e4, drag_normal = "jia-2019-normal", drag_tangential = "jia-2019-tangential", added_mass_normal = 1.0 }
line = [
    { name = "chain", material = "chain", length_m = 30.0, segments = 2 },
    { name = "polyester", material = "polyester", length_m = 1326.0, segments = 53 },
    { name = "wire", material = "wire", length_m = 44.0, segments = 2 },
]
floats = [{ section = "wire", lift_kg = 26600.0, mass_kg = 0.0, drag_area_m2 = 7.0, added_mass_kg = 0.0 }]
ends.a = { name = "vessel", kind = "fixed", position_m = [0.0, 0.0, 0.0] }
ends.b = { name = "module", kind = "payload" }
payload = { dry_mass_kg = 469e3, volume_m3 = 66.6, drag_area_m2 = 1.47, added_mass_kg = [7e4, 7e4, 4.03e5] }
start = { shape = "straight", azimuth_deg = 0.0, elevation_deg = -2.0 }
[solver]
method = "alpha"
rho_inf = 0.0
step_tolerance = TOLERANCE
duration_s = 8.0
error_estimate = false
[output]
interval_s = 0.1
"#;
