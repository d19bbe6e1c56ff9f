//! Ends that move along a table by each interpolation: closed forms, kinks that steps end at, orders of convergence, and the same
//! bits resumed.

use std::sync::atomic::AtomicBool;

use crate::march::{alpha, rk4};
use crate::{lines, rest};
use seacable::case;
use seacable::dynamics::quasi_static::QuasiStatic;
use seacable::dynamics::{March, Stepper};
use seacable::numerics::V3;
use seacable::run::job::{Request, execute};
use seacable::run::{Run, RunState};
use seacable::scene::Scene;
use seacable::solve::{AcceptedStep, ExplicitRhs, Progressing, State};

const INTERPOLATIONS: [&str; 3] = ["spline", "monotone", "linear"];

/// Held, raised by 2 m from 1.3 s to 3.1 s, held.
const RAMP_AND_HOLD: &str = "0,0,0,0\n0.6,0,0,0\n1.3,0,0,0\n3.1,0,0,2\n4,0,0,2\n20,0,0,2";

/// A body on a segment without mass to speak of, hung from an end that moves: `m x'' = -k (x - u) - c (x' - u')`.
fn oscillator(interpolation: &str, rows: &str) -> String {
    format!(
        r#"
        materials.rope = {{ mass_kg_per_m = 1e-9, ea_n = 4e4, axial_damping_n_s = 6e3 }}
        line = {{ length_m = 10.0, segments = 1 }}
        ends.a = {{ kind = "moving", motion = "table", motion_file = "p.csv", motion_interpolation = "{interpolation}" }}
        ends.b = {{ kind = "payload" }}
        payload = {{ dry_mass_kg = 1000.0, wet_mass_kg = 1000.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }}
        solver.duration_s = 6.0
        files."p.csv".text = "time_s,x_m,y_m,z_m\n{}"
        "#,
        rows.replace('\n', "\\n")
    )
}

/// Response of the oscillator to a ramp from t0 to t1 with slope s, relative to rest: by the step response of the velocity,
/// in closed form. With z the relative motion of the body, `z'' + 2 d z' + w² z = -u''`.
fn linear_response(t: f64) -> f64 {
    let (w2, d) = (4.0, 0.3);
    let damped = f64::sqrt(w2 - d * d);
    // An impulse -s of u' starts z with the velocity -s.
    let impulse = |s: f64, t: f64| {
        if t > 0.0 {
            -s * (-d * t).exp() * (damped * t).sin() / damped
        } else {
            0.0
        }
    };
    let slope = 2.0 / 1.8;
    let u = slope * (t - 1.3).clamp(0.0, 1.8);
    u + impulse(slope, t - 1.3) + impulse(-slope, t - 3.1)
}

/// Marches from rest; the state at the end, and the times of the steps.
fn marched(
    mut method: impl Stepper<Scene>,
    scene: &Scene,
    (duration, step): (f64, f64),
) -> (State, Vec<f64>) {
    let mut state = rest::at_rest(scene);
    scene.accelerate(0.0, &mut state);
    let mut times = Vec::new();
    let march = March { duration, step };
    march
        .run(&mut method, scene, &mut state, &mut |i: AcceptedStep<
            '_,
        >| {
            times.push(i.time);
            Progressing::Continue
        })
        .unwrap();
    (state, times)
}

/// Rise of the body from rest to 6 s.
fn rise(scene: &Scene, method: impl Stepper<Scene>, step: f64) -> f64 {
    let start = rest::at_rest(scene).x[1].z;
    marched(method, scene, (6.0, step)).0.x[1].z - start
}

fn orders(errors: &[f64]) -> Vec<f64> {
    errors.windows(2).map(|e| (e[0] / e[1]).log2()).collect()
}

#[test]
fn a_linear_ramp_has_its_closed_form_at_the_order_of_every_method() {
    let scene = rest::build(&oscillator("linear", RAMP_AND_HOLD));
    let exact = linear_response(6.0);
    let steps = [0.16, 0.08, 0.04, 0.02];
    let runge_kutta = steps.map(|h| (rise(&scene, rk4(&scene), 0.5 * h) - exact).abs());
    assert!(runge_kutta[3] < 5e-9, "{runge_kutta:?}");
    assert!(
        orders(&runge_kutta).iter().all(|p| *p > 3.5),
        "{runge_kutta:?}"
    );
    for rho in [0.0, 0.5, 1.0] {
        let errors = steps.map(|h| (rise(&scene, alpha(&scene, rho), h) - exact).abs());
        let orders = orders(&errors);
        assert!(
            orders[1..].iter().all(|p| (1.7..2.4).contains(p)),
            "{rho}: {orders:?} {errors:?}"
        );
    }
}

/// No closed form is needed: RK4 in short steps, which the test above holds against one.
#[test]
fn every_interpolation_keeps_the_order_of_generalized_alpha() {
    for interpolation in INTERPOLATIONS {
        let scene = rest::build(&oscillator(interpolation, RAMP_AND_HOLD));
        let exact = rise(&scene, rk4(&scene), 0.002);
        let errors = [0.16, 0.08, 0.04, 0.02, 0.01]
            .map(|h| (rise(&scene, alpha(&scene, 0.5), h) - exact).abs());
        let orders = orders(&errors);
        let over_all = (errors[0] / errors[4]).log2() / 4.0;
        assert!(
            (1.75..2.35).contains(&over_all),
            "{interpolation}: {orders:?} {errors:?}"
        );
    }
}

/// In a current, without inertia: against short steps, since drag leaves no closed form.
#[test]
fn the_quasi_static_march_keeps_its_order_at_a_jump() {
    let scene = rest::build(&format!(
        "environment.water_density_kg_per_m3 = 1025.0\ncurrent.speed_m_per_s = 2.0\n{}",
        oscillator("linear", RAMP_AND_HOLD).replace("drag_area_m2 = 0.0", "drag_area_m2 = 3.0")
    ));
    let quasi = |h: f64| {
        let method = QuasiStatic::new(&scene, &scene.initial_state(), 1e-12, 40);
        marched(method, &scene, (3.6, h)).0.x[1]
    };
    let exact = quasi(0.000_312_5);
    let errors = [0.02, 0.01, 0.005, 0.0025].map(|h| (quasi(h) - exact).norm());
    let over_all = (errors[0] / errors[3]).log2() / 3.0;
    assert!(over_all > 1.7, "{:?} {errors:?}", orders(&errors));
}

#[test]
fn steps_end_at_kinks_and_nowhere_else_beside_the_grid() {
    let kinks = |interpolation| {
        let scene = rest::build(&oscillator(interpolation, RAMP_AND_HOLD));
        let (state, times) = marched(alpha(&scene, 0.5), &scene, (6.0, 0.4));
        let off = |t: &&f64| ((*t / 0.4).round() * 0.4 - **t).abs() > 1e-9;
        let off: Vec<f64> = times.iter().filter(off).copied().collect();
        (off, state.memory.motion_pieces)
    };
    assert_eq!(kinks("spline"), (vec![], [0, 0]));
    // The rows at 0.6 and 4 s lie within what is held.
    for interpolation in ["monotone", "linear"] {
        assert_eq!(kinks(interpolation), (vec![1.3, 3.1], [2, 0]));
    }
}

/// A kink on the grid up to rounding, above or below.
#[test]
fn a_kink_at_a_whole_step_is_passed_once() {
    for kink in [
        "0.3",
        "0.30000000000000004",
        "0.3000000000000001",
        "0.29999999999999993",
    ] {
        let rows = format!("0,0,0,0\n{kink},0,0,0\n1,0,0,0.7\n20,0,0,0.7");
        let scene = rest::build(&oscillator("linear", &rows));
        let (state, times) = marched(rk4(&scene), &scene, (2.0, 0.1));
        assert_eq!(
            (times.len(), state.memory.motion_pieces[0]),
            (21, 2),
            "{kink}"
        );
        assert!((state.x[0] - V3::z() * 0.7).norm() < 1e-12);
    }
}

/// A run of the program.
fn run(changes: &str) -> Run {
    let request = Request {
        case: lines::line(changes),
        text: String::new(),
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run
}

#[test]
fn output_changes_no_step_and_no_extreme() {
    for interpolation in INTERPOLATIONS {
        for method in ["alpha", "rk4", "quasi"] {
            let of = |interval: f64| {
                run(&format!(
                    "{}\nsolver.method = \"{method}\"\noutput.interval_s = {interval:?}",
                    oscillator(interpolation, RAMP_AND_HOLD).replace("1e-9", "0.5")
                ))
            };
            let (fine, coarse) = (of(0.05), of(3.0));
            assert_eq!(fine.info.work.steps, coarse.info.work.steps);
            assert_eq!(fine.summary, coarse.summary, "{interpolation} {method}");
        }
    }
}

/// The axial damper jumps by `c v` with the velocity of the end: the record has both sides of it.
#[test]
fn the_tension_jumps_by_the_damping() {
    let text = oscillator("linear", RAMP_AND_HOLD);
    let run = run(&format!(
        "{text}\nsolver.method = \"rk4\"\nsolver.time_step_s = 0.01"
    ));
    let id = case::channels(&lines::line(&text))
        .into_iter()
        .find(|channel| channel.id.to_string().starts_with("tension_n[top"));
    let top = id.unwrap().id.to_string();
    let max = run
        .summary
        .iter()
        .find(|q| q.id.to_string() == format!("{top}.max"))
        .unwrap_or_else(|| panic!("{top}: {:?}", run.summary));
    // At 1.3 s the damper adds c v / l, and the spring then more.
    let weight = 1000.0 * 9.80665;
    assert!(max.value > weight + 6e3 / 10.0 * 2.0 / 1.8, "{}", max.value);
}

#[test]
fn an_overshoot_of_the_spline_is_a_warning_with_its_remedy() {
    let warnings = |interpolation: &str, rows: &str| {
        let text = oscillator(interpolation, rows).replace("1e-9", "0.5");
        run(&format!("{text}\nsolver.method = \"alpha\""))
            .info
            .warnings
    };
    let about = |list: &[String]| list.iter().filter(|w| w.contains("overshoots")).count();
    let spline = warnings("spline", RAMP_AND_HOLD);
    assert_eq!(about(&spline), 1, "{spline:?}");
    let text = spline.iter().find(|w| w.contains("overshoots")).unwrap();
    for part in [
        "`p.csv`",
        "along z",
        " s, ",
        "ends.a.motion_interpolation",
        "\"monotone\"",
    ] {
        assert!(text.contains(part), "{text}");
    }
    for interpolation in ["monotone", "linear"] {
        assert_eq!(about(&warnings(interpolation, RAMP_AND_HOLD)), 0);
    }
    let sine: Vec<String> = (0..40_i32)
        .map(|i| format!("{i},0,0,{}", (0.8 * f64::from(i)).sin()))
        .collect();
    assert_eq!(about(&warnings("spline", &sine.join("\n"))), 0);
}
