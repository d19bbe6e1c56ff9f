//! What must never happen, on lines drawn at random from all that a case may say: a panic, a number that is not
//! finite in a run that calls itself done, a failure that does not say where and when, an equilibrium with a force
//! left over.

use crate::drawn_lines::{any_line, any_scene};
use crate::lines;
use std::sync::atomic::AtomicBool;

use proptest::prelude::*;
use seacable::case::Method;
use seacable::run::job::{Request, execute};
use seacable::run::{Run, RunState};
use seacable::scene;
use seacable::solve::{Kinematics, Newton, StaticSearch};
use seacable::statics::equilibrium::EquilibriumSearch;

/// Runs a case for some seconds, or as many steps as its stiffest segment lets one compute in a moment.
fn run(text: &str, method: Method, time_step_s: Option<f64>, rho: f64) -> Run {
    let mut case = lines::line(text);
    let limit = scene::build(&case, 1).unwrap().explicit_limit().0;
    case.solver.method = method;
    case.solver.time_step_s = time_step_s.filter(|_| method != Method::Rk4);
    case.solver.rho_inf = rho;
    case.solver.duration_s = (1000.0 * limit).min(5.0);
    case.output.interval_s = case.solver.duration_s / 10.0;
    let request = Request {
        case,
        text: String::new(),
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    execute(&request, &AtomicBool::new(false), &mut |_| {})
}

fn finite(run: &Run) -> bool {
    let channels = run.history.channels.iter();
    let mut values = channels.flat_map(|c| c.values.iter().chain([&c.peak.0, &c.trough.0]));
    let p = &run.profile();
    let profile = [
        &p.tension,
        &p.tension_min,
        &p.tension_max,
        &p.z_min,
        &p.z_max,
    ];
    values.all(|v| v.is_finite())
        && profile.into_iter().flatten().all(|v| v.is_finite())
        && run.shapes.iter().all(|s| {
            s.nodes
                .iter()
                .flatten()
                .chain(&s.tension)
                .all(|v| v.is_finite())
        })
        && run.summary.iter().all(|q| q.value.is_finite())
}

/// Whether loads may stretch the line to many times its length: its weight, and drag at 3 m/s.
fn stretches_far(text: &str) -> bool {
    let scene = scene::build(&lines::line(text), 1).unwrap();
    let drag = |area: f64| 0.5 * 1025.0 * area * 9.0;
    let sides: f64 = scene
        .line
        .segments
        .iter()
        .map(|s| s.diameter * s.axial.length)
        .sum();
    let payload = scene
        .line
        .bodies
        .iter()
        .map(|h| 9.0 * h.body.drag.max())
        .sum::<f64>();
    let turning = scene
        .elements
        .rigid_payload
        .map_or(0.0, |t| 9.0 * t.body.drag[0]);
    let load = scene.line.force_scale + drag(2.0 * sides) + payload + turning;
    scene.line.segments[0].axial.ea < 10.0 * load
}

/// Cases drawn; few enough for a quick test. `PROPTEST_CASES` draws more.
fn cases(n: u32) -> ProptestConfig {
    let cases = std::env::var("PROPTEST_CASES")
        .ok()
        .and_then(|n| n.parse().ok());
    ProptestConfig {
        cases: cases.unwrap_or(n),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn no_run_panics_or_hides_a_number_that_is_not_finite(
        text in any_line(),
        method in prop_oneof![
            Just(Method::Alpha), Just(Method::Quasi), Just(Method::Rk4), Just(Method::Static)
        ],
        step in prop_oneof![Just(None), (-3.0f64..0.0).prop_map(|log| Some(10f64.powf(log)))],
        rho in 0.0f64..1.0,
    ) {
        let run = run(&text, method, step, rho);
        match run.info.state {
            RunState::Done => {
                prop_assert!(finite(&run), "{text}");
                // Nothing drawn here goes farther, unless it stretches without limit.
                let far = run.profile().nodes.iter().flatten().fold(0.0, |far: f64, x| far.max(x.abs()));
                let soft = stretches_far(&text);
                prop_assert!(soft || far < 1e4, "{far} m {:?}\n{text}", run.info.settings);
            }
            RunState::Failed => {
                let why = run.info.failure.clone().unwrap_or_default();
                let placed = why.contains("node ") && (why.contains("t = ") || why.contains("equilibrium"));
                prop_assert!(placed, "{why}\n{text}");
                prop_assert!(run.history.channels.iter().flat_map(|c| &c.values).all(|v| v.is_finite()));
            }
            state => prop_assert!(false, "{state:?}"),
        }
    }

    #[test]
    fn no_line_in_motion_panics_or_hides_a_number_that_is_not_finite(
        text in any_scene(),
        method in prop_oneof![3 => Just(Method::Alpha), 1 => Just(Method::Quasi), 1 => Just(Method::Rk4)],
        rho in 0.0f64..1.0,
    ) {
        let run = run(&text, method, None, rho);
        match run.info.state {
            RunState::Done => {
                prop_assert!(finite(&run), "{text}");
                let far = run.profile().nodes.iter().flatten().fold(0.0, |far: f64, x| far.max(x.abs()));
                prop_assert!(far < 1e4, "{far} m {:?}\n{text}", run.info.settings);
            }
            RunState::Failed => {
                let why = run.info.failure.clone().unwrap_or_default();
                let placed = why.contains("node ") && (why.contains("t = ") || why.contains("equilibrium"));
                let advised = why.contains("try ") || why.contains("give ") || why.contains("use ") || why.contains("start");
                prop_assert!(placed || advised, "{why}\n{text}");
            }
            state => prop_assert!(false, "{state:?}"),
        }
    }

    #[test]
    fn an_equilibrium_leaves_no_force_or_is_refused(text in any_line()) {
        let scene = scene::build(&lines::line(&text), 1).unwrap();
        let mut state = scene.initial_state();
        match EquilibriumSearch::default().run(&scene, 0.0, &mut state) {
            Ok(found) => {
                let (_, left) = Newton::new(scene.nodes(), 1.0, 1).largest_residual(&scene, 0.0, &state);
                prop_assert!(left <= (1e-8 * scene.line.force_scale).max(scene.rounding_force()), "{left} N\n{text}");
                prop_assert_eq!(left, found.residual);
            }
            Err(why) => prop_assert!(why.to_string().contains("at node"), "{why}"),
        }
    }
}
