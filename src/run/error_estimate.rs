//! Numerical errors of a run, estimated by companions: one with another time step, and others with other meshes. Time error and mesh
//! error are kept apart; model error is what a validation table shows.
//!
//! With an order p and a ratio r between the steps, the error of the finer result is about `|fine - coarse| / (r^p - 1)`
//! (Richardson), times a factor of safety (Roache 1994, doi 10.1115/1.2910291): 1.25 where the order is observed on three meshes,
//! 3 where it is that of the method. The order observed is held between 1/2 and 2; differences that do not fall from mesh to
//! mesh count as of order 1/2. A force that jumps (a drag crisis) leaves no method its order: the whole difference counts
//! then.

use std::sync::atomic::AtomicBool;

use super::compute::{Computed, Resolution, compute};
use super::line_statistics;
use super::requested_statistics::{RequestedStatistic, StatisticSource};
use super::{Quantity, QuantityId, RunState, Subject};
use crate::case::{Case, DragCoefficient, DragLawName, Method};
use crate::dynamics::march::March;
use crate::numerics::interpolation::linear_clamped;

/// The single numbers of a run with their estimated errors.
#[derive(Debug, Clone, Default)]
pub(super) struct ErrorEstimates {
    /// The single numbers; errors are absent where they are not estimated.
    pub(super) summary: Vec<Quantity>,
    /// Error of the root mean square displacements, node by node \[m\], time and mesh together.
    pub(super) rms: Vec<f64>,
    /// How the errors are estimated, in words.
    pub(super) method: String,
    /// What the user should know.
    pub(super) warnings: Vec<String>,
}

/// Factor of safety of an observed order, and of one that is presumed.
const OBSERVED: f64 = 1.25;
const PRESUMED: f64 = 3.0;
/// The orders in the mesh that an observation may give.
const ORDERS: [f64; 2] = [0.5, 2.0];

/// A companion run, and what makes an error of a difference from it: a factor or, where there is a third run on a mesh twice as
/// coarse, the order observed.
#[derive(Clone, Copy)]
struct Companion<'a> {
    run: Option<&'a Computed>,
    factor: f64,
    /// The third run, and the ratio between the meshes.
    third: Option<(&'a Computed, f64)>,
}

/// Companions on other meshes.
#[derive(Default)]
struct MeshCompanions {
    /// Segments twice as long, and four times.
    coarse: Option<Computed>,
    coarser: Option<Computed>,
    /// Segments half as long, where there is no coarser mesh or none whose run is complete.
    finer: Option<Computed>,
}

/// The single numbers without errors.
pub(super) fn without_errors(run: &Computed) -> ErrorEstimates {
    let lists = [
        statistics(run),
        run.curves.clone(),
        run.modes.clone(),
        run.record.energy.clone(),
    ];
    ErrorEstimates {
        summary: lists.concat(),
        ..ErrorEstimates::default()
    }
}

/// Runs the companions, side by side where there are cores, and estimates the errors of all single numbers.
pub(super) fn estimate(case: &Case, run: &Computed, cancel: &AtomicBool) -> ErrorEstimates {
    let order = order(case.solver.method);
    let ratio = mesh_ratio(case, 2);
    let step_ratio = step_ratio(run);
    let (other_step, meshes) = companions(case, order.map(|_| step_ratio), cancel);
    // Where a force jumps, the whole difference is the error.
    let crisis = has_crisis(case);
    let time = Companion {
        run: other_step.as_ref(),
        factor: other_step.as_ref().map_or(1.0, |other| {
            let ratio = effective_ratio(run, other, step_ratio);
            let by_order = PRESUMED / (ratio.powi(order.unwrap_or(0)) - 1.0).abs();
            if crisis { 1.0 } else { by_order }
        }),
        third: None,
    };
    let mesh = meshes.companion(case, crisis);
    let mut warnings = Vec::new();
    let mut finished = statistics(run);
    add_errors(
        &mut finished,
        time.finished("time", &mut warnings),
        mesh.finished("mesh", &mut warnings),
        statistics,
    );
    limit_resolution(&mut finished, run);
    let mut curves = run.curves.clone();
    add_errors(&mut curves, time.whole(), mesh.whole(), |c| {
        c.curves.clone()
    });
    let mut modes = run.modes.clone();
    add_errors(&mut modes, None, mesh.whole(), |c| c.modes.clone());
    let mut energy = run.record.energy.clone();
    add_errors(&mut energy, time.whole(), mesh.whole(), |c| {
        c.record.energy.clone()
    });
    ErrorEstimates {
        summary: [finished, curves, modes, energy].concat(),
        rms: rms_error(run, [time, mesh]),
        method: describe(case, order, step_ratio, &mesh.describe(ratio)),
        warnings,
    }
}

/// Computes the case with another step, where a ratio is given, and on other meshes.
fn companions(
    case: &Case,
    step_ratio: Option<f64>,
    cancel: &AtomicBool,
) -> (Option<Computed>, MeshCompanions) {
    let companion = |coarsening, step_ratio| {
        let resolution = Resolution {
            coarsening,
            step_ratio,
        };
        compute(case, resolution, None, cancel, &mut |_| {})
    };
    let done = |run: &Computed| run.outcome.state == RunState::Done;
    let meshes = || {
        let coarse = (mesh_ratio(case, 2) > 1.0 && every_section_coarsens(case))
            .then(|| companion(2, 1.0))
            .filter(done);
        if coarse.is_none() {
            let finer = compute(&halved(case), Resolution::AS_SET, None, cancel, &mut |_| {});
            return MeshCompanions {
                finer: Some(finer),
                ..MeshCompanions::default()
            };
        }
        let coarser = mesh_ratio(case, 4) > 1.5 * mesh_ratio(case, 2);
        let coarser = coarser.then(|| companion(4, 1.0)).filter(done);
        MeshCompanions {
            coarse,
            coarser,
            finer: None,
        }
    };
    rayon::join(|| step_ratio.map(|ratio| companion(1, ratio)), meshes)
}

/// Whether no section is a single segment, which has no coarser mesh.
fn every_section_coarsens(case: &Case) -> bool {
    case.line.iter().all(|section| section.segments > 1)
}

/// The case with segments half as long.
fn halved(case: &Case) -> Case {
    let mut case = case.clone();
    for section in &mut case.line {
        section.segments *= 2;
    }
    case
}

impl MeshCompanions {
    /// The mesh that errors are estimated from.
    fn companion(&self, case: &Case, crisis: bool) -> Companion<'_> {
        let ratio = mesh_ratio(case, 2);
        let (run, factor) = match (&self.coarse, &self.finer) {
            (Some(coarse), _) => (Some(coarse), PRESUMED / (ratio * ratio - 1.0)),
            // Of the coarser of the two results: `r^p / (r^p - 1)` of the difference.
            (None, finer) => (finer.as_ref(), PRESUMED * 4.0 / 3.0),
        };
        let third = self
            .coarser
            .as_ref()
            .filter(|_| self.coarse.is_some() && !crisis);
        Companion {
            run,
            factor: if crisis { 1.0 } else { factor },
            third: third.map(|third| (third, ratio)),
        }
    }
}

impl<'a> Companion<'a> {
    /// How an error of the mesh comes from it, in words.
    fn describe(&self, ratio: f64) -> String {
        match (self.run, self.third) {
            (None, _) => "not estimated".to_owned(),
            (Some(_), Some(_)) => format!(
                "half the segments and a quarter (ratio {ratio:.2}), {OBSERVED} times Richardson by the order observed"
            ),
            (Some(_), None) if ratio > 1.0 && self.factor <= PRESUMED => {
                format!(
                    "half the segments (ratio {ratio:.2}), {PRESUMED} times Richardson, order 2"
                )
            }
            _ => format!("twice the segments, {PRESUMED} times Richardson, order 2"),
        }
    }

    /// The same, if there is a run.
    fn whole(self) -> Option<Self> {
        self.run.map(|_| self)
    }

    /// The same, if the companion came to its end; a warning where it did not.
    fn finished(self, what: &str, warnings: &mut Vec<String>) -> Option<Self> {
        let run = self.run?;
        if run.outcome.state == RunState::Done {
            return Some(self);
        }
        let why = run.outcome.failure.as_deref().unwrap_or("it was stopped");
        warnings.push(format!(
            "the {what} error is not estimated, its companion run did not finish: {why}"
        ));
        None
    }

    /// The error of a value, by those of the companion and of the third run.
    fn error(&self, value: f64, other: f64, third: Option<f64>) -> f64 {
        let difference = value - other;
        let Some((third, (_, ratio))) = third.zip(self.third) else {
            return self.factor * difference.abs();
        };
        if difference == 0.0 {
            return 0.0;
        }
        let growth = (other - third) / difference;
        let order = (growth.max(f64::MIN_POSITIVE).ln() / ratio.ln()).clamp(ORDERS[0], ORDERS[1]);
        OBSERVED * difference.abs() / (ratio.powf(order) - 1.0)
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

/// A companion with its numbers and those of the third run.
type CompanionNumbers<'a> = (Companion<'a>, Vec<Quantity>, Option<Vec<Quantity>>);

/// Adds the errors, by the same numbers of the companions.
fn add_errors(
    list: &mut [Quantity],
    time: Option<Companion<'_>>,
    mesh: Option<Companion<'_>>,
    numbers: impl Fn(&Computed) -> Vec<Quantity>,
) {
    let [time, mesh] = [time, mesh].map(|companion| {
        let companion = companion?;
        let third = companion.third.map(|(third, _)| numbers(third));
        Some((companion, numbers(companion.run?), third))
    });
    let same = |list: &[Quantity], q: &Quantity| {
        let found = list.iter().find(|other| other.id == q.id);
        found.map(|other| other.value)
    };
    let error = |q: &Quantity, read: Option<&CompanionNumbers<'_>>| {
        let (companion, others, third) = read?;
        let third = third.as_ref().and_then(|third| same(third, q));
        Some(companion.error(q.value, same(others, q)?, third))
    };
    for quantity in list {
        quantity.time_error = error(quantity, time.as_ref());
        quantity.mesh_error = error(quantity, mesh.as_ref());
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

/// Errors of the root mean square displacements: sums of the differences from the companions, each times its factor.
fn rms_error(run: &Computed, companions: [Companion<'_>; 2]) -> Vec<f64> {
    let profile = &run.record.profile;
    let others = companions.into_iter().filter_map(|companion| {
        let other = &companion.run?.record.profile;
        let recorded = other.rms.len() == other.arc.len() && other.arc.len() > 1;
        recorded.then_some((other, companion.factor))
    });
    let others: Vec<_> = others.collect();
    if others.is_empty() {
        return Vec::new();
    }
    let error = |(s, rms): (&f64, &f64)| {
        let each = others.iter();
        each.map(|(other, by)| (linear_clamped(&other.arc, &other.rms, *s) - rms).abs() * by)
            .sum()
    };
    profile.arc.iter().zip(&profile.rms).map(error).collect()
}

/// How the errors are estimated, in words.
fn describe(case: &Case, order: Option<i32>, times: f64, mesh: &str) -> String {
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
        Some(order) => format!("{PRESUMED} times Richardson in time, order {order}"),
        None => String::new(),
    };
    let how = if how.is_empty() {
        how
    } else {
        format!("; {how}")
    };
    format!("{time}mesh: {mesh}{how}")
}

/// Whether any drag coefficient of the line jumps with the speed.
fn has_crisis(case: &Case) -> bool {
    case.line
        .iter()
        .filter_map(|section| case.materials.get(&section.material))
        .any(|material| material.drag_normal == DragCoefficient::Named(DragLawName::Jia2019Normal))
}

/// The order in time of a method; none for statics.
fn order(method: Method) -> Option<i32> {
    match method {
        Method::Static => None,
        Method::Quasi | Method::Alpha | Method::Auto => Some(2),
        Method::Rk4 => Some(4),
    }
}

/// Length of the companion's steps by that of the run's: twice, and half where the run is a single step.
fn step_ratio(run: &Computed) -> f64 {
    let march = March {
        duration: run.settings.duration_s,
        step: run.settings.time_step_s,
    };
    if march.whole_steps() > 1 { 2.0 } else { 0.5 }
}

/// The same of steps that vary, by their numbers: those of the companion are twice as long where the error sets them, and less
/// where something else does. Steps that are hardly longer say little, and their difference counts more.
fn effective_ratio(run: &Computed, companion: &Computed, ratio: f64) -> f64 {
    const LEAST: f64 = 1.1;
    if run.settings.step_tolerance.is_none() {
        return ratio;
    }
    let (fine, coarse) = (run.outcome.work.steps, companion.outcome.work.steps);
    (fine as f64 / coarse.max(1) as f64).clamp(LEAST, ratio.max(LEAST))
}

/// Segment length of the coarse mesh by that of the fine one, over the whole line.
fn mesh_ratio(case: &Case, coarsening: usize) -> f64 {
    let segments = |coarsening| crate::scene::mesh::segments(case, coarsening) as f64;
    segments(1) / segments(coarsening)
}
