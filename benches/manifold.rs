//! Speed against error on the manifold: 1200 s, segments of 25 m, one core.
//!
//! The reference is RK4 at a seventh of its stability limit, whose own error is shown by the row of twice that step. The
//! same line with a bending stiffness shows what five bands cost. Run with `cargo bench --bench manifold`; for any other case there is `seacable study speed`.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

mod speed;

use std::hint::black_box;
use std::time::Instant;

use seacable::case::{self, Case, Method};
use seacable::numerics::{BlockBand, V3};
use seacable::scene::{self, Scene};
use seacable::solve::{ExplicitRhs, Factors, Kinematics, Residual, State};
use speed::{alpha_rows, by, controlled, heading, row, run, with};

const MANIFOLD: &str = include_str!("../cases/pendulous/manifold.toml");

fn main() {
    let mut case = case::parse(MANIFOLD, "manifold.toml").unwrap();
    case.solver.error_estimate = false;
    kernels(&case);
    let bending = bending(&case);
    kernels(&bending);
    let reference = run(&by(&case, Method::Rk4, Some(0.00125), 0.4), 1).history;
    println!("\nreference: RK4 in steps of 1.25 ms");
    heading();
    for (name, step, repeats) in [
        ("rk4 step 0.0025", Some(0.0025), 1),
        ("rk4 automatic", None, 2),
    ] {
        row(
            name,
            &run(&by(&case, Method::Rk4, step, 0.4), repeats),
            &reference,
        );
    }
    let tolerances = [1e-4, 4e-5, 2e-5, 1e-5, 1e-6];
    alpha_rows(&case, &tolerances, &[0.5, 0.25, 0.125, 0.0625], &reference);
    println!("with a bending stiffness (errors: against the line without)");
    for tolerance in [2e-5, 1e-6] {
        let name = format!("alpha 0 tol {tolerance:.0e} EI");
        row(
            &name,
            &run(&controlled(&bending, 0.0, tolerance), 5),
            &reference,
        );
    }
    let quasi_static = run(&by(&case, Method::Quasi, None, 0.4), 5);
    row("quasi (no inertia)", &quasi_static, &reference);
}

/// The same line with a bending stiffness that hardly changes how it moves.
fn bending(case: &Case) -> Case {
    with(case, |c| {
        for material in c.materials.values_mut() {
            material.ei_n_m2 = 1e4;
        }
    })
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
