//! Numerical errors of a run, estimated by companions: one with twice the time step, one with half the
//! segments. Time error and mesh error are kept apart; model error is what a validation table shows.
//!
//! With a method of order p and a ratio r between the steps, the error of the finer result is about
//! `|fine - coarse| / (r^p - 1)` (Richardson).

use std::sync::atomic::AtomicBool;

use super::compute::{Computed, Step, compute};
use super::statistic::{Wanted, evaluate, wanted};
use super::{Quantity, RunState, quantity_name};
use crate::case::{Case, Method};

/// Estimated errors, one a wanted number; absent where not estimated.
#[derive(Debug, Clone, Default)]
pub(super) struct Estimates {
    time: Vec<Option<f64>>,
    mesh: Vec<Option<f64>>,
    /// How they were made, in words.
    pub(super) method: String,
    /// What went wrong, in words.
    pub(super) warnings: Vec<String>,
}

/// Runs the companions, side by side where there are cores.
pub(super) fn estimate(case: &Case, run: &Computed, cancel: &AtomicBool) -> Estimates {
    let wanted = wanted_of(case, run);
    let fine: Vec<Option<f64>> = wanted.iter().map(|w| evaluate(&run.history, w)).collect();
    let order = order(case.solver.method);
    let companion = |coarsening, step| compute(case, coarsening, step, cancel, &mut |_| {});
    let (slow, coarse) = rayon::join(
        || order.map(|_| companion(1, Step::Doubled)),
        || companion(2, Step::AsSet),
    );
    let mut estimates = Estimates {
        method: describe(case, order),
        ..Estimates::default()
    };
    if let (Some(order), Some(slow)) = (order, slow) {
        let divisor = 2f64.powi(order) - 1.0;
        estimates.time = differences(
            &wanted,
            &fine,
            &slow,
            divisor,
            "time",
            &mut estimates.warnings,
        );
    }
    let ratio = ratio_of_meshes(case);
    if ratio > 1.0 {
        let divisor = ratio * ratio - 1.0;
        estimates.mesh = differences(
            &wanted,
            &fine,
            &coarse,
            divisor,
            "mesh",
            &mut estimates.warnings,
        );
    } else {
        estimates
            .warnings
            .push("every section is one segment: the mesh error cannot be estimated".to_owned());
    }
    estimates
}

/// The order in time of a method; none for statics.
fn order(method: Method) -> Option<i32> {
    match method {
        Method::Static => None,
        Method::Quasi | Method::Alpha => Some(2),
        Method::Rk4 => Some(4),
    }
}

/// Segment length of the coarse mesh by that of the fine one, over the whole line.
fn ratio_of_meshes(case: &Case) -> f64 {
    let fine: usize = case.line.iter().map(|s| s.segments).sum();
    let coarse: usize = case.line.iter().map(|s| s.segments.div_ceil(2)).sum();
    fine as f64 / coarse as f64
}

fn describe(case: &Case, order: Option<i32>) -> String {
    let mesh = format!(
        "mesh: half the segments (ratio {:.2}, order 2)",
        ratio_of_meshes(case)
    );
    match order {
        Some(order) if case.solver.time_step_s.is_none() && case.solver.method == Method::Alpha => {
            format!("time: eight times the error allowed in a step (order {order}); {mesh}")
        }
        Some(order) => format!("time: twice the step (order {order}); {mesh}"),
        None => mesh,
    }
}

fn differences(
    wanted: &[Wanted],
    fine: &[Option<f64>],
    companion: &Computed,
    divisor: f64,
    what: &str,
    warnings: &mut Vec<String>,
) -> Vec<Option<f64>> {
    if companion.state != RunState::Done {
        let why = companion.failure.as_deref().unwrap_or("it was stopped");
        warnings.push(format!(
            "the {what} error is not estimated, its companion run did not finish: {why}"
        ));
        return Vec::new();
    }
    let coarse = wanted.iter().map(|w| evaluate(&companion.history, w));
    fine.iter()
        .zip(coarse)
        .map(|(f, c)| Some((f.as_ref()? - c?).abs() / divisor))
        .collect()
}

fn wanted_of(case: &Case, run: &Computed) -> Vec<Wanted> {
    let names: Vec<String> = run
        .history
        .channels
        .iter()
        .map(|c| c.name.clone())
        .collect();
    wanted(case, &names)
}

/// The single numbers of a run with their errors; those that cannot be taken are left out.
pub(super) fn summary(case: &Case, run: &Computed, estimates: &Estimates) -> Vec<Quantity> {
    let pick = |list: &[Option<f64>], i: usize| list.get(i).copied().flatten();
    wanted_of(case, run)
        .iter()
        .enumerate()
        .filter_map(|(i, w)| {
            let channel = &run.history.channels[w.channel];
            Some(Quantity {
                name: quantity_name(&channel.name, w.statistic, w.window),
                value: evaluate(&run.history, w)?,
                unit: w.statistic.unit(&channel.unit),
                time_error: pick(&estimates.time, i),
                mesh_error: pick(&estimates.mesh, i),
            })
        })
        .collect()
}
