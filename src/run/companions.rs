//! The companions of a run: the same case with other time steps and on other meshes.

use std::sync::atomic::AtomicBool;

use super::RunState;
use super::compute::{Computed, Resolution, compute};
use crate::case::{Case, DragCoefficient, DragLawName, Method};
use crate::dynamics::march::March;
use crate::numerics::richardson::Refinement;

/// The order where a force jumps.
pub(super) const CRISIS: f64 = 1.5;

/// What a run is compared with, by step or by mesh.
#[derive(Debug)]
pub(super) struct Companions {
    /// The next coarser run; for a mesh that cannot be coarsened the next finer one.
    pub(super) coarse: Computed,
    /// The one after it.
    pub(super) coarser: Option<Computed>,
    /// Ratio between them, and order.
    pub(super) refinement: Refinement,
    /// The companion is the finer of the two.
    pub(super) is_finer: bool,
}

impl Companions {
    /// Why the companion did not come to its end; none where it did.
    pub(super) fn failure(&self) -> Option<&str> {
        let outcome = &self.coarse.outcome;
        let why = outcome.failure.as_deref().unwrap_or("it was stopped");
        (outcome.state != RunState::Done).then_some(why)
    }

    /// Whether the run is a single step, and its companion has two.
    pub(super) fn is_single_step(&self) -> bool {
        self.refinement.ratio < 1.0
    }

    /// Error of a value by that of the companion, where the order is not observed.
    pub(super) fn presumed(&self, value: f64, coarse: f64) -> f64 {
        // Of the coarser of the two results: `r^p / (r^p - 1)` of the difference.
        let by = self.refinement.ratio.powf(self.refinement.order);
        let share = if self.is_finer { by } else { 1.0 };
        share * self.refinement.presumed(value, coarse)
    }
}

/// Runs the companions by step and by mesh, side by side where there are cores.
pub(super) fn compute_all(
    case: &Case,
    run: &Computed,
    cancel: &AtomicBool,
) -> (Option<Companions>, Companions) {
    rayon::join(|| by_step(case, run, cancel), || by_mesh(case, cancel))
}

fn companion(case: &Case, coarsening: usize, step_ratio: f64, cancel: &AtomicBool) -> Computed {
    let resolution = Resolution {
        coarsening,
        step_ratio,
    };
    // Cycles along the line are counted by the run itself.
    let case = Case {
        checks: Vec::new(),
        ..case.clone()
    };
    compute(&case, resolution, None, cancel, &mut |_| {})
}

fn is_done(run: &Computed) -> bool {
    run.outcome.state == RunState::Done
}

/// Steps twice as long and four times; half as long where the run is a single step. None for statics.
fn by_step(case: &Case, run: &Computed, cancel: &AtomicBool) -> Option<Companions> {
    let order = order(case)?;
    let ratio = step_ratio(run);
    let (coarse, coarser) = rayon::join(
        || companion(case, 1, ratio, cancel),
        || (ratio > 1.0 && has_third(case)).then(|| companion(case, 1, ratio * ratio, cancel)),
    );
    let refinement = Refinement {
        ratio: effective_ratio(run, &coarse, ratio),
        order,
    };
    Some(Companions {
        coarser: coarser.filter(is_done),
        coarse,
        refinement,
        is_finer: false,
    })
}

/// Explicit steps four times as long are not stable.
fn has_third(case: &Case) -> bool {
    case.solver.method != Method::Rk4
}

/// Segments twice as long and four times; half as long where there is no coarser mesh or none whose run is complete.
fn by_mesh(case: &Case, cancel: &AtomicBool) -> Companions {
    let order = if has_crisis(case) { CRISIS } else { 2.0 };
    let ratio = mesh_ratio(case, 2);
    let coarsens = ratio > 1.0 && every_section_coarsens(case);
    let has_third = coarsens && mesh_ratio(case, 4) > 1.5 * ratio;
    let (coarse, coarser) = rayon::join(
        || coarsens.then(|| companion(case, 2, 1.0, cancel)),
        || has_third.then(|| companion(case, 4, 1.0, cancel)),
    );
    match coarse.filter(is_done) {
        Some(coarse) => Companions {
            coarse,
            coarser: coarser.filter(is_done),
            refinement: Refinement { ratio, order },
            is_finer: false,
        },
        None => Companions {
            coarse: companion(&halved(case), 1, 1.0, cancel),
            coarser: None,
            refinement: Refinement { ratio: 2.0, order },
            is_finer: true,
        },
    }
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

/// Segment length of the coarse mesh by that of the fine one, over the whole line.
fn mesh_ratio(case: &Case, coarsening: usize) -> f64 {
    let segments = |coarsening| crate::scene::mesh::segments(case, coarsening) as f64;
    segments(1) / segments(coarsening)
}

/// The order in time of the case's method; none for statics. A force that jumps leaves none its order: that of
/// all results together on cases with a drag crisis is about 3/2.
fn order(case: &Case) -> Option<f64> {
    match case.solver.method {
        Method::Static => None,
        _ if has_crisis(case) => Some(CRISIS),
        Method::Quasi | Method::Alpha | Method::Auto => Some(2.0),
        Method::Rk4 => Some(4.0),
    }
}

/// Whether any drag coefficient of the line jumps with the speed.
pub(super) fn has_crisis(case: &Case) -> bool {
    case.line
        .iter()
        .filter_map(|section| case.materials.get(&section.material))
        .any(|material| material.drag_normal == DragCoefficient::Named(DragLawName::Jia2019Normal))
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
