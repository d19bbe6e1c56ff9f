//! A system that is computed again with other steps and on other meshes, to tell its errors by.

use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;

use super::motion_plan::{MotionPlan, MotionResults};
use super::start::{Start, start};
use super::system_in_time::SystemInTime;
use super::system_under_way::compute;
use crate::case::Method;
use crate::run::Settings;
use crate::run::companions::CompanionRefinement;
use crate::run::compute::Computed;
use crate::run::lines_along::LinesAlong;
use crate::run::refinable::Refinable;
use crate::run::settings::unstable;

/// Lengths of the segments of other meshes, by those of the run.
const MESHES: [f64; 3] = [0.5, 2.0, 4.0];

/// A system with what a run of it began with.
pub(super) struct RefinableSystem<'a> {
    of: &'a SystemInTime,
    plan: MotionPlan,
    start: Start,
    /// The same on each of the other meshes, or why it does not come to rest; once it is needed.
    others: [OnceLock<Result<Start, String>>; MESHES.len()],
}

impl<'a> RefinableSystem<'a> {
    pub(super) fn new(of: &'a SystemInTime, begun: &Start) -> Self {
        Self {
            of,
            plan: of.plan(begun),
            // Cycles along the lines are counted by the run itself.
            start: Start {
                along: LinesAlong::default(),
                ..begun.clone()
            },
            others: Default::default(),
        }
    }

    /// What a companion begins with whose segments are so many times as long.
    fn start(&self, segment: f64) -> Result<&Start, String> {
        let other = MESHES.iter().position(|length| *length == segment);
        let Some(other) = other else {
            return Ok(&self.start);
        };
        let begun = self.others[other]
            .get_or_init(|| start(&self.of.solved, segment).map_err(|why| why.problem));
        begun.as_ref().map_err(Clone::clone)
    }
}

impl Refinable for RefinableSystem<'_> {
    fn companion(&self, place: CompanionRefinement, cancel: &AtomicBool) -> Computed {
        let begun = match self.start(place.segment) {
            Ok(begun) => begun.clone(),
            Err(why) => return Computed::failed(why),
        };
        let interval = self.plan.settings.output_interval_s;
        let own = MotionPlan::new(&self.of.motion, interval, &begun.system);
        // As a search had explicit steps before it made them finer: with the segments.
        let longer = match self.named() {
            Some(_) if self.is_explicit() && !own.settings.time_step_automatic => {
                place.segment.max(1.0)
            }
            _ => 1.0,
        };
        let tolerance = own.settings.step_tolerance;
        let recorded = self.plan.recorded.clone();
        let plan = MotionPlan {
            settings: Settings {
                time_step_s: longer * place.step * own.settings.time_step_s,
                step_tolerance: tolerance.map(|t| place.step.powi(3) * t),
                ..own.settings
            },
            recorded: MotionResults {
                shape_interval_s: recorded
                    .shape_interval_s
                    .filter(|_| recorded.response.is_some()),
                ..recorded
            },
            ..own
        };
        match unstable(&plan.settings) {
            Some(why) => Computed::failed(why),
            None => compute(begun, &plan, None, cancel, None),
        }
    }

    fn method_order(&self) -> Option<f64> {
        self.plan.solver.method.order()
    }

    fn has_crisis(&self) -> bool {
        let lines = self.start.system.network.lines.iter();
        let mut divided = lines.filter_map(|line| line.discretised.as_ref());
        divided.any(|line| line.case().has_crisis())
    }

    fn is_explicit(&self) -> bool {
        self.plan.solver.method == Method::Rk4
    }

    fn varies_steps(&self) -> bool {
        self.plan.settings.step_tolerance.is_some()
    }

    fn segments(&self, coarsening: usize) -> usize {
        // A mesh on which nothing comes to rest is none.
        let begun = self.start(coarsening as f64).unwrap_or(&self.start);
        let scenes = begun.system.scenes.iter();
        scenes.map(|scene| scene.line.segments.len()).sum()
    }

    fn has_single_segment(&self) -> bool {
        let mut scenes = self.start.system.scenes.iter();
        scenes.any(|scene| scene.line.segments.len() <= 1)
    }

    fn named(&self) -> Option<&[String]> {
        self.of.motion.companions.as_deref()
    }

    fn segment_weight(&self, name: &str) -> f64 {
        let system = &self.start.system;
        let lines = system.network.lines.iter().zip(&system.scenes);
        let own = lines.filter(|(line, _)| line.name == name);
        let segments = own.flat_map(|(_, scene)| &scene.line.segments);
        let weights = segments.map(|segment| 2.0 * segment.half_weight.abs());
        weights.reduce(f64::min).unwrap_or(0.0)
    }
}
