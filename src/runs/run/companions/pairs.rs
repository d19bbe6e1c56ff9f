//! Where companions stand by the run, and which pairs of them show an error.

use super::super::compute::Computed;
use crate::dynamics::march::March;
use crate::run::refinable::Refinable;

/// The order where a force jumps.
pub(in crate::run) const CRISIS: f64 = 1.5;

/// Steps of a companion by those of the next finer one, where its method is implicit.
pub(super) const LONGER: f64 = 3.0;

/// Mesh and steps of a companion, by those of the run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CompanionRefinement {
    /// Length of the segments: a power of two times the run's.
    pub segment: f64,
    /// Length of the steps; the error in time grows by this to the power of the method's order.
    pub step: f64,
}

/// The run itself.
pub(super) const RUN: CompanionRefinement = at(1.0, 1.0);

pub(super) const fn at(segment: f64, step: f64) -> CompanionRefinement {
    CompanionRefinement { segment, step }
}

/// Pairs of runs that differ in the steps alone or in the mesh alone, the finer first in each.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pairs {
    /// The pair nearest to the run.
    pub(super) near: [CompanionRefinement; 2],
    /// The next one, whose finer run is as coarse as the coarser of the first.
    pub(super) far: Option<[CompanionRefinement; 2]>,
}

impl Pairs {
    pub(super) fn places(&self) -> impl Iterator<Item = CompanionRefinement> {
        self.near.into_iter().chain(self.far.into_iter().flatten())
    }
}

/// What a companion is coarser in than the next finer one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::run) enum Coarsening {
    /// Steps twice as long.
    Steps,
    /// Half the segments on every section.
    Mesh,
}

impl Coarsening {
    /// Its word in `solver.companions`.
    pub(in crate::run) const fn word(self) -> &'static str {
        match self {
            Self::Steps => "steps",
            Self::Mesh => "mesh",
        }
    }

    pub(super) fn of_word(word: &str) -> Option<Self> {
        [Self::Steps, Self::Mesh]
            .into_iter()
            .find(|coarser| coarser.word() == word)
    }
}

/// The word in `solver.companions` for those nearest to the run.
pub(super) const NEAREST: &str = "nearest";

/// The companions that a case names, from the finest; none where it leaves them open.
pub(in crate::run) fn named(case: &dyn Refinable) -> Option<Vec<Coarsening>> {
    let words = case.named()?;
    let coarser = words.iter().map(|word| Coarsening::of_word(word));
    coarser.collect()
}

/// Whether a case asks for companions on its own mesh and in its own steps.
pub(super) fn asks_for_nearest(case: &dyn Refinable) -> bool {
    let words = case.named();
    words.is_some_and(|words| words.iter().any(|word| word == NEAREST))
}

/// The first two pairs of a sequence that differ in this.
pub(super) fn pairs_of(coarsenings: &[Coarsening], what: Coarsening) -> Option<Pairs> {
    let mut place = RUN;
    let mut pairs = Vec::new();
    for coarser in coarsenings {
        let finer = place;
        match coarser {
            Coarsening::Steps => place.step *= 2.0,
            Coarsening::Mesh => place.segment *= 2.0,
        }
        if *coarser == what {
            pairs.push([finer, place]);
        }
    }
    Some(Pairs {
        near: *pairs.first()?,
        far: pairs.get(1).copied(),
    })
}

/// Longer steps, and on the coarsest mesh longer ones still. Explicit methods have twice the steps on half the segments. Half the
/// step where the run is a single step. None for statics.
pub(super) fn pairs_in_time(case: &dyn Refinable, run: &Computed, coarsens: bool) -> Option<Pairs> {
    order(case)?;
    if !coarsens || is_single_step(run) {
        return on_the_own_mesh(case, run).or(Some(Pairs {
            near: [RUN, at(1.0, 0.5)],
            far: None,
        }));
    }
    if !has_third(case) {
        // Where no step is set, explicit steps are as long as the segments let them be: their error there is no less.
        return Some(Pairs {
            near: [at(2.0, 1.0), at(2.0, 2.0)],
            far: None,
        });
    }
    let (long, longer) = (LONGER, LONGER * LONGER);
    let coarsest = if has_third_mesh(case) { 4.0 } else { 2.0 };
    Some(Pairs {
        near: [RUN, at(1.0, long)],
        far: Some([at(coarsest, long), at(coarsest, longer)]),
    })
}

/// Longer steps on the mesh of the run; none where it is a single step.
pub(super) fn on_the_own_mesh(case: &dyn Refinable, run: &Computed) -> Option<Pairs> {
    if is_single_step(run) {
        return None;
    }
    let has_third = has_third(case);
    let long = if has_third { LONGER } else { 2.0 };
    Some(Pairs {
        near: [RUN, at(1.0, long)],
        far: has_third.then_some([at(1.0, long), at(1.0, long * long)]),
    })
}

/// Meshes in the longer steps of the first pair in time, where they go on from there.
pub(super) fn pairs_of_meshes(case: &dyn Refinable, time: Option<&Pairs>, coarsens: bool) -> Pairs {
    let longer = time.filter(|time| time.far.is_some());
    let step = longer.map_or(1.0, |time| time.near[1].step);
    if coarsens {
        meshes_in_steps(case, step)
    } else {
        finer_mesh(step)
    }
}

/// Segments twice as long and four times.
pub(super) fn meshes_in_steps(case: &dyn Refinable, step: f64) -> Pairs {
    let far = [at(2.0, step), at(4.0, step)];
    Pairs {
        near: [at(1.0, step), at(2.0, step)],
        far: has_third_mesh(case).then_some(far),
    }
}

/// Whether the mesh can be made coarser a second time.
pub(super) fn has_third_mesh(case: &dyn Refinable) -> bool {
    mesh_ratio(case, 4) > 1.5 * mesh_ratio(case, 2)
}

/// Segments half as long, where there is no coarser mesh or none whose run is complete.
pub(super) fn finer_mesh(step: f64) -> Pairs {
    Pairs {
        near: [at(0.5, step), at(1.0, step)],
        far: None,
    }
}

/// Mesh and steps after these coarsenings.
pub(super) fn place_of(coarsenings: &[Coarsening]) -> CompanionRefinement {
    let count = |what| {
        coarsenings
            .iter()
            .filter(|coarser| **coarser == what)
            .count() as i32
    };
    at(
        2.0_f64.powi(count(Coarsening::Mesh)),
        2.0_f64.powi(count(Coarsening::Steps)),
    )
}

/// Explicit steps four times as long are not stable.
pub(super) fn has_third(case: &dyn Refinable) -> bool {
    !case.is_explicit()
}

/// Whether anything is divided into segments.
pub(super) fn has_mesh(case: &dyn Refinable) -> bool {
    case.segments(1) > 0
}

/// Whether there is a coarser mesh, and no section is a single segment, which has none.
pub(super) fn coarsens(case: &dyn Refinable) -> bool {
    mesh_ratio(case, 2) > 1.0 && !case.has_single_segment()
}

/// Segment length of the coarse mesh by that of the fine one, over the whole line.
pub(super) fn mesh_ratio(case: &dyn Refinable, coarsening: usize) -> f64 {
    let segments = |coarsening| case.segments(coarsening) as f64;
    segments(1) / segments(coarsening)
}

/// The order in time of the case's method; none for statics. A force that jumps leaves none its order: that of
/// all results together on cases with a drag crisis is about 3/2.
pub(super) fn order(case: &dyn Refinable) -> Option<f64> {
    let order = case.method_order()?;
    Some(if case.has_crisis() { CRISIS } else { order })
}

/// Whether the run is a single step.
pub(super) fn is_single_step(run: &Computed) -> bool {
    let march = March {
        duration: run.settings.duration_s,
        step: run.settings.time_step_s,
    };
    march.whole_steps() <= 1
}
