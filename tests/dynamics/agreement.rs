//! Independent methods on one line must tell the same, and a line at rest must stay there, whatever the method.

use crate::{march, rest};
use std::path::Path;
use std::sync::atomic::AtomicBool;

use seacable::case::{self, Case, DragCoefficient, Method};
use seacable::dynamics::quasi_static::QuasiStatic;
use seacable::run::job::{Request, execute};
use seacable::run::{History, Run, RunState};
use seacable::solve::State;

fn run(case: Case) -> Run {
    let request = Request {
        case,
        text: String::new(),
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run
}

fn manifold(change: impl FnOnce(&mut Case)) -> Run {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/pendulous/manifold.toml");
    let mut case = case::load(&path).unwrap().case;
    case.solver.error_estimate = false;
    change(&mut case);
    run(case)
}

/// Differences between the channels of two runs at all their output times: name, root of mean square, greatest,
/// and the time of the greatest.
fn differences(a: &History, b: &History) -> Vec<(String, f64, f64, f64)> {
    assert_eq!(a.time.len(), b.time.len());
    let pairs = a.channels.iter().zip(&b.channels);
    pairs
        .map(|(p, q)| {
            assert_eq!(p.id, q.id);
            let apart = p.values.iter().zip(&q.values).map(|(x, y)| (x - y).abs());
            let square: f64 = apart.clone().map(|d| d * d).sum();
            let worst =
                apart.zip(&a.time).fold(
                    (0.0, 0.0),
                    |worst, (d, t)| {
                        if d > worst.0 { (d, *t) } else { worst }
                    },
                );
            let rms = (square / a.time.len() as f64).sqrt();
            (p.name(), rms, worst.0, worst.1)
        })
        .collect()
}

/// The drag coefficient is constant: where the line swings at the speed at which the printed one falls from 1.27 to 0.3, which
/// side a segment is on decides where the manifold goes, by 0.1 to 0.4 m with any method and tolerance. Tensions hardly notice.
#[test]
fn generalized_alpha_and_runge_kutta_agree_on_the_manifold() {
    let constant = |case: &mut Case| {
        for material in case.materials.values_mut() {
            material.drag_normal = DragCoefficient::Constant(1.27);
        }
    };
    let explicit = manifold(|case| {
        constant(case);
        case.solver.method = Method::Rk4;
    });
    let implicit = manifold(|case| {
        constant(case);
        case.solver.step_tolerance = 3e-8;
    });
    for (name, rms, worst, at) in differences(&explicit.history, &implicit.history) {
        let peak = explicit.history.channel(&name).unwrap().peak.0;
        if name.starts_with("tension") {
            assert!(rms < 1e-3 * peak, "{name}: {rms} N of {peak} N");
        } else if name.contains("_m[") {
            assert!(worst < 0.1, "{name}: {worst} m at {at} s");
        }
    }
}

/// Without inertia or with it, the manifold comes to hang in the same place.
#[test]
fn the_quasi_static_manifold_hangs_where_the_dynamic_one_does() {
    let [quick, slow] = [Method::Quasi, Method::Alpha].map(|method| {
        manifold(|case| {
            case.solver.method = method;
            case.solver.duration_s = 2500.0;
            case.output.interval_s = 2.5;
        })
    });
    for (a, b) in quick.history.channels.iter().zip(&slow.history.channels) {
        let (x, y) = (a.values[1000], b.values[1000]);
        // Both stop Newton well below this; the swing has died down to rounding.
        assert!(
            (x - y).abs() < 1e-7 * x.abs().max(1.0),
            "{}: {x} {y}",
            a.name()
        );
    }
}

const AT_REST: &str = r#"
    environment.water_density_kg_per_m3 = 1025.0
    current = { speed_m_per_s = [1.5, 0.3], direction_deg = [0.0, 90.0], depth_m = [0.0, 100.0] }
    materials.rope = { mass_kg_per_m = 12.0, drag_normal = 1.2, drag_tangential = 0.02, added_mass_normal = 1.0 }
    ends.b = { name = "bob", kind = "payload" }
    payload = { dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = 3.0, added_mass_kg = 500.0 }
"#;

/// Statics leave a force of 1e-8 of the gross weight at most. Every method then moves the line no farther than that
/// force, at its softest, across: twice the force by the stiffness `T/L` of a line with a tension T at its foot.
#[test]
fn rest_stays_at_rest() {
    let scene = rest::build(AT_REST);
    let still = rest::at_rest(&scene);
    let left = 1e-8 * scene.line.force_scale * 11.0;
    let tolerance = 2.0 * left * 100.0 / (700.0 * 9.80665);
    let check = |t: f64, state: &State| {
        for (x, x0) in state.x.iter().zip(&still.x) {
            let off = (x - x0).norm();
            assert!(off < tolerance, "t = {t}: {off} m, {tolerance} m");
        }
    };
    let quasi = QuasiStatic::new(&scene, &scene.initial_state(), 1e-9, 30);
    march::march(
        march::rk4(&scene),
        &scene,
        &mut still.clone(),
        (30.0, 0.01),
        check,
    );
    for rho in [0.0, 0.4, 0.8] {
        march::march(
            march::alpha(&scene, rho),
            &scene,
            &mut still.clone(),
            (300.0, 0.1),
            check,
        );
    }
    march::march(quasi, &scene, &mut still.clone(), (300.0, 1.0), check);
}
