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

use seacable::case::{self, Case, Method};
use speed::{alpha_rows, by, controlled, heading, row, run, with};

const MANIFOLD: &str = include_str!("../cases/pendulous/manifold.toml");

fn main() {
    let mut case = case::parse(MANIFOLD, "manifold.toml").unwrap();
    case.solver.error_estimate = false;
    let bending = bending(&case);
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
