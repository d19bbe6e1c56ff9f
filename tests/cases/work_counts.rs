//! The work of the shipped cases, in counts that no machine changes: a solver that needs more of it fails here,
//! without any timing.

use std::fmt::Write;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use seacable::case::{self, Method};
use seacable::run::job::{Request, execute};
use seacable::run::{RunState, Work};

/// Work of a shipped case with another method, duration or step.
fn work(name: &str, method: Method, duration_s: Option<f64>, time_step_s: Option<f64>) -> Work {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("cases/pendulous")
        .join(name);
    let loaded = case::load(&path).unwrap();
    let mut case = loaded.case;
    case.solver.method = method;
    case.solver.duration_s = duration_s.unwrap_or(case.solver.duration_s);
    case.solver.time_step_s = time_step_s;
    case.solver.error_estimate = false;
    let request = Request {
        case,
        text: loaded.text,
        file: name.to_owned(),
        overrides: Vec::new(),
        id: "work".to_owned(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run.info.work
}

#[test]
fn work_of_the_shipped_cases() {
    let rows = [
        (
            "manifold, alpha",
            work("manifold.toml", Method::Alpha, None, None),
        ),
        (
            "manifold, alpha, steps of 0.25 s",
            work("manifold.toml", Method::Alpha, None, Some(0.25)),
        ),
        (
            "manifold, quasi",
            work("manifold.toml", Method::Quasi, None, None),
        ),
        (
            "manifold, rk4, 60 s",
            work("manifold.toml", Method::Rk4, Some(60.0), None),
        ),
        (
            "module, alpha",
            work("module.toml", Method::Alpha, None, None),
        ),
        (
            "module, quasi",
            work("module.toml", Method::Quasi, None, None),
        ),
        (
            "module, rotating, alpha",
            work("module_rotating.toml", Method::Alpha, None, None),
        ),
    ];
    let mut text = format!(
        "{:34}{:>8}{:>11}{:>12}{:>13}\n",
        "", "steps", "rejections", "iterations", "evaluations"
    );
    for (name, work) in rows {
        let Work {
            steps,
            rejections,
            iterations,
            evaluations,
        } = work;
        writeln!(
            text,
            "{name:34}{steps:>8}{rejections:>11}{iterations:>12}{evaluations:>13}"
        )
        .unwrap();
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("work_of_the_shipped_cases", text));
}
