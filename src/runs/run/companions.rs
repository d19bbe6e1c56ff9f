//! The companions of a run: the same case with longer steps and on coarser meshes, to tell its errors by.
//!
//! They are a sequence: each is coarser than the one before it in its steps or in its mesh only. A pair of neighbours shows the error
//! in time or that of the mesh, the next such pair the order by which it falls. Each costs about half of the one before it or
//! less, so that all of them cost less than the run.

mod pairs;

use std::borrow::Cow;
use std::sync::atomic::AtomicBool;

use rayon::prelude::*;

use super::RunState;
use super::compute::Computed;
use super::refinable::Refinable;
use crate::numerics::richardson::Refinement;
pub use pairs::CompanionRefinement;
pub(super) use pairs::{CRISIS, Coarsening, named};
use pairs::{
    Pairs, RUN, asks_for_nearest, at, coarsens, finer_mesh, has_mesh, has_third, is_single_step,
    mesh_ratio, meshes_in_steps, on_the_own_mesh, order, pairs_in_time, pairs_of, pairs_of_meshes,
    place_of,
};

/// What shows one error of a run: the nearest pair of runs that differ in one thing only, and the next.
#[derive(Debug)]
pub(super) struct Evidence<'a> {
    pub(super) near: [&'a Computed; 2],
    /// Absent where no such pair was complete, or none was computed.
    pub(super) far: Option<[&'a Computed; 2]>,
    /// Ratio between the two runs of a pair, and order.
    pub(super) refinement: Refinement,
    /// Length of the longest steps in each pair by those of the run.
    pub(super) ratios: [f64; 2],
    /// The run is as coarse as the coarser of the nearest pair, not as fine as the finer.
    pub(super) is_finer: bool,
    /// Length of the segments in the last pair by those of the run.
    pub(super) segment: f64,
    /// The nearest pair has other steps than the run.
    pub(super) is_elsewhere: bool,
}

impl Evidence<'_> {
    /// Error of a value by its difference in the nearest pair alone, where the order is not observed.
    pub(super) fn presumed(&self, difference: f64) -> f64 {
        // Of the coarser of the two results: `r^p / (r^p - 1)` of the difference.
        let by = self.refinement.ratio.powf(self.refinement.order);
        let share = if self.is_finer { by } else { 1.0 };
        share * self.refinement.presumed(difference, 0.0)
    }

    /// Whether the run is a single step, and its companion has two.
    pub(super) fn is_single_step(&self) -> bool {
        self.refinement.ratio < 1.0
    }
}

/// The companions of a run, computed.
pub(super) struct Companions<'a> {
    case: &'a dyn Refinable,
    run: &'a Computed,
    cancel: &'a AtomicBool,
    computed: Vec<(CompanionRefinement, Cow<'a, Computed>)>,
    time: Option<Pairs>,
    /// Absent where nothing is divided into segments.
    mesh: Option<Pairs>,
}

impl<'a> Companions<'a> {
    /// Computes those that the case names, or those that tell the errors at the least cost, side by side where there are cores.
    pub(super) fn of_run(
        case: &'a dyn Refinable,
        run: &'a Computed,
        cancel: &'a AtomicBool,
    ) -> Self {
        if let Some(coarsenings) = named(case) {
            return Self::coarsened_by(case, run, &coarsenings, &[], cancel);
        }
        let coarsens = coarsens(case);
        let time = pairs_in_time(case, run, coarsens);
        let mesh = has_mesh(case).then(|| pairs_of_meshes(case, time.as_ref(), coarsens));
        let companions = Self {
            case,
            run,
            cancel,
            computed: Vec::new(),
            time,
            mesh,
        };
        if asks_for_nearest(case) {
            companions.beside_the_run()
        } else {
            companions.complete()
        }
    }

    /// Those of a sequence, the first of which are known; as where a case names none for an error that it does not show.
    pub(super) fn coarsened_by(
        case: &'a dyn Refinable,
        run: &'a Computed,
        coarsenings: &[Coarsening],
        known: &[&'a Computed],
        cancel: &'a AtomicBool,
    ) -> Self {
        let places =
            (1..=known.len()).map(|count| place_of(&coarsenings[..count.min(coarsenings.len())]));
        let known = places.zip(known.iter().map(|run| Cow::Borrowed(*run)));
        let time = order(case).and_then(|_| pairs_of(coarsenings, Coarsening::Steps));
        let coarsens = coarsens(case);
        let time = time.or_else(|| pairs_in_time(case, run, coarsens));
        let named = pairs_of(coarsenings, Coarsening::Mesh);
        let usual = || pairs_of_meshes(case, time.as_ref(), coarsens);
        let mesh = has_mesh(case).then(|| named.unwrap_or_else(usual));
        Self {
            case,
            run,
            cancel,
            computed: known.collect(),
            time,
            mesh,
        }
        .complete()
    }

    /// Computes coarser steps on the mesh of the run, and coarser meshes in its steps: dearer, and nearer to it.
    pub(super) fn beside_the_run(mut self) -> Self {
        if self.time.is_some() && !is_single_step(self.run) {
            let far = has_third(self.case).then_some([at(1.0, 2.0), at(1.0, 4.0)]);
            self.time = Some(Pairs {
                near: [RUN, at(1.0, 2.0)],
                far,
            });
        }
        if coarsens(self.case) {
            self.mesh = Some(meshes_in_steps(self.case, 1.0));
        }
        self.complete()
    }

    /// Whether [`Companions::beside_the_run`] has companions that these do not have.
    pub(super) fn can_be_nearer(&self) -> bool {
        self.case.named().is_none()
            && self.case.method_order().is_some()
            && coarsens(self.case)
            && has_third(self.case)
    }

    /// Computes what is missing, and others in the place of those that do not come to their end.
    fn complete(mut self) -> Self {
        let places = self.time.iter().chain(&self.mesh).flat_map(Pairs::places);
        self.compute(&places.collect::<Vec<_>>());
        if let Some(time) = self.time
            && !(self.are_done(Some(time.near)) && self.are_done(time.far))
            && let Some(other) = on_the_own_mesh(self.case, self.run)
        {
            self.time = Some(other);
            self.compute(&other.places().collect::<Vec<_>>());
        }
        for mesh in [meshes_in_steps(self.case, 1.0), finer_mesh(1.0)] {
            if self.are_done(self.mesh.map(|mesh| mesh.near)) {
                break;
            }
            self.mesh = Some(mesh);
            self.compute(&mesh.places().collect::<Vec<_>>());
        }
        self
    }

    /// Computes the companions at these places that are not there yet.
    fn compute(&mut self, places: &[CompanionRefinement]) {
        let mut missing: Vec<CompanionRefinement> = Vec::new();
        for place in places {
            let known = self.computed.iter().any(|(known, _)| known == place);
            if *place != RUN && !known && !missing.contains(place) {
                missing.push(*place);
            }
        }
        let (case, cancel) = (self.case, self.cancel);
        let computed = missing
            .into_par_iter()
            .map(|place| (place, Cow::Owned(case.companion(place, cancel))));
        self.computed.extend(computed.collect::<Vec<_>>());
    }

    fn at(&self, place: CompanionRefinement) -> Option<&Computed> {
        if place == RUN {
            return Some(self.run);
        }
        let found = self.computed.iter().find(|(at, _)| *at == place);
        found.map(|(_, computed)| computed.as_ref())
    }

    fn done(&self, pair: Option<[CompanionRefinement; 2]>) -> Option<[&Computed; 2]> {
        let [fine, coarse] = pair?.map(|place| self.at(place));
        let pair = [fine?, coarse?];
        let all = pair.iter().all(|run| run.outcome.state == RunState::Done);
        all.then_some(pair)
    }

    /// Whether a pair is complete, or there is none.
    fn are_done(&self, pair: Option<[CompanionRefinement; 2]>) -> bool {
        pair.is_none() || self.done(pair).is_some()
    }

    /// What shows the error in time: none for statics, and why not where a companion did not come to its end.
    pub(super) fn time(&self) -> Option<Result<Evidence<'_>, String>> {
        let (pairs, order) = (self.time?, order(self.case)?);
        let near = self.done(Some(pairs.near));
        Some(near.ok_or_else(|| self.failure(&pairs)).map(|near| {
            let ratio = pairs.near[1].step / pairs.near[0].step;
            Evidence {
                near,
                far: self.done(pairs.far),
                refinement: Refinement {
                    ratio: effective_ratio(self.run, near, ratio),
                    order,
                },
                ratios: [pairs.near[1].step, pairs.far.map_or(1.0, |far| far[1].step)],
                is_finer: false,
                segment: pairs.far.unwrap_or(pairs.near)[0].segment,
                is_elsewhere: false,
            }
        }))
    }

    /// What shows the error of the mesh: none where nothing has a mesh.
    pub(super) fn mesh(&self) -> Option<Result<Evidence<'_>, String>> {
        let pairs = self.mesh?;
        let near = self.done(Some(pairs.near));
        Some(near.ok_or_else(|| self.failure(&pairs)).map(|near| {
            let is_finer = pairs.near[0].segment < 1.0;
            Evidence {
                near,
                far: self.done(pairs.far),
                refinement: Refinement {
                    ratio: if is_finer {
                        2.0
                    } else {
                        mesh_ratio(self.case, 2)
                    },
                    order: if self.case.has_crisis() { CRISIS } else { 2.0 },
                },
                ratios: [pairs.near[1].step, pairs.far.map_or(1.0, |far| far[1].step)],
                is_finer,
                segment: pairs.far.unwrap_or(pairs.near)[1].segment,
                is_elsewhere: pairs.near[0].step != 1.0,
            }
        }))
    }

    /// Why the nearest pair is not complete.
    fn failure(&self, pairs: &Pairs) -> String {
        let failed = pairs
            .near
            .iter()
            .filter_map(|place| self.at(*place))
            .find(|run| run.outcome.state != RunState::Done);
        failed
            .and_then(|run| run.outcome.failure.clone())
            .unwrap_or_else(|| "it was stopped".to_owned())
    }
}

/// Length of the steps of a pair's coarser run by that of its finer one, of steps that vary by their numbers: as asked where the error
/// sets them, and less where something else does. Steps that are hardly longer say little, and their difference counts more.
fn effective_ratio(run: &Computed, [fine, coarse]: [&Computed; 2], ratio: f64) -> f64 {
    const LEAST: f64 = 1.1;
    if run.settings.step_tolerance.is_none() {
        return ratio;
    }
    let (fine, coarse) = (fine.outcome.work.steps, coarse.outcome.work.steps);
    (fine as f64 / coarse.max(1) as f64).clamp(LEAST, ratio.max(LEAST))
}
