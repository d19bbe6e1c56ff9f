//! Whole runs without and with error estimates: CPU time of the process, all threads together, least of several repeats, in
//! memory (nothing is written). Run with `cargo bench --bench runs`; with a text after `--`, only cases whose path holds it.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

use std::path::Path;
use std::sync::atomic::AtomicBool;

use rustix::time::{ClockId, clock_gettime};
use seacable::case;
use seacable::run::{Run, job};

/// Cases of every kind of motion: lowered, moored, driven, in waves, on the bed, snapping, with a rotating body.
const CASES: [&str; 13] = [
    "pendulous/manifold.toml",
    "pendulous/module.toml",
    "pendulous/module_rotating.toml",
    "mooring/hybrid_moving.toml",
    "basics/pendulum.toml",
    "basics/steep_wave.toml",
    "benchmarks/jumper_heave.toml",
    "benchmarks/lindahl_chain.toml",
    "double_stepped/regular_wave.toml",
    "hard/snap.toml",
    "hard/touchdown.toml",
    "hard/rough.toml",
    "hard/whip.toml",
];

/// Repeats of a run that takes less than a second.
const REPEATS: usize = 7;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let wanted = |case: &&&str| {
        let mut words = words.iter().filter(|word| !word.starts_with('-'));
        words.clone().next().is_none() || words.any(|word| case.contains(word.as_str()))
    };
    println!(
        "{:<36} {:>6} {:>8} {:>10} {:>9} {:>9} {:>6}",
        "case", "nodes", "steps", "iterations", "CPU ms", "with ms", "ratio"
    );
    for file in CASES.iter().filter(wanted) {
        row(file);
    }
}

/// A row of the table.
fn row(file: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("cases")
        .join(file);
    let mut request = job::Request {
        case: case::load(&path).unwrap().case,
        text: String::new(),
        file: file.to_owned(),
        overrides: Vec::new(),
        id: "bench".to_owned(),
    };
    request.case.solver.error_estimate = false;
    let (run, without) = least(&request);
    request.case.solver.error_estimate = true;
    let (_, with) = least(&request);
    let (work, nodes) = (&run.info.work, run.info.settings.nodes);
    println!(
        "{file:<36} {nodes:>6} {:>8} {:>10} {:>9.1} {:>9.1} {:>6.2}",
        work.steps,
        work.iterations,
        without * 1e3,
        with * 1e3,
        with / without,
    );
}

/// A run and the least CPU time of several \[s\].
fn least(request: &job::Request) -> (Run, f64) {
    let once = || {
        let start = cpu_time();
        let run = job::execute(request, &AtomicBool::new(false), &mut |_| {});
        (run, cpu_time() - start)
    };
    let mut best = once();
    for _ in 1..if best.1 < 1.0 { REPEATS } else { 1 } {
        let again = once();
        if again.1 < best.1 {
            best = again;
        }
    }
    best
}

/// CPU time of the process \[s\].
fn cpu_time() -> f64 {
    let t = clock_gettime(ClockId::ProcessCPUTime);
    t.tv_sec as f64 + 1e-9 * t.tv_nsec as f64
}
