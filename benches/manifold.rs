//! Speed against error on the manifold: 1200 s, segments of 25 m, one core.
//!
//! Every row is one method at one setting: its work, the least CPU time of several repeats, and its error against a
//! run converged in time on the same mesh (RK4 at a seventh of its stability limit, whose own error is shown by the row
//! of twice that step). Mesh error and model error are in none of these numbers. The same line with a bending stiffness
//! shows what five bands cost. Run with `cargo bench --bench manifold`; for any other case there is `seacable study speed`.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

use std::hint::black_box;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use seacable::case::{self, Case, Method};
use seacable::numerics::{BlockBand, V3};
use seacable::run::{History, Run, job};
use seacable::scene::{self, Scene};
use seacable::solve::{ExplicitRhs, Factors, Kinematics, Residual, State};

const MANIFOLD: &str = include_str!("../cases/pendulous/manifold.toml");

fn main() {
    let mut case = case::parse(MANIFOLD, "manifold.toml").unwrap();
    case.solver.error_estimate = false;
    kernels(&case);
    let bending = bending(&case);
    kernels(&bending);
    let reference = run(&with(&case, |c| set(c, Method::Rk4, Some(0.00125), 0.4)), 1)
        .run
        .history;
    println!("\nreference: RK4 in steps of 1.25 ms");
    heading();
    row(
        "rk4 step 0.0025",
        &run(&with(&case, |c| set(c, Method::Rk4, Some(0.0025), 0.4)), 1),
        &reference,
    );
    row(
        "rk4 automatic",
        &run(&with(&case, |c| set(c, Method::Rk4, None, 0.4)), 2),
        &reference,
    );
    for rho in [0.0, 0.4, 0.8] {
        for tolerance in [1e-4, 4e-5, 2e-5, 1e-5, 1e-6] {
            let case = with(&case, |c| {
                set(c, Method::Alpha, None, rho);
                c.solver.step_tolerance = tolerance;
            });
            row(
                &format!("alpha {rho} tol {tolerance:.0e}"),
                &run(&case, 5),
                &reference,
            );
        }
        for step in [0.5, 0.25, 0.125, 0.0625] {
            let case = with(&case, |c| set(c, Method::Alpha, Some(step), rho));
            row(
                &format!("alpha {rho} step {step}"),
                &run(&case, 5),
                &reference,
            );
        }
    }
    println!("with a bending stiffness (errors: against the line without)");
    for tolerance in [2e-5, 1e-6] {
        let case = with(&bending, |c| {
            set(c, Method::Alpha, None, 0.0);
            c.solver.step_tolerance = tolerance;
        });
        row(
            &format!("alpha 0 tol {tolerance:.0e} EI"),
            &run(&case, 5),
            &reference,
        );
    }
    row(
        "quasi (no inertia)",
        &run(&with(&case, |c| set(c, Method::Quasi, None, 0.4)), 5),
        &reference,
    );
}

/// The same line with a bending stiffness that hardly changes how it moves.
fn bending(case: &Case) -> Case {
    with(case, |c| {
        for material in c.materials.values_mut() {
            material.ei_n_m2 = 1e4;
        }
    })
}

fn with(case: &Case, change: impl Fn(&mut Case)) -> Case {
    let mut case = case.clone();
    change(&mut case);
    case
}

fn set(case: &mut Case, method: Method, step: Option<f64>, rho: f64) {
    case.solver.method = method;
    case.solver.time_step_s = step;
    case.solver.rho_inf = rho;
}

/// A run and the least CPU time of its repeats.
struct Timed {
    run: Run,
    cpu_s: f64,
}

fn run(case: &Case, repeats: usize) -> Timed {
    let request = job::Request {
        case: case.clone(),
        text: String::new(),
        file: "manifold.toml".to_owned(),
        overrides: Vec::new(),
        id: "bench".to_owned(),
    };
    let once = || job::execute(&request, &AtomicBool::new(false), &mut |_| {});
    let mut best = once();
    for _ in 1..repeats {
        let again = once();
        if again.info.cost.cpu_s < best.info.cost.cpu_s {
            best = again;
        }
    }
    Timed {
        cpu_s: best.info.cost.cpu_s,
        run: best,
    }
}

fn heading() {
    println!(
        "{:<26} {:>8} {:>6} {:>8} {:>9} {:>9} {:>10} {:>10} {:>9}",
        "method", "steps", "rej.", "work", "CPU ms", "ns/node", "rms T %", "max T %", "max x m"
    );
}

/// `work` counts Newton iterations, or force evaluations where there are none; `ns/node` is all CPU time by nodes and
/// work. Tension errors are of the worst joint, as a share of its peak; the position is the manifold's.
fn row(name: &str, timed: &Timed, reference: &History) {
    let info = &timed.run.info;
    let work = info.work.iterations.max(info.work.evaluations);
    let per_node = timed.cpu_s * 1e9 / (work as f64 * info.settings.nodes as f64);
    let (rms, worst, position) = errors(&timed.run.history, reference);
    println!(
        "{name:<26} {:>8} {:>6} {work:>8} {:>9.1} {per_node:>9.1} {rms:>10.4} {worst:>10.3} {position:>9.4}",
        info.work.steps,
        info.work.rejections,
        timed.cpu_s * 1e3,
    );
}

fn errors(history: &History, reference: &History) -> (f64, f64, f64) {
    let mut tension = (0.0_f64, 0.0_f64);
    let mut position = vec![0.0; reference.time.len()];
    if history.time.len() != reference.time.len() {
        return (f64::NAN, f64::NAN, f64::NAN);
    }
    for (ours, theirs) in history.channels.iter().zip(&reference.channels) {
        let differences = ours
            .values
            .iter()
            .zip(&theirs.values)
            .map(|(a, b)| (a - b).abs());
        if ours.name().starts_with("tension_n") {
            let sum: f64 = differences.clone().map(|d| d * d).sum();
            let rms = (sum / position.len() as f64).sqrt();
            let share = 100.0 / theirs.peak.0;
            tension = (
                tension.0.max(rms * share),
                tension.1.max(differences.fold(0.0, f64::max) * share),
            );
        } else if ours.unit() == "m" {
            for (p, d) in position.iter_mut().zip(differences) {
                *p += d * d;
            }
        }
    }
    (
        tension.0,
        tension.1,
        position.iter().fold(0.0_f64, |a, b| a.max(*b)).sqrt(),
    )
}

/// What one node costs, in the middle of the swing: least of many batches.
fn kernels(case: &Case) {
    let scene = scene::build(case, 1).unwrap();
    let mut state = swinging(&scene);
    let nodes = scene.nodes();
    let mut r = vec![V3::zeros(); nodes];
    let mut tangent = BlockBand::new(nodes);
    if scene.is_pentadiagonal() {
        tangent.widen();
    }
    let c = Factors {
        mass: 64.0,
        damping: 6.0,
        stiffness: 1.0,
    };
    let [assembled, solved] = if scene.is_pentadiagonal() {
        println!("kernels with bending, ns per node ({nodes} nodes)");
        ["not measured", "asked for: 150"]
    } else {
        println!("kernels, ns per node ({nodes} nodes)      physical limit seen");
        [
            "41-57 (one drag a node, symmetric)",
            "67-85, asked for: 100",
        ]
    };
    let residual = best(nodes, || scene.residual(0.0, &state, black_box(&mut r)));
    println!("  residual                       {residual:6.1}");
    let assembly = best(nodes, || {
        scene.linearise(0.0, &state, c, black_box(&mut r), &mut tangent);
    });
    println!("  residual and exact tangent     {assembly:6.1}      {assembled}");
    let iteration = best(nodes, || {
        scene.linearise(0.0, &state, c, &mut r, &mut tangent);
        tangent.solve(scene.free(), black_box(&mut r)).unwrap();
    });
    println!("  the same and block solve       {iteration:6.1}      {solved}");
    let acceleration = best(nodes, || scene.accelerate(0.0, black_box(&mut state)));
    println!("  explicit acceleration          {acceleration:6.1}      7-28");
}

/// A line part of the way down, moving.
fn swinging(scene: &Scene) -> State {
    let mut state = scene.initial_state();
    for i in 0..scene.nodes() {
        let s = i as f64;
        state.x[i].z -= 0.3 * s * s;
        state.v[i] = V3::new(0.5, 0.01 * s, -0.08 * s);
    }
    scene.accelerate(0.0, &mut state);
    state
}

fn best(nodes: usize, mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..300 {
        let start = Instant::now();
        for _ in 0..100 {
            work();
        }
        least = least.min(start.elapsed().as_secs_f64());
    }
    least * 1e7 / nodes as f64
}
