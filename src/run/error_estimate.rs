//! Numerical errors of a run, estimated by companions: one with another time step, one with another mesh. Time error and mesh error are
//! kept apart; model error is what a validation table shows.
//!
//! With a method of order p and a ratio r between the steps, the error of the finer result is about
//! `|fine - coarse| / (r^p - 1)` (Richardson). A force that jumps (a drag crisis) leaves no method its order: the whole
//! difference counts then.

use std::sync::atomic::AtomicBool;

use super::compute::{Computed, Resolution, compute};
use super::line_statistics;
use super::requested_statistics::{RequestedStatistic, StatisticSource};
use super::{Quantity, QuantityId, RunState, Subject};
use crate::case::{Case, DragLaw, DragLawName, Method};
use crate::dynamics::march::March;
use crate::numerics::interpolation::linear_clamped;

/// The single numbers of a run with their estimated errors.
#[derive(Debug, Clone, Default)]
pub(super) struct Estimates {
    /// The single numbers; errors are absent where they are not estimated.
    pub(super) summary: Vec<Quantity>,
    /// Error of the root mean square displacements, node by node \[m\], time and mesh together.
    pub(super) rms: Vec<f64>,
    /// How the errors are estimated, in words.
    pub(super) method: String,
    /// What the user should know.
    pub(super) warnings: Vec<String>,
}

/// A companion run, and the divisor that makes an error of a difference from it.
#[derive(Clone, Copy)]
struct Companion<'a> {
    run: Option<&'a Computed>,
    divisor: f64,
}

/// The single numbers without errors.
pub(super) fn without_errors(run: &Computed) -> Estimates {
    let lists = [statistics(run), run.curves.clone(), run.modes.clone()];
    Estimates {
        summary: lists.concat(),
        ..Estimates::default()
    }
}

/// Runs the companions, side by side where there are cores, and estimates the errors of all single numbers.
pub(super) fn estimate(case: &Case, run: &Computed, cancel: &AtomicBool) -> Estimates {
    let order = order(case.solver.method);
    let mesh_ratio = mesh_ratio(case);
    let step_ratio = step_ratio(run);
    let (other_step, coarse) = companions(case, order.map(|_| step_ratio), mesh_ratio, cancel);
    let time = Companion {
        run: other_step.as_ref(),
        divisor: (step_ratio.powi(order.unwrap_or(0)) - 1.0).abs(),
    };
    let mesh = Companion {
        run: coarse.as_ref(),
        divisor: mesh_ratio * mesh_ratio - 1.0,
    };
    let mut warnings = Vec::new();
    if coarse.is_none() {
        let why = "every section is one segment: the mesh error cannot be estimated";
        warnings.push(why.to_owned());
    }
    // Where a force jumps, the whole difference is the error.
    let crisis = has_crisis(case);
    let [by_time, by_mesh] = [time, mesh].map(|companion| Companion {
        divisor: if crisis { 1.0 } else { companion.divisor },
        ..companion
    });
    let mut finished = statistics(run);
    add_errors(
        &mut finished,
        by_time
            .finished("time", &mut warnings)
            .map(|c| (statistics(c), by_time.divisor))
            .as_ref(),
        by_mesh
            .finished("mesh", &mut warnings)
            .map(|c| (statistics(c), by_mesh.divisor))
            .as_ref(),
    );
    limit_resolution(&mut finished, run);
    let of = |c: Companion<'_>, list: fn(&Computed) -> &Vec<Quantity>| {
        c.run.map(|run| (list(run).clone(), c.divisor))
    };
    let mut curves = run.curves.clone();
    add_errors(
        &mut curves,
        of(by_time, |c| &c.curves).as_ref(),
        of(by_mesh, |c| &c.curves).as_ref(),
    );
    let mut modes = run.modes.clone();
    add_errors(&mut modes, None, of(mesh, |c| &c.modes).as_ref());
    Estimates {
        summary: [finished, curves, modes].concat(),
        rms: rms_error(run, [time, mesh]),
        method: describe(case, order, step_ratio, mesh_ratio),
        warnings,
    }
}

/// Computes the case with another step, where a ratio is given, and on a coarser mesh, where there is one.
fn companions(
    case: &Case,
    step_ratio: Option<f64>,
    mesh_ratio: f64,
    cancel: &AtomicBool,
) -> (Option<Computed>, Option<Computed>) {
    let companion = |coarsening, step_ratio| {
        let resolution = Resolution {
            coarsening,
            step_ratio,
        };
        compute(case, resolution, None, cancel, &mut |_| {})
    };
    rayon::join(
        || step_ratio.map(|ratio| companion(1, ratio)),
        || (mesh_ratio > 1.0).then(|| companion(2, 1.0)),
    )
}

impl<'a> Companion<'a> {
    /// The companion, if it came to its end; a warning where it did not.
    fn finished(&self, what: &str, warnings: &mut Vec<String>) -> Option<&'a Computed> {
        let run = self.run?;
        if run.outcome.state == RunState::Done {
            return Some(run);
        }
        let why = run.outcome.failure.as_deref().unwrap_or("it was stopped");
        warnings.push(format!(
            "the {what} error is not estimated, its companion run did not finish: {why}"
        ));
        None
    }
}

/// The statistics of a run, without errors; those that cannot be taken are left out.
fn statistics(run: &Computed) -> Vec<Quantity> {
    let channels = &run.record.history.channels;
    let quantity = |(wanted, number): &(RequestedStatistic, Option<f64>)| {
        let of = match wanted.of {
            StatisticSource::Channel(index) => Subject::Channel(channels.get(index)?.id.clone()),
            StatisticSource::Line(quantity) => Subject::Line(quantity),
        };
        let id = QuantityId::new(of, wanted.statistic, wanted.window);
        Some(Quantity::new(id, (*number)?))
    };
    run.record.statistics.iter().filter_map(quantity).collect()
}

/// Adds the errors: differences from the same numbers of the companions, each by its divisor.
fn add_errors(
    list: &mut [Quantity],
    time: Option<&(Vec<Quantity>, f64)>,
    mesh: Option<&(Vec<Quantity>, f64)>,
) {
    let error = |q: &Quantity, companion: Option<&(Vec<Quantity>, f64)>| {
        let (others, divisor) = companion?;
        let other = others.iter().find(|other| other.id == q.id)?;
        Some((q.value - other.value).abs() / divisor)
    };
    for quantity in list {
        quantity.time_error = error(quantity, time);
        quantity.mesh_error = error(quantity, mesh);
    }
}

/// A place along the line has at least the mesh error of half a segment.
fn limit_resolution(list: &mut [Quantity], run: &Computed) {
    for quantity in list {
        if let QuantityId::Statistic { statistic, .. } = &quantity.id {
            let least = line_statistics::resolution(&run.record.profile, *statistic);
            quantity.mesh_error = quantity.mesh_error.map(|error| error.max(least));
        }
    }
}

/// Errors of the root mean square displacements: sums of the differences from the companions, each by its divisor.
fn rms_error(run: &Computed, companions: [Companion<'_>; 2]) -> Vec<f64> {
    let profile = &run.record.profile;
    let others = companions.into_iter().filter_map(|companion| {
        let other = &companion.run?.record.profile;
        let recorded = other.rms.len() == other.arc.len() && other.arc.len() > 1;
        recorded.then_some((other, companion.divisor))
    });
    let others: Vec<_> = others.collect();
    if others.is_empty() {
        return Vec::new();
    }
    let error = |(s, rms): (&f64, &f64)| {
        let each = others.iter();
        each.map(|(other, by)| (linear_clamped(&other.arc, &other.rms, *s) - rms).abs() / by)
            .sum()
    };
    profile.arc.iter().zip(&profile.rms).map(error).collect()
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
fn step_ratio(run: &Computed) -> f64 {
    let settings = &run.settings;
    let march = March {
        duration: settings.duration_s,
        step: settings.time_step_s,
        output: settings.output_interval_s,
    };
    let grid = march.grid();
    let varies = settings.step_tolerance.is_some();
    if varies && run.outcome.work.steps >= 2 * grid.outputs * grid.per_output {
        return 2.0;
    }
    match grid.per_output {
        1 => 0.5,
        whole => whole as f64 / whole.div_ceil(2) as f64,
    }
}

/// Segment length of the coarse mesh by that of the fine one, over the whole line.
fn mesh_ratio(case: &Case) -> f64 {
    let segments = |coarsening| crate::scene::mesh::segments(case, coarsening) as f64;
    segments(1) / segments(2)
}
