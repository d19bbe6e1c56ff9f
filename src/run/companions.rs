//! The companions of a run: the same case with longer steps and on coarser meshes, to tell its errors by.
//!
//! They stand below the run like stairs: each is coarser than the one above it in its steps or in its mesh only. A pair of neighbours
//! shows the error in time or that of the mesh, the next such pair further down the order by which it falls. Each costs about half
//! of the one above it or less, so that all of them cost less than the run.

use std::borrow::Cow;
use std::sync::atomic::AtomicBool;

use rayon::prelude::*;

use super::RunState;
use super::compute::{Computed, Resolution, compute};
use crate::case::{Case, DragCoefficient, DragLawName, Method};
use crate::dynamics::march::March;
use crate::numerics::richardson::Refinement;

/// The order where a force jumps.
pub(super) const CRISIS: f64 = 1.5;

/// Steps of a companion by those of the next finer one, where its method is implicit.
const LONGER: f64 = 3.0;

/// Mesh and steps of a companion, by those of the run.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Place {
    /// Length of the segments: half, once, twice, or four times that of the run's.
    segment: f64,
    /// Length of the steps; the error in time grows by this to the power of the method's order.
    step: f64,
}

/// The run itself.
const RUN: Place = at(1.0, 1.0);

const fn at(segment: f64, step: f64) -> Place {
    Place { segment, step }
}

/// Pairs of runs that differ in the steps alone or in the mesh alone, the finer first in each.
#[derive(Debug, Clone, Copy)]
struct Pairs {
    /// The pair nearest to the run.
    near: [Place; 2],
    /// The next one, whose finer run is as coarse as the coarser of the first.
    far: Option<[Place; 2]>,
}

impl Pairs {
    fn places(&self) -> impl Iterator<Item = Place> {
        self.near.into_iter().chain(self.far.into_iter().flatten())
    }
}

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
    /// Error of a value by the nearest pair alone, where the order is not observed.
    pub(super) fn presumed(&self, fine: f64, coarse: f64) -> f64 {
        // Of the coarser of the two results: `r^p / (r^p - 1)` of the difference.
        let by = self.refinement.ratio.powf(self.refinement.order);
        let share = if self.is_finer { by } else { 1.0 };
        share * self.refinement.presumed(fine, coarse)
    }

    /// Whether the run is a single step, and its companion has two.
    pub(super) fn is_single_step(&self) -> bool {
        self.refinement.ratio < 1.0
    }
}

/// The companions of a run, computed.
pub(super) struct Companions<'a> {
    case: &'a Case,
    run: &'a Computed,
    cancel: &'a AtomicBool,
    computed: Vec<(Place, Cow<'a, Computed>)>,
    time: Option<Pairs>,
    mesh: Pairs,
}

/// What a companion is coarser in than the next finer one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Coarser {
    /// Steps twice as long.
    Steps,
    /// Half the segments on every section.
    Mesh,
}

impl Coarser {
    /// Its word in `solver.companions`.
    pub(super) const fn word(self) -> &'static str {
        match self {
            Self::Steps => "steps",
            Self::Mesh => "mesh",
        }
    }

    fn of_word(word: &str) -> Option<Self> {
        [Self::Steps, Self::Mesh]
            .into_iter()
            .find(|coarser| coarser.word() == word)
    }
}

/// The word in `solver.companions` for those nearest to the run.
const NEAREST: &str = "nearest";

/// The companions that a case names, from the finest; none where it leaves them open.
fn named(case: &Case) -> Option<Vec<Coarser>> {
    let words = case.solver.companions.as_ref()?;
    let coarser = words.iter().map(|word| Coarser::of_word(word));
    coarser.collect()
}

/// Whether a case asks for companions on its own mesh and in its own steps.
fn asks_for_nearest(case: &Case) -> bool {
    let words = case.solver.companions.as_deref();
    words.is_some_and(|words| words.iter().any(|word| word == NEAREST))
}

/// The first two pairs that differ in this, down a stair of companions.
fn pairs_of(stair: &[Coarser], what: Coarser) -> Option<Pairs> {
    let mut place = RUN;
    let mut pairs = Vec::new();
    for coarser in stair {
        let finer = place;
        match coarser {
            Coarser::Steps => place.step *= 2.0,
            Coarser::Mesh => place.segment *= 2.0,
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

impl<'a> Companions<'a> {
    /// Computes those that the case names, or those that tell the errors at the least cost, side by side where there are cores.
    pub(super) fn of(case: &'a Case, run: &'a Computed, cancel: &'a AtomicBool) -> Self {
        if let Some(stair) = named(case) {
            return Self::down(case, run, &stair, &[], cancel);
        }
        let coarsens = coarsens(case);
        let time = stairs_in_time(case, run, coarsens);
        let mesh = stairs_of_meshes(case, time.as_ref(), coarsens);
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

    /// Those down a stair, the first of which are known; by turns what it does not show.
    pub(super) fn down(
        case: &'a Case,
        run: &'a Computed,
        stair: &[Coarser],
        known: &[&'a Computed],
        cancel: &'a AtomicBool,
    ) -> Self {
        let places = (1..=known.len()).map(|count| place_of(&stair[..count.min(stair.len())]));
        let known = places.zip(known.iter().map(|run| Cow::Borrowed(*run)));
        let time = order(case).and_then(|_| pairs_of(stair, Coarser::Steps));
        let coarsens = coarsens(case);
        let time = time.or_else(|| stairs_in_time(case, run, coarsens));
        let mesh = pairs_of(stair, Coarser::Mesh);
        let mesh = mesh.unwrap_or_else(|| stairs_of_meshes(case, time.as_ref(), coarsens));
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
            self.mesh = meshes_in_steps(self.case, 1.0);
        }
        self.complete()
    }

    /// Whether [`Companions::beside_the_run`] has companions that these do not have.
    pub(super) fn can_be_nearer(&self) -> bool {
        let solver = &self.case.solver;
        solver.companions.is_none()
            && solver.method != Method::Static
            && coarsens(self.case)
            && has_third(self.case)
    }

    /// Computes what is missing, and others in the place of those that do not come to their end.
    fn complete(mut self) -> Self {
        let places = self.time.iter().chain([&self.mesh]).flat_map(Pairs::places);
        self.compute(&places.collect::<Vec<_>>());
        if let Some(time) = self.time
            && !(self.are_done(Some(time.near)) && self.are_done(time.far))
            && let Some(other) = on_the_own_mesh(self.case, self.run)
        {
            self.time = Some(other);
            self.compute(&other.places().collect::<Vec<_>>());
        }
        for mesh in [meshes_in_steps(self.case, 1.0), finer_mesh(1.0)] {
            if self.are_done(Some(self.mesh.near)) {
                break;
            }
            self.mesh = mesh;
            self.compute(&mesh.places().collect::<Vec<_>>());
        }
        self
    }

    /// Computes the companions at these places that are not there yet.
    fn compute(&mut self, places: &[Place]) {
        let mut missing: Vec<Place> = Vec::new();
        for place in places {
            let known = self.computed.iter().any(|(known, _)| known == place);
            if *place != RUN && !known && !missing.contains(place) {
                missing.push(*place);
            }
        }
        let (case, cancel) = (self.case, self.cancel);
        let computed = missing
            .into_par_iter()
            .map(|place| (place, Cow::Owned(companion(case, place, cancel))));
        self.computed.extend(computed.collect::<Vec<_>>());
    }

    fn at(&self, place: Place) -> Option<&Computed> {
        if place == RUN {
            return Some(self.run);
        }
        let found = self.computed.iter().find(|(at, _)| *at == place);
        found.map(|(_, computed)| computed.as_ref())
    }

    fn done(&self, pair: Option<[Place; 2]>) -> Option<[&Computed; 2]> {
        let [fine, coarse] = pair?.map(|place| self.at(place));
        let pair = [fine?, coarse?];
        let all = pair.iter().all(|run| run.outcome.state == RunState::Done);
        all.then_some(pair)
    }

    /// Whether a pair is complete, or there is none.
    fn are_done(&self, pair: Option<[Place; 2]>) -> bool {
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

    /// What shows the error of the mesh.
    pub(super) fn mesh(&self) -> Result<Evidence<'_>, String> {
        let pairs = self.mesh;
        let near = self.done(Some(pairs.near));
        near.ok_or_else(|| self.failure(&pairs)).map(|near| {
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
                    order: if has_crisis(self.case) { CRISIS } else { 2.0 },
                },
                ratios: [pairs.near[1].step, pairs.far.map_or(1.0, |far| far[1].step)],
                is_finer,
                segment: pairs.far.unwrap_or(pairs.near)[1].segment,
                is_elsewhere: pairs.near[0].step != 1.0,
            }
        })
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

/// The first stair and the last: longer steps, and on the coarsest mesh longer ones still. Explicit methods have twice the steps on half
/// the segments. Half the step where the run is a single step. None for statics.
fn stairs_in_time(case: &Case, run: &Computed, coarsens: bool) -> Option<Pairs> {
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
fn on_the_own_mesh(case: &Case, run: &Computed) -> Option<Pairs> {
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
fn stairs_of_meshes(case: &Case, time: Option<&Pairs>, coarsens: bool) -> Pairs {
    let longer = time.filter(|time| time.far.is_some());
    let step = longer.map_or(1.0, |time| time.near[1].step);
    if coarsens {
        meshes_in_steps(case, step)
    } else {
        finer_mesh(step)
    }
}

/// Segments twice as long and four times.
fn meshes_in_steps(case: &Case, step: f64) -> Pairs {
    let far = [at(2.0, step), at(4.0, step)];
    Pairs {
        near: [at(1.0, step), at(2.0, step)],
        far: has_third_mesh(case).then_some(far),
    }
}

/// Whether the mesh can be made coarser a second time.
fn has_third_mesh(case: &Case) -> bool {
    mesh_ratio(case, 4) > 1.5 * mesh_ratio(case, 2)
}

/// Segments half as long, where there is no coarser mesh or none whose run is complete.
fn finer_mesh(step: f64) -> Pairs {
    Pairs {
        near: [at(0.5, step), at(1.0, step)],
        far: None,
    }
}

/// Where a stair leads.
fn place_of(stair: &[Coarser]) -> Place {
    let count = |what| stair.iter().filter(|coarser| **coarser == what).count() as i32;
    at(
        2.0_f64.powi(count(Coarser::Mesh)),
        2.0_f64.powi(count(Coarser::Steps)),
    )
}

fn companion(case: &Case, place: Place, cancel: &AtomicBool) -> Computed {
    let mut case = case.clone();
    // Cycles along the line are counted by the run itself.
    case.checks.clear();
    let mut coarsening = place.segment.max(1.0) as usize;
    if named(&case).is_some() {
        divide(&mut case, coarsening);
        coarsening = 1;
    }
    if place.segment < 1.0 {
        for section in &mut case.line {
            section.segments *= 2;
        }
    }
    let resolution = Resolution {
        coarsening,
        step_ratio: place.step,
    };
    compute(&case, resolution, None, cancel, &mut |_| {})
}

/// Gives every section so many times fewer segments, and explicit steps so many times their length, in the case itself: as a search
/// had them before it made them finer.
fn divide(case: &mut Case, by: usize) {
    for section in &mut case.line {
        section.segments = (section.segments / by).max(1);
    }
    if case.solver.method == Method::Rk4 {
        let step = &mut case.solver.time_step_s;
        *step = step.map(|step| step * by as f64);
    }
}

/// Explicit steps four times as long are not stable.
fn has_third(case: &Case) -> bool {
    case.solver.method != Method::Rk4
}

/// Whether there is a coarser mesh, and no section is a single segment, which has none.
fn coarsens(case: &Case) -> bool {
    mesh_ratio(case, 2) > 1.0 && case.line.iter().all(|section| section.segments > 1)
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

/// Whether the run is a single step.
fn is_single_step(run: &Computed) -> bool {
    let march = March {
        duration: run.settings.duration_s,
        step: run.settings.time_step_s,
    };
    march.whole_steps() <= 1
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
