//! Orders of convergence, in time and in the length of segments: by least squares over at least four steps, and
//! every slope between neighbours besides. Constant drag coefficients, taut throughout, nothing that sets in with
//! a kink: what is measured is the method.

use std::sync::atomic::AtomicBool;

use crate::elastic_catenary::Catenary;
use crate::{lines, march, rest};
use seacable::dynamics::quasi_static::QuasiStatic;
use seacable::dynamics::{Integrator, StepError, Stepper, TimeStep, WorkCounts};
use seacable::run::job::{Request, execute};
use seacable::scene::Scene;
use seacable::solve::{Hysteresis, Marched, State};

/// Slopes of log error over log step: over all by least squares, then between neighbours.
fn slopes(points: &[(f64, f64)]) -> (f64, Vec<f64>) {
    assert!(points.len() >= 4);
    let logs: Vec<(f64, f64)> = points.iter().map(|(h, e)| (h.ln(), e.ln())).collect();
    let n = logs.len() as f64;
    let (mx, my) = logs
        .iter()
        .fold((0.0, 0.0), |m, p| (m.0 + p.0 / n, m.1 + p.1 / n));
    let (above, below) = logs.iter().fold((0.0, 0.0), |s, (x, y)| {
        (s.0 + (x - mx) * (y - my), s.1 + (x - mx) * (x - mx))
    });
    let pairs = logs
        .windows(2)
        .map(|p| (p[1].1 - p[0].1) / (p[1].0 - p[0].0));
    (above / below, pairs.collect())
}

/// Asserts an order over all points, and between each two neighbours.
fn assert_order(what: &str, points: &[(f64, f64)], order: f64, (fit, pair): (f64, f64)) {
    let (slope, pairs) = slopes(points);
    assert!(
        (slope - order).abs() < fit,
        "{what}: order {slope:.3}, {pairs:.3?}, {points:?}"
    );
    for p in &pairs {
        assert!(
            (p - order).abs() < pair,
            "{what}: order {slope:.3}, {pairs:.3?}, {points:?}"
        );
    }
}

/// A payload in a current, swung by its upper end from rest. The motion grows over the whole run, without a kink
/// in its acceleration; the current is faster than anything that moves, so that no drag passes through zero.
const SWUNG: &str = r#"
    environment.water_density_kg_per_m3 = 1025.0
    current.speed_m_per_s = 2.0
    materials.rope = { mass_kg_per_m = 12.0, drag_normal = 1.2, drag_tangential = 0.02, added_mass_normal = 1.0, axial_damping_n_s = 2e4, ea_n = 2e5 }
    line.segments = 5
    ends.a = { kind = "moving", amplitude_m = [1.0, 2.0, 0.5], period_s = 10.0, ramp_s = 20.0 }
    ends.b = { name = "bob", kind = "payload" }
    payload = { dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = 1.0, added_mass_kg = 500.0 }
"#;

const DURATION: f64 = 16.0;

/// The state of the swung line at the end.
fn swung(scene: &Scene, method: impl Stepper<Scene>, step: f64) -> State {
    let mut state = rest::at_rest(scene);
    march::march(method, scene, &mut state, (DURATION, step), |_, s| {
        for i in 0..scene.line.segments.len() {
            assert!(
                scene.line.segments[i]
                    .axial
                    .tension(&scene.line.chord(i, s))
                    .value
                    > 0.0
            );
        }
    });
    state
}

/// Greatest difference of two states in position [m] and velocity [m/s].
fn apart(a: &State, b: &State) -> f64 {
    let pairs = a.x.iter().chain(&a.v).zip(b.x.iter().chain(&b.v));
    pairs.map(|(p, q)| (p - q).norm()).fold(0.0, f64::max)
}

/// Steps of `longest`, halved so many times, against the error of each.
fn points(longest: f64, count: u32, error: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    (0..count)
        .map(|k| longest * 0.5_f64.powi(k as i32))
        .map(|h| (h, error(h)))
        .collect()
}

#[test]
fn runge_kutta_is_of_order_four() {
    let scene = rest::build(SWUNG);
    let exact = swung(&scene, march::rk4(&scene), 0.001);
    let error = |h| apart(&swung(&scene, march::rk4(&scene), h), &exact);
    assert_order("rk4", &points(0.064, 4, error), 4.0, (0.1, 0.2));
}

#[test]
fn generalized_alpha_is_of_order_two_at_every_rho() {
    let scene = rest::build(SWUNG);
    let exact = swung(&scene, march::rk4(&scene), 0.004);
    for rho in [0.0, 0.4, 0.8, 1.0] {
        let error = |h| apart(&swung(&scene, march::alpha(&scene, rho), h), &exact);
        assert_order(
            &format!("rho = {rho}"),
            &points(0.064, 5, error),
            2.0,
            (0.1, 0.2),
        );
    }
}

/// The swung line of a rope that creeps, by both models.
fn swung_of_fibre(model: &str) -> Scene {
    let slow = match model {
        "viscoelastic" => "ea_n = 1e5",
        _ => {
            "strain = [0.0, 0.02, 0.06, 0.2, 0.4], tension_n = [0.0, 1.5e3, 5e3, 1.9e4, 4e4], ea_n = \"\", \
             permanent_strain_ratio = 0.2, working_curve = \"quadratic\", working_curve_shape = 0.3, past_tension_n = 1.5e4"
        }
    };
    let creep = format!(
        "{slow}, creep_model = \"{model}\", dynamic_ea_n = 2e5, dynamic_ea_per_tension = 2.0, slow_damping_n_s = 8e5, \
         fast_damping_n_s = 2e4"
    );
    rest::build(&SWUNG.replace("axial_damping_n_s = 2e4, ea_n = 2e5", &creep))
}

#[test]
fn ropes_that_creep_keep_the_order_of_the_method() {
    for model in ["viscoelastic", "syrope"] {
        let scene = swung_of_fibre(model);
        let exact = swung(&scene, march::rk4(&scene), 0.001);
        let mean = |state: &State| {
            state
                .memory
                .creep
                .iter()
                .map(|rope| rope.mean)
                .collect::<Vec<_>>()
        };
        let known = mean(&exact);
        let apart = |state: &State| {
            let means = mean(state)
                .into_iter()
                .zip(&known)
                .map(|(a, b)| (a - b).abs());
            means.fold(apart(state, &exact), f64::max)
        };
        let error = |h| apart(&swung(&scene, march::rk4(&scene), h));
        assert_order(model, &points(0.064, 4, error), 4.0, (0.2, 0.4));
        for rho in [0.4, 0.8] {
            let error = |h| apart(&swung(&scene, march::alpha(&scene, rho), h));
            let what = format!("{model}, rho = {rho}");
            assert_order(&what, &points(0.064, 4, error), 2.0, (0.1, 0.2));
        }
    }
}

/// Tensions at nodes take the inertia of half segments into account: the acceleration of the state too is of order two.
#[test]
fn tensions_at_nodes_are_of_order_two() {
    let scene = rest::build(SWUNG);
    let exact = scene.tensions(&swung(&scene, march::rk4(&scene), 0.004));
    for rho in [0.0, 0.4, 0.8] {
        let error = |h| {
            let found = scene.tensions(&swung(&scene, march::alpha(&scene, rho), h));
            let apart = found.iter().zip(&exact).map(|(a, b)| (a - b).abs());
            apart.fold(0.0, f64::max)
        };
        assert_order("tension", &points(0.064, 5, error), 2.0, (0.1, 0.2));
    }
}

/// Every step in two parts, one twice as long as the other.
struct Uneven<M>(M);

impl<S: Marched, M: Stepper<S>> Stepper<S> for Uneven<M> {
    fn step(&mut self, system: &S, at: TimeStep, state: &mut S::State) -> Result<f64, StepError> {
        let third = at.dt / 3.0;
        self.0.step(system, TimeStep { dt: third, ..at }, state)?;
        let rest = TimeStep {
            t: at.t + third,
            dt: 2.0 * third,
            ..at
        };
        self.0.step(system, rest, state)
    }
    fn restart(&mut self, system: &S, t: f64, state: &mut S::State) {
        self.0.restart(system, t, state);
    }
    fn pass_kink(&mut self, system: &S, t: f64, state: &mut S::State) -> bool {
        self.0.pass_kink(system, t, state)
    }
}

impl<M: Integrator> Integrator for Uneven<M> {
    fn work_counts(&self) -> WorkCounts {
        self.0.work_counts()
    }
}

/// The carried acceleration stands for the true one at another place in a step of another length.
#[test]
fn steps_of_changing_length_keep_the_order() {
    let scene = rest::build(SWUNG);
    let exact = swung(&scene, march::rk4(&scene), 0.004);
    for rho in [0.0, 0.4, 0.8] {
        let error = |h| apart(&swung(&scene, Uneven(march::alpha(&scene, rho)), h), &exact);
        assert_order(
            &format!("uneven, rho = {rho}"),
            &points(0.064, 5, error),
            2.0,
            (0.1, 0.2),
        );
    }
    let quasi = || Uneven(QuasiStatic::new(&scene, &scene.initial_state(), 1e-12, 40));
    let exact = swung(&scene, quasi(), 0.002);
    let error = |h| apart(&swung(&scene, quasi(), h), &exact);
    assert_order("uneven, quasi", &points(0.5, 5, error), 2.0, (0.1, 0.25));
}

#[test]
fn the_quasi_static_march_is_of_order_two() {
    let scene = rest::build(SWUNG);
    let quasi = || QuasiStatic::new(&scene, &scene.initial_state(), 1e-12, 40);
    let exact = swung(&scene, quasi(), 0.002);
    let error = |h| apart(&swung(&scene, quasi(), h), &exact);
    assert_order("quasi", &points(0.5, 5, error), 2.0, (0.1, 0.25));
}

/// Node positions and tensions against the closed form; the greatest error of all nodes.
#[test]
fn a_hanging_line_meets_the_catenary_to_order_two_in_segment_length() {
    let exact = Catenary::between(100.0, 2.0 * 9.80665, 1e6, 70.0, -30.0);
    let mut shape = Vec::new();
    let mut tension = Vec::new();
    for n in [8, 16, 32, 64, 128] {
        let scene = rest::build(&format!(
            r#"
            line.segments = {n}
            ends.b = {{ name = "post", kind = "fixed", position_m = [70.0, 0.0, -30.0] }}
            "#
        ));
        let state = rest::at_rest(&scene);
        let off = |i: usize| {
            let (x, z) = exact.at(scene.line.arc[i]);
            (state.x[i].x - x).hypot(state.x[i].z - z)
        };
        let pull =
            |i: usize| (scene.tension_at(i, &state) - exact.tension(scene.line.arc[i])).abs();
        shape.push((100.0 / n as f64, (0..=n).map(off).fold(0.0, f64::max)));
        tension.push((100.0 / n as f64, (0..=n).map(pull).fold(0.0, f64::max)));
    }
    assert_order("shape", &shape, 2.0, (0.05, 0.1));
    assert_order("tension", &tension, 2.0, (0.05, 0.1));
}

/// No closed form here: the change from one mesh to the next finer one falls with the same order.
#[test]
fn a_line_in_a_current_converges_to_order_two_in_segment_length() {
    let solve = |n: usize| {
        let scene = rest::build(&format!(
            r#"
            environment.water_density_kg_per_m3 = 1025.0
            current = {{ speed_m_per_s = [1.5, 0.3], direction_deg = [0.0, 90.0], depth_m = [0.0, 120.0] }}
            materials.rope = {{ mass_kg_per_m = 12.0, drag_normal = 1.2, drag_tangential = 0.02 }}
            line.segments = {n}
            ends.b = {{ name = "bob", kind = "payload" }}
            payload = {{ dry_mass_kg = 200.0, wet_mass_kg = 100.0, drag_area_m2 = 1.0, added_mass_kg = 0.0 }}
            "#
        ));
        let state = rest::at_rest(&scene);
        let nodes: Vec<_> = (0..=8)
            .map(|k| (state.x[k * n / 8], scene.tension_at(k * n / 8, &state)))
            .collect();
        nodes
    };
    let meshes = [8, 16, 32, 64, 128, 256];
    let solved: Vec<_> = meshes.iter().map(|n| solve(*n)).collect();
    let change = |of: &dyn Fn(usize, usize) -> f64| -> Vec<(f64, f64)> {
        let worst = |k: usize| (0..=8).map(|i| of(k, i)).fold(0.0, f64::max);
        (0..meshes.len() - 1)
            .map(|k| (100.0 / meshes[k] as f64, worst(k)))
            .collect()
    };
    let shape = change(&|k, i| (solved[k][i].0 - solved[k + 1][i].0).norm());
    let tension = change(&|k, i| (solved[k][i].1 - solved[k + 1][i].1).abs());
    assert_order("shape", &shape, 2.0, (0.05, 0.1));
    assert_order("tension", &tension, 2.0, (0.05, 0.1));
}

/// An end that travels ten metres and more: the state of the line at the end of its way, by the length of its segments.
#[test]
fn a_line_behind_a_travelling_end_converges_to_order_two_in_segment_length() {
    let travelled = |n: usize| {
        let scene = rest::build(&format!(
            r#"
            environment.water_density_kg_per_m3 = 1025.0
            current.speed_m_per_s = 2.0
            materials.rope = {{ mass_kg_per_m = 12.0, drag_normal = 1.2, drag_tangential = 0.02, added_mass_normal = 1.0, axial_damping_n_s = 2e4, ea_n = 2e5 }}
            line.segments = {n}
            ends.a = {{ kind = "moving", amplitude_m = [-20.0, 6.0, 8.0], period_s = 40.0, ramp_s = 20.0 }}
            ends.b = {{ name = "bob", kind = "payload" }}
            payload = {{ dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = 1.0, added_mass_kg = 500.0 }}
            "#
        ));
        let mut state = rest::at_rest(&scene);
        let start = state.x[0];
        march::march(
            march::alpha(&scene, 0.8),
            &scene,
            &mut state,
            (DURATION, 0.01),
            |_, _| {},
        );
        assert!((state.x[0] - start).norm() > 10.0);
        let places = (0..=4).map(|k| k * n / 4);
        let tension = |i: usize| scene.tension_at(i, &state);
        places.map(|i| (state.x[i], tension(i))).collect::<Vec<_>>()
    };
    let meshes = [32, 64, 128, 256, 512];
    let solved = meshes.map(travelled);
    let change = |of: &dyn Fn(usize, usize) -> f64| -> Vec<(f64, f64)> {
        let worst = |k: usize| (0..=4).map(|i| of(k, i)).fold(0.0, f64::max);
        (0..meshes.len() - 1)
            .map(|k| (100.0 / meshes[k] as f64, worst(k)))
            .collect()
    };
    let place = change(&|k, i| (solved[k][i].0 - solved[k + 1][i].0).norm());
    let tension = change(&|k, i| (solved[k][i].1 - solved[k + 1][i].1).abs());
    assert_order("place", &place, 2.0, (0.1, 0.2));
    assert_order("tension", &tension, 2.0, (0.1, 0.2));
}

/// A body that the bed bears throughout, heaved by its rope and rocking on the bed's spring: contact without a kink.
const BORNE: &str = r#"
    environment.water_density_kg_per_m3 = 0.0
    materials.rope = { diameter_m = 0.02, mass_kg_per_m = 1.0, ea_n = 2.5e4, axial_damping_n_s = 500.0 }
    line = { length_m = 30.0, segments = 4 }
    ends.a = { kind = "moving", position_m = [0.0, 0.0, 5.0], amplitude_m = [0.0, 0.0, 2.4], period_s = 5.0, ramp_s = 10.0 }
    ends.b = { name = "body", kind = "payload" }
    payload = { dry_mass_kg = 1000.0, wet_mass_kg = 1000.0, drag_area_m2 = 0.0, added_mass_kg = 0.0, bed_area_m2 = 2.0, bottom_m = 1.0 }
    seabed = { depth_m = 30.0, stiffness_n_per_m3 = 1e5, damping_n_s_per_m3 = 2e3 }
"#;

/// The state of the borne body at the end.
fn borne(scene: &Scene, method: impl Stepper<Scene>, step: f64) -> State {
    let mut state = rest::at_rest(scene);
    Hysteresis::commit(scene, 0.0, 0.0, &mut state);
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    march::march(method, scene, &mut state, (8.0, step), |_, s| {
        let force = scene.bed_force_at(scene.line_nodes() - 1, s);
        (least, most) = (least.min(force), most.max(force));
        assert!(scene.tension_at(0, s) > 100.0);
    });
    assert!(least > 1e3 && most > 1.5 * least, "{least} {most}");
    state
}

#[test]
fn a_body_in_contact_keeps_the_order_in_time() {
    let scene = rest::build(BORNE);
    let exact = borne(&scene, march::rk4(&scene), 0.0002);
    let rk4 = points(0.008, 4, |h| {
        apart(&borne(&scene, march::rk4(&scene), h), &exact)
    });
    assert_order("rk4", &rk4, 4.0, (0.1, 0.2));
    for rho in [0.0, 0.4, 0.8] {
        let error = |h| apart(&borne(&scene, march::alpha(&scene, rho), h), &exact);
        let what = format!("contact, rho = {rho}");
        assert_order(&what, &points(0.016, 5, error), 2.0, (0.1, 0.2));
    }
}

/// What is written between steps lies on a parabola through three of them: of order three, by the known motion of an end.
#[test]
fn output_between_steps_is_of_order_three() {
    let error = |step: f64| {
        let case = lines::line(&format!(
            r#"
            environment.water_density_kg_per_m3 = 1025.0
            materials.rope = {{ mass_kg_per_m = 12.0, drag_normal = 1.2 }}
            ends.a = {{ kind = "moving", amplitude_m = [0.0, 0.0, 1.5], period_s = 8.0 }}
            solver = {{ method = "alpha", duration_s = 24.0, time_step_s = {step:?} }}
            output.interval_s = 0.0173
            "#
        ));
        let request = Request {
            case,
            text: String::new(),
            file: "test.toml".to_owned(),
            overrides: Vec::new(),
            id: "test".to_owned(),
        };
        let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
        let heights = &run.history.channel("z_m[top]").unwrap().values;
        let known = |t: &f64| 1.5 * (std::f64::consts::TAU * t / 8.0).sin();
        let pairs = run.history.time.iter().zip(heights);
        pairs.map(|(t, z)| (z - known(t)).abs()).fold(0.0, f64::max)
    };
    assert_order("rows", &points(0.4, 5, error), 3.0, (0.1, 0.2));
}
