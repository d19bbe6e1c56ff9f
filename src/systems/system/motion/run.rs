//! A system computed in time, with the numerical errors of its results.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::along::counted_along;
pub use super::channel_result::{ChannelResult, ChannelSummary};
use super::channels::Channels;
use super::chosen_method::chosen;
use super::computed_system::ComputedSystem;
pub use super::computed_system::MotionWork;
use super::march::{Stored, compute};
use super::refinable_system::RefinableSystem;
use super::settings::MotionSettings;
use super::start::{Start, start};
use crate::dynamics::rk4::BELOW_LIMIT;
use crate::limits::STEPS;
use crate::run::along::FatigueSpot;
use crate::run::compute::{Computed, INERTIA_LEFT_OUT};
use crate::run::energy_balance::{self, EnergyBalance};
use crate::run::error_estimate::{ErrorEstimates, HistoryPair, estimate, without_errors};
use crate::run::event::JobEvent;
use crate::run::{Cost, History, LineShape, Profile, Quantity, RunState, Settings};
use crate::system::SolvedSystem;
use crate::system::loads_without_effect::loads_without_effect;
use crate::system::model::{MotionInputs, MotionMethod};
use crate::system::rest::UnsolvedSystem;

/// A computed run.
#[derive(Debug, Clone)]
pub struct MotionRun {
    /// Settings that it used.
    pub settings: MotionSettings,
    /// The same in the words of a stored run, with how its errors were estimated.
    pub stored_settings: Settings,
    /// Statistics of the channels, with errors, in the order of the history.
    pub channels: Vec<ChannelResult>,
    /// All single numbers with their errors: of channels, along the lines, of the energy.
    pub summary: Vec<Quantity>,
    /// The channels at the output times; of a long run some of them.
    pub history: History,
    /// The pairs of companions by which errors of curves are told: in time, and of the mesh.
    pub companions: Vec<HistoryPair>,
    /// Work done.
    pub work: MotionWork,
    /// The time that it took.
    pub cost: Cost,
    /// Shapes of the lines at chosen instants.
    pub shapes: Vec<LineShape>,
    /// The lines node by node, at the end and with their envelopes.
    pub profiles: Vec<Profile>,
    /// The damage along the lines, where checks count it.
    pub fatigue: Vec<FatigueSpot>,
    /// The energy balance.
    pub balance: EnergyBalance,
    /// What happened to the lines, in words.
    pub happened: Vec<String>,
    /// How it ended.
    pub state: RunState,
    /// Why it failed, if it did.
    pub failure: Option<String>,
    /// What a reader should know.
    pub warnings: Vec<String>,
}

/// The run of a computation, with the errors of its results.
fn with_errors(
    found: ComputedSystem,
    settings: MotionSettings,
    errors: ErrorEstimates,
) -> MotionRun {
    let ComputedSystem {
        computed,
        work,
        happened,
    } = found;
    let Computed {
        outcome,
        mut warnings,
        settings: stored_settings,
        cost,
        record,
        ..
    } = computed;
    warnings.extend(errors.warnings);
    warnings.extend(energy_balance::warning(
        &errors.summary,
        record.balance.as_ref(),
    ));
    MotionRun {
        settings,
        stored_settings: Settings {
            error_method: errors.method,
            ..stored_settings
        },
        channels: ChannelResult::all(&record.history.channels, &errors.summary),
        summary: errors.summary,
        companions: errors.curves,
        balance: record.balance.unwrap_or_default(),
        fatigue: record.fatigue,
        history: record.history,
        shapes: record.shapes,
        profiles: record.profiles,
        work,
        cost,
        happened,
        state: outcome.state,
        failure: outcome.failure,
        warnings,
    }
}

/// Computes a system in time, with companions that tell its errors, and sends the rows of its history.
///
/// # Errors
/// Where the divided lines do not come to rest. A run that fails later says so in [`MotionRun::failure`].
pub fn run(
    solved: &SolvedSystem,
    given: &MotionInputs,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> Result<MotionRun, UnsolvedSystem> {
    run_stored(solved, given, None, cancel, events)
}

/// The same; a run that is stored sends checkpoints too, and may be resumed from one.
///
/// # Errors
/// As [`run`].
pub(super) fn run_stored(
    solved: &SolvedSystem,
    given: &MotionInputs,
    stored: Option<Stored<'_>>,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> Result<MotionRun, UnsolvedSystem> {
    let begun = start(solved, 1.0)?;
    let from = stored.and_then(|stored| stored.from);
    let chosen = chosen(given, &begun, from, cancel);
    let given = chosen.as_ref().map_or(given, |(chosen, _)| chosen);
    // A trial that was stopped may choose another method than the whole one: without a checkpoint the run is begun anew.
    let is_begun_anew = chosen.is_some() && from.is_none() && cancel.load(Ordering::Relaxed);
    let stored = stored.filter(|_| !is_begun_anew);
    let interval = solved.file.output.interval_s;
    let window = solved.file.statistics.settled_window(given.duration_s);
    let settings = MotionSettings {
        settled_from_s: window.map(|[from, _]| from),
        shape_interval_s: Some(solved.file.output.shape_interval_s),
        ..MotionSettings::new(given, interval, &begun.system)
    };
    check_steps(&settings, &begun)?;
    let refinable = given
        .error_estimate
        .then(|| RefinableSystem::new(solved, given, &begun, &settings));
    let (along, missing) = counted_along(solved, &begun.system);
    let begun = Start { along, ..begun };
    let lines = begun.system.network.lines.iter();
    events(JobEvent::Started {
        channels: Channels::of(&begun.system).ids,
        lines: lines.map(|line| line.name.clone()).collect(),
    });
    let mut notes = notes(solved, &begun, &settings);
    notes.extend(missing);
    let mut run = compute(begun, &settings, stored, cancel, Some(&mut *events));
    let computed = &mut run.computed;
    computed.settings.method_reason = chosen.as_ref().map(|(_, why)| why.clone());
    computed.warnings.append(&mut computed.record.warnings);
    computed.warnings.extend(notes);
    let done = computed.outcome.state == RunState::Done;
    let errors = match refinable.filter(|_| done) {
        Some(refinable) => {
            events(JobEvent::Estimating);
            let clock = Instant::now();
            let errors = estimate(&refinable, computed, cancel);
            computed.cost.companions_wall_s = clock.elapsed().as_secs_f64();
            // Its errors are left to estimate.
            if cancel.load(Ordering::Relaxed) {
                computed.outcome.state = RunState::Cancelled;
            }
            errors
        }
        None => without_errors(computed),
    };
    Ok(with_errors(run, settings, errors))
}

/// Checks that the steps are not too many, and stable.
fn check_steps(settings: &MotionSettings, begun: &Start) -> Result<(), UnsolvedSystem> {
    let refusal = |problem: String, remedy: String| UnsolvedSystem {
        problem,
        remedy,
        line: None,
        part: None,
    };
    let steps = settings.duration_s / settings.time_step_s;
    if STEPS.is_exceeded_by(steps) {
        let problem = format!(
            "it would take {steps:.1e} steps of {:.1e} s",
            settings.time_step_s
        );
        let fewer = "make the lines less stiff, or choose the method `alpha`";
        return Err(refusal(problem, STEPS.remedy(fewer, steps)));
    }
    match settings.instability(&begun.system) {
        Some(problem) => Err(refusal(problem, BELOW_LIMIT.to_owned())),
        None => Ok(()),
    }
}

/// What a reader should know of a run before it is computed.
fn notes(solved: &SolvedSystem, begun: &Start, settings: &MotionSettings) -> Vec<String> {
    let mut notes = coarse_memory(begun);
    if settings.method == MotionMethod::Quasi {
        notes.push(INERTIA_LEFT_OUT.to_owned());
    }
    notes.extend(turned_from_loads(begun));
    notes.extend(loads_without_effect(solved));
    notes
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
