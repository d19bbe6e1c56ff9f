//! Speed against error on the hybrid mooring line: 158 segments, 200 s of the top moving 5 m in 10 s, one core.
//!
//! The reference is RK4 at a quarter of its automatic step, whose own error is shown by the row of twice that step. The
//! rope's memory has order 2 in every method, so steps as short as these are needed to see the others. Goal: 0.5 % of the
//! peak tension in 65 ms. Run with `cargo bench --bench mooring`.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

mod speed;

use seacable::case::{self, Case, DynamicStiffness, Method};
use speed::{alpha_rows, by, heading, row, run};

const MOORING: &str = include_str!("../cases/mooring/hybrid_moving.toml");

fn main() {
    let mut case = case::parse(MOORING, "hybrid_moving.toml").unwrap();
    case.solver.error_estimate = false;
    for (reading, name) in [
        (DynamicStiffness::None, "static stiffness"),
        (DynamicStiffness::Secant, "dynamic stiffness, secant"),
        (
            DynamicStiffness::AboutTheMean,
            "dynamic stiffness, about the mean",
        ),
    ] {
        for material in case.materials.values_mut() {
            if material.dynamic_alpha.is_some() {
                material.dynamic_stiffness = reading;
            }
        }
        table(&case, name);
    }
}

/// The table of one stiffness.
fn table(case: &Case, name: &str) {
    let automatic = run(&by(case, Method::Rk4, None, 0.4), 1);
    let step = automatic.info.settings.time_step_s;
    let fine = run(&by(case, Method::Rk4, Some(0.25 * step), 0.4), 1).history;
    println!("\n{name}; reference: RK4 in steps of {:.4} s", 0.25 * step);
    heading();
    let twice = run(&by(case, Method::Rk4, Some(0.5 * step), 0.4), 1);
    row("rk4, twice that step", &twice, &fine);
    row("rk4 automatic", &automatic, &fine);
    row("as shipped", &run(case, 5), &fine);
    alpha_rows(
        case,
        &[8e-5, 4e-5, 2e-5, 5e-6],
        &[0.25, 0.125, 0.0625],
        &fine,
    );
}
