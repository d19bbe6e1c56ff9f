//! Numerical errors of a run, estimated by companions: one with another time step, one with another mesh. Time error and mesh error are
//! kept apart; model error is what a validation table shows.
//!
//! With a method of order p and a ratio r between the steps, the error of the finer result is about
//! `|fine - coarse| / (r^p - 1)` (Richardson). A force that jumps (a drag crisis) leaves no method its order: the whole
//! difference counts then.

use std::sync::atomic::AtomicBool;

use super::compute::{Computed, StepScale, compute};
use super::requested_statistics::{Of, RequestedStatistic};
use super::{Quantity, QuantityId, RunState, Subject};
use super::{line_statistics, natural_modes, published_curve};
use crate::case::{Case, DragLaw, DragLawName, Method};
use crate::dynamics::march::March;
use crate::numerics::interpolation::linear_clamped;

/// Estimated errors, one a wanted number; absent where not estimated.
#[derive(Debug, Clone, Default)]
pub(super) struct Estimates {
    time: Vec<Option<f64>>,
    mesh: Vec<Option<f64>>,
    /// What is told of natural modes.
    modes: Vec<Quantity>,
    /// Differences from published curves.
    curves: Vec<Quantity>,
    /// Error of the root mean square displacements, node by node \[m\], time and mesh together.
    pub(super) rms: Vec<f64>,
    /// How they were made, in words.
    pub(super) method: String,
    /// What went wrong, in words.
    pub(super) warnings: Vec<String>,
}

/// Runs the companions, side by side where there are cores.
pub(super) fn estimate(case: &Case, run: &Computed, cancel: &AtomicBool) -> Estimates {
    let order = order(case.solver.method);
    let ratio = ratio_of_meshes(case);
    let times = ratio_of_steps(run);
    let companion = |coarsening, step| compute(case, coarsening, step, cancel, &mut |_| {});
    let (other, coarse) = rayon::join(
        || order.map(|_| companion(1, StepScale::Times(times))),
        || (ratio > 1.0).then(|| companion(2, StepScale::AsSet)),
    );
    let coarse_modes = coarse.as_ref().map_or(&[][..], |c| &c.modes);
    let modes = natural_modes::with_errors(&run.modes, coarse_modes, ratio);
    let by_step = (times.powi(order.unwrap_or(0)) - 1.0).abs();
    let others = [(&other, by_step), (&coarse, ratio * ratio - 1.0)];
    let others = others.map(|(other, by)| (other.as_ref(), by));
    let rms = rms_error(run, others);
    let assured = !has_crisis(case);
    let curves = others.map(|(other, by)| (other, if assured { by } else { 1.0 }));
    let curves = published_curve::with_errors(&run.curves, curves);
    let mut warnings = Vec::new();
    if coarse.is_none() {
        warnings
            .push("every section is one segment: the mesh error cannot be estimated".to_owned());
    }
    let mut compare = |other: Option<Computed>, divisor: f64, what| {
        let divisor = if assured { divisor } else { 1.0 };
        other.map_or_else(Vec::new, |other| {
            differences(run, &other, divisor, what, &mut warnings)
        })
    };
    let time = compare(other, by_step, "time");
    let mut mesh = compare(coarse, ratio * ratio - 1.0, "mesh");
    for (error, w) in mesh.iter_mut().zip(&run.wanted) {
        *error = error.map(|e| e.max(line_statistics::resolution(&run.profile, w.statistic)));
    }
    Estimates {
        time,
        mesh,
        modes,
        curves,
        rms,
        method: describe(case, order, times, ratio),
        warnings,
    }
}

/// Errors of the root mean square displacements: sums of the differences from the companions, each by its divisor.
fn rms_error(run: &Computed, others: [(Option<&Computed>, f64); 2]) -> Vec<f64> {
    let arc = &run.profile.arc;
    let told = |other: &Computed| other.profile.rms.len() == other.profile.arc.len();
    let others = others
        .into_iter()
        .filter_map(|(other, by)| Some((&other.filter(|o| told(o))?.profile, by)));
    let others: Vec<_> = others.filter(|(other, _)| other.arc.len() > 1).collect();
    if others.is_empty() {
        return Vec::new();
    }
    let error = |(s, rms): (&f64, &f64)| {
        let each = others.iter();
        each.map(|(other, by)| (linear_clamped(&other.arc, &other.rms, *s) - rms).abs() / by)
            .sum()
    };
    arc.iter().zip(&run.profile.rms).map(error).collect()
}

/// How the errors are estimated, in words.
fn describe(case: &Case, order: Option<i32>, times: f64, ratio: f64) -> String {
    let varies = case.solver.time_step_s.is_none() && case.solver.method == Method::Alpha;
    let step = match (varies, times) {
        (true, 2.0) => "eight times the error allowed in a step".to_owned(),
        (true, _) => format!(
            "{:.3} times the error allowed in a step, the longest {times:.2} times as long",
            times.powi(3)
        ),
        (false, 2.0) => "twice the step".to_owned(),
        (false, _) => format!("{times:.2} times the step"),
    };
    let time = order.map_or_else(String::new, |_| format!("time: {step}; "));
    let how = match order {
        _ if has_crisis(case) => "whole differences, since a drag coefficient jumps".to_owned(),
        Some(order) => format!("by Richardson, orders {order} and 2"),
        None => "by Richardson, order 2".to_owned(),
    };
    format!("{time}mesh: half the segments (ratio {ratio:.2}); {how}")
}

/// Whether any drag coefficient of the line jumps with the speed.
fn has_crisis(case: &Case) -> bool {
    case.line
        .iter()
        .filter_map(|section| case.materials.get(&section.material))
        .any(|material| material.drag_normal == DragLaw::Named(DragLawName::Jia2019Normal))
}

/// The order in time of a method; none for statics.
fn order(method: Method) -> Option<i32> {
    match method {
        Method::Static => None,
        Method::Quasi | Method::Alpha | Method::Auto => Some(2),
        Method::Rk4 => Some(4),
    }
}

/// Length of the companion's steps by that of the run's: twice, where that is to be had. Whole steps divide the output
/// interval, so that of an odd number of them the companion has more than half, and of one it has two. Steps that
/// vary are as a rule so much shorter than the longest that their error sets them, whatever the interval.
fn ratio_of_steps(run: &Computed) -> f64 {
    let settings = &run.settings;
    let march = March {
        duration: settings.duration_s,
        step: settings.time_step_s,
        output: settings.output_interval_s,
    };
    let grid = march.grid();
    let varies = settings.step_tolerance.is_some();
    if varies && run.work.steps >= 2 * grid.outputs * grid.per_output {
        return 2.0;
    }
    match grid.per_output {
        1 => 0.5,
        whole => whole as f64 / whole.div_ceil(2) as f64,
    }
}

/// Segment length of the coarse mesh by that of the fine one, over the whole line.
fn ratio_of_meshes(case: &Case) -> f64 {
    let segments = |coarsening| crate::scene::mesh::segments(case, coarsening) as f64;
    segments(1) / segments(2)
}

fn differences(
    run: &Computed,
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
    // The same case wants the same numbers, in the same order.
    let pairs = run.numbers.iter().zip(&companion.numbers);
    pairs
        .map(|(fine, coarse)| Some((fine.as_ref()? - coarse.as_ref()?).abs() / divisor))
        .collect()
}

/// The single numbers of a run with their errors; those that cannot be taken are left out.
pub(super) fn summary(run: &Computed, estimates: &Estimates) -> Vec<Quantity> {
    let pick = |list: &[Option<f64>], i: usize| list.get(i).copied().flatten();
    // Without companions their errors are unknown.
    let or_bare = |told: &[Quantity], bare: &[Quantity]| {
        let list = if told.is_empty() { bare } else { told };
        list.to_vec()
    };
    let modes = or_bare(&estimates.modes, &run.modes);
    let curves = or_bare(&estimates.curves, &run.curves);
    let all = run.wanted.iter().zip(&run.numbers).enumerate();
    all.filter_map(|(i, (w, number)): (usize, (&RequestedStatistic, _))| {
        let of = match w.of {
            Of::Channel(index) => Subject::Channel(run.history.channels.get(index)?.id.clone()),
            Of::Line(quantity) => Subject::Line(quantity),
        };
        Some(Quantity {
            id: QuantityId::new(of, w.statistic, w.window),
            value: (*number)?,
            time_error: pick(&estimates.time, i),
            mesh_error: pick(&estimates.mesh, i),
        })
    })
    .chain(curves)
    .chain(modes)
    .collect()
}
