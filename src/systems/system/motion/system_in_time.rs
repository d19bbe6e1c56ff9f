//! A system of lines in time, as a run computes it.

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, OnceLock};

use super::along::counted_along;
use super::channels::Channels;
use super::checkpoint::ResumedSystem;
use super::chosen_method::chosen;
use super::driving_period::asked_response;
use super::motion_plan::{MotionPlan, MotionResults};
use super::refinable_system::RefinableSystem;
use super::start::{Start, start};
use super::system_bounds::bounds;
use super::system_state::SystemState;
use super::system_under_way::compute;
use crate::case::fields::Schema;
use crate::case::{Attachment, QuantityId, kind};
use crate::case::{Method, Solver};
use crate::checks::resolved::held_along;
use crate::run::Settings;
use crate::run::computation::{Computation, first};
use crate::run::compute::{Computed, INERTIA_LEFT_OUT};
use crate::run::event::{JobEvent, Listener};
use crate::run::lines_along::LinesAlong;
use crate::run::published_curve::of_file_as_it_stands;
use crate::run::refinable::Refinable;
use crate::run::response::AskedResponse;
use crate::run::settings::{SceneBounds, refused};
use crate::system::loads_without_effect::loads_without_effect;
use crate::system::off_nodes::off_nodes;
use crate::system::rest::UnsolvedSystem;
use crate::system::results_in_time::stated;
use crate::system::{SYSTEM, SolvedSystem, SystemFile};

/// A system in time.
#[derive(Debug, Clone)]
pub struct SystemInTime {
    /// The system at rest.
    pub solved: Arc<SolvedSystem>,
    /// How it is computed.
    pub motion: Solver,
    /// What it begins with, once it is asked for.
    begun: Arc<OnceLock<Result<Start, UnsolvedSystem>>>,
}

impl SystemInTime {
    /// A system at rest, to be computed in time.
    #[must_use]
    pub fn new(solved: Arc<SolvedSystem>, motion: Solver) -> Self {
        Self {
            solved,
            motion,
            begun: Arc::default(),
        }
    }

    /// The same system, computed otherwise in time.
    #[must_use]
    pub fn with(&self, motion: Solver) -> Self {
        Self {
            motion,
            ..self.clone()
        }
    }

    /// What bounds its steps.
    ///
    /// # Errors
    /// Where the divided lines do not come to rest.
    pub fn step_bounds(&self) -> Result<SceneBounds, String> {
        let begun = self.begun().map_err(|why| in_words(&why))?;
        Ok(bounds(&begun.system))
    }

    /// What it begins with.
    ///
    /// # Errors
    /// Where the divided lines do not come to rest.
    pub(super) fn begun(&self) -> Result<&Start, UnsolvedSystem> {
        let begun = self.begun.get_or_init(|| start(&self.solved, 1.0));
        begun.as_ref().map_err(Clone::clone)
    }

    /// The results that its file asks for by published values and checks.
    fn stated(&self, begun: &Start) -> Vec<QuantityId> {
        let file = &self.solved.file;
        let lines = begun.system.network.lines.iter();
        let held = held_along(
            &file.checks,
            &file.files,
            lines.map(|line| line.name.as_str()),
        );
        stated(file).into_iter().chain(held).collect()
    }

    /// How its run is computed, and what is recorded of it.
    pub(super) fn plan(&self, begun: &Start) -> MotionPlan {
        let (file, given) = (&self.solved.file, &self.motion);
        let window = file.statistics.settled_window(given.duration_s);
        let window = window.filter(|_| given.is_in_time());
        MotionPlan {
            recorded: MotionResults {
                settled_from_s: window.map(|[from, _]| from),
                stated: self.stated(begun),
                curves: of_file_as_it_stands(file, &file.study, &file.published_curve),
                response: asked_response(file).filter(|_| given.is_in_time()),
                shape_interval_s: Some(file.output.shape_interval_s),
            },
            ..MotionPlan::new(given, file.output.interval_s, &begun.system)
        }
    }
}

impl Computation for SystemInTime {
    type State = SystemState;

    fn of_stored(text: &str, file: &str) -> Result<Self, String> {
        let solved = kind::parse_stored::<SystemFile>(text, file).map_err(|all| first(&all))?;
        let motion = solved.file.as_run().cloned();
        let motion = motion.ok_or("its case.toml has no run in time")?;
        Ok(Self::new(Arc::new(solved), motion))
    }

    fn with_key(text: &str, key: &str, value: &str) -> Result<String, String> {
        kind::put::<SystemFile>(text, key, value).map_err(|all| first(&all))
    }

    fn schema() -> &'static Schema {
        &SYSTEM
    }

    fn title(&self) -> &str {
        &self.solved.file.about.title
    }

    fn method(&self) -> &'static str {
        self.motion.method.name()
    }

    fn duration_s(&self) -> f64 {
        self.motion.duration_s
    }

    fn files(&self) -> &BTreeMap<String, Attachment> {
        &self.solved.file.files
    }

    fn has_companions(&self) -> bool {
        self.motion.error_estimate
    }

    fn with_chosen_method(
        &self,
        from: Option<&ResumedSystem>,
        cancel: &AtomicBool,
    ) -> Option<(Self, Option<String>)> {
        // What does not begin fails with its reason later.
        let begun = self.begun().ok()?;
        let (motion, why) = chosen(&self.motion, begun, from, cancel)?;
        Some((self.with(motion), Some(why)))
    }

    fn compute(
        &self,
        from: Option<&ResumedSystem>,
        cancel: &AtomicBool,
        events: Listener<'_>,
    ) -> Computed {
        let begun = match self.begun() {
            Ok(begun) => begun,
            Err(why) => return Computed::failed(in_words(&why)),
        };
        let plan = self.plan(begun);
        if let Err(why) = check_steps(&plan.settings) {
            return Computed::failed(in_words(&why));
        }
        let events: Listener<'_> = match events {
            Some(events) => {
                let lines = begun.system.network.lines.iter();
                events(JobEvent::Started {
                    channels: Channels::of_system(&begun.system).ids,
                    lines: lines.map(|line| line.name.clone()).collect(),
                });
                Some(events)
            }
            None => None,
        };
        let (along, missing) = match self.motion.is_in_time() {
            true => counted_along(&self.solved, &begun.system),
            false => (LinesAlong::default(), Vec::new()),
        };
        let counting = Start {
            along,
            ..begun.clone()
        };
        let mut run = compute(counting, &plan, from, cancel, events);
        run.warnings.append(&mut run.record.warnings);
        run.warnings.extend(notes(&self.solved, begun, &plan));
        run.warnings.extend(missing);
        if run.has_record() {
            let modes = self.solved.asked_modes();
            run.take_modes(modes.map(<[_]>::to_vec).map_err(str::to_owned));
        }
        run
    }

    fn remarks(&self, _: &Computed) -> Vec<String> {
        Vec::new()
    }

    fn ask_refinable<T>(&self, ask: impl FnOnce(&dyn Refinable) -> T) -> Option<T> {
        let begun = self.begun().ok()?;
        Some(ask(&RefinableSystem::new(self, begun)))
    }
}

/// Why there is no run, in words.
fn in_words(why: &UnsolvedSystem) -> String {
    format!("{}; {}", why.problem, why.remedy)
}

/// Checks that the steps are not too many, and stable; a run at rest has none.
pub(super) fn check_steps(settings: &Settings) -> Result<(), UnsolvedSystem> {
    match refused(settings) {
        None => Ok(()),
        Some((problem, remedy)) => Err(UnsolvedSystem {
            problem,
            remedy,
            line: None,
            part: None,
        }),
    }
}

/// What a reader should know of a run before it is computed.
fn notes(solved: &SolvedSystem, begun: &Start, plan: &MotionPlan) -> Vec<String> {
    let mut notes = coarse_memory(begun);
    if plan.solver.method == Method::Quasi {
        notes.push(INERTIA_LEFT_OUT.to_owned());
    }
    notes.extend(
        plan.recorded
            .response
            .and_then(|asked| late_response(asked, &plan.settings)),
    );
    notes.extend(turned_from_loads(begun));
    notes.extend(loads_without_effect(solved));
    notes.extend(off_nodes(solved));
    notes
}

/// That the response would be taken after the end of the run alone.
fn late_response(asked: AskedResponse, settings: &Settings) -> Option<String> {
    let (from, end) = (asked.from, settings.duration_s);
    (from >= end).then(|| {
        format!(
            "`output.response_from_s` has no effect: the run ends at {end} s, before displacements along the lines are taken at {from} s"
        )
    })
}

/// Difference of the damping transformed back, by its greatest value, above which a warning says so.
const COARSE_MEMORY: f64 = 0.01;

/// Warnings of retardation functions that are not those of their damping.
fn coarse_memory(begun: &Start) -> Vec<String> {
    let system = &begun.system;
    let flows = system.flows.iter();
    let off = flows.filter_map(|flow| {
        let error = flow.retardation.as_ref()?.error;
        let name = &system.network.bodies[flow.body].name;
        (error > COARSE_MEMORY).then(|| {
            format!(
                "body {name}: the retardation functions give the damping back within {:.1} % of its greatest value only; give radiation_file at more frequencies",
                100.0 * error
            )
        })
    });
    off.collect()
}

/// Turn of a body at rest from the heading that its wave loads are for above which a warning says so \[rad\].
const TURNED: f64 = 0.05;

/// Warnings of bodies that rest at another heading than the one that their wave loads are for.
fn turned_from_loads(begun: &Start) -> Vec<String> {
    let system = &begun.system;
    let flows = system.flows.iter().filter(|flow| flow.has_waves());
    let off = flows.filter_map(|flow| {
        let body = &system.network.bodies[flow.body];
        let rests = begun.state.body(&system.joints, flow.body).pose.angles()[2];
        let turn = rests - body.pose.angles()[2];
        let turn = turn.sin().atan2(turn.cos());
        (turn.abs() > TURNED).then(|| {
            format!(
                "body {}: it begins at a heading of {:.1} deg, its wave loads are for {:.1}; give that as its yaw_deg",
                body.name,
                rests.to_degrees(),
                body.pose.angles()[2].to_degrees()
            )
        })
    });
    off.collect()
}
