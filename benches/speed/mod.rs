//! Speed against error of one case: a row a method and setting, with its work, the least CPU time of several repeats, and
//! its error against a run converged in time on the same mesh. Mesh error and model error are in none of these numbers.

use std::sync::atomic::AtomicBool;

use seacable::case::{Case, Method};
use seacable::run::{History, Run, job};

/// A case with a change.
pub(crate) fn with(case: &Case, change: impl Fn(&mut Case)) -> Case {
    let mut case = case.clone();
    change(&mut case);
    case
}

/// A case computed by a method in constant steps; without a step, in those that the method chooses.
pub(crate) fn by(case: &Case, method: Method, step: Option<f64>, rho: f64) -> Case {
    with(case, |case| {
        case.solver.method = method;
        case.solver.time_step_s = step;
        case.solver.rho_inf = rho;
    })
}

/// A case computed by generalized-alpha in steps of varying length.
pub(crate) fn controlled(case: &Case, rho: f64, tolerance: f64) -> Case {
    let mut case = by(case, Method::Alpha, None, rho);
    case.solver.step_tolerance = tolerance;
    case
}

/// The run with the least CPU time of several.
pub(crate) fn run(case: &Case, repeats: usize) -> Run {
    let request = job::Request {
        case: case.clone(),
        text: String::new(),
        file: "bench.toml".to_owned(),
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
    best
}

/// The names of the columns.
pub(crate) fn heading() {
    println!(
        "{:<26} {:>8} {:>6} {:>8} {:>9} {:>9} {:>10} {:>10} {:>9}",
        "method", "steps", "rej.", "work", "CPU ms", "ns/node", "rms T %", "max T %", "max x m"
    );
}

/// Rows of generalized-alpha for every spectral radius: at these tolerances, and in these constant steps \[s\].
pub(crate) fn alpha_rows(case: &Case, tolerances: &[f64], steps: &[f64], reference: &History) {
    for rho in [0.0, 0.4, 0.8] {
        for tolerance in tolerances {
            let name = format!("alpha {rho} tol {tolerance:.0e}");
            row(
                &name,
                &run(&controlled(case, rho, *tolerance), 5),
                reference,
            );
        }
        for step in steps {
            let name = format!("alpha {rho} step {step}");
            row(
                &name,
                &run(&by(case, Method::Alpha, Some(*step), rho), 5),
                reference,
            );
        }
    }
}

/// `work` counts Newton iterations, or force evaluations where there are none; `ns/node` is all CPU time by nodes and
/// work. Tension errors are of the worst joint, as a share of its peak; the position error is of all coordinates together.
pub(crate) fn row(name: &str, run: &Run, reference: &History) {
    let info = &run.info;
    let work = info.work.iterations.max(info.work.evaluations);
    let per_node = info.cost.cpu_s * 1e9 / (work as f64 * info.settings.nodes as f64);
    let (rms, worst, position) = errors(&run.history, reference);
    println!(
        "{name:<26} {:>8} {:>6} {work:>8} {:>9.1} {per_node:>9.1} {rms:>10.4} {worst:>10.3} {position:>9.4}",
        info.work.steps,
        info.work.rejections,
        info.cost.cpu_s * 1e3,
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
