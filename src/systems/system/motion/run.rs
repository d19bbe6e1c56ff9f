//! A system computed in time, with the numerical errors of its results.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::along::counted_along;
pub use super::channel_result::{ChannelResult, ChannelSummary};
use super::channels::Channels;
use super::differences::differences;
use super::march::{Stored, compute};
use super::settings::MotionSettings;
use super::start::{Start, start};
use crate::dynamics::rk4::BELOW_LIMIT;
use crate::limits::STEPS;
use crate::numerics::richardson::Refinement;
use crate::run::along::FatigueSpot;
use crate::run::energy_balance::EnergyBalance;
use crate::run::event::JobEvent;
use crate::run::lines_along::LinesAlong;
use crate::run::{
    Cost, History, LineShape, Profile, Quantity, QuantityId, RunState, line_statistics,
};
use crate::system::SolvedSystem;
use crate::system::loads_without_effect::loads_without_effect;
use crate::system::model::MotionInputs;
use crate::system::rest::UnsolvedSystem;

/// A computed run.
#[derive(Debug, Clone)]
pub struct MotionRun {
    /// Settings that it used.
    pub settings: MotionSettings,
    /// Statistics of the channels, with errors, in the order of the history.
    pub channels: Vec<ChannelResult>,
    /// The extremes along the lines, with errors.
    pub along: Vec<Quantity>,
    /// The channels at the output times; of a long run some of them.
    pub history: History,
    /// The same of the companion runs that estimate the errors: on longer steps, and on half the segments.
    pub companions: Vec<History>,
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
    /// The energy balance, and its single numbers.
    pub balance: EnergyBalance,
    /// See [`MotionRun::balance`].
    pub energy: Vec<Quantity>,
    /// What happened to the lines, in words.
    pub happened: Vec<String>,
    /// How it ended.
    pub state: RunState,
    /// Why it failed, if it did.
    pub failure: Option<String>,
    /// What a reader should know.
    pub warnings: Vec<String>,
}

/// Work of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MotionWork {
    /// Nodes of all lines.
    pub nodes: usize,
    /// Unknown points, twice the free bodies included.
    pub joints: usize,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Newton iterations.
    pub iterations: u64,
    /// Evaluations of an explicit method.
    pub evaluations: u64,
    /// Time at its end \[s\].
    pub reached: f64,
}

/// By how much more error the companion allows in a step that varies: steps are about twice as long.
const COARSER_STEPS: f64 = 8.0;

/// Computes a system in time, with companions of longer steps and of half the segments, and sends the rows of its history.
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
    let begun = start(solved, 1)?;
    let interval = solved.file.output.interval_s;
    let window = solved.file.statistics.settled_window(given.duration_s);
    let settings = MotionSettings {
        settled_from_s: window.map(|[from, _]| from),
        shape_interval_s: Some(solved.file.output.shape_interval_s),
        ..MotionSettings::new(given, interval, &begun.system)
    };
    let steps = settings.duration_s / settings.time_step_s;
    if STEPS.is_exceeded_by(steps) {
        return Err(UnsolvedSystem {
            problem: format!(
                "it would take {steps:.1e} steps of {:.1e} s",
                settings.time_step_s
            ),
            remedy: STEPS.remedy(
                "make the lines less stiff, or choose the method `alpha`",
                steps,
            ),
            line: None,
            part: None,
        });
    }
    if let Some(problem) = settings.instability(&begun.system) {
        return Err(UnsolvedSystem {
            problem,
            remedy: BELOW_LIMIT.to_owned(),
            line: None,
            part: None,
        });
    }
    let again = given.error_estimate.then(|| Start {
        along: LinesAlong::default(),
        ..begun.clone()
    });
    let (along, missing) = counted_along(solved, &begun.system);
    let begun = Start { along, ..begun };
    events(JobEvent::Started {
        channels: Channels::of(&begun.system).ids,
        lines: begun
            .system
            .network
            .lines
            .iter()
            .map(|line| line.name.clone())
            .collect(),
    });
    let mut notes = coarse_memory(&begun);
    notes.extend(turned_from_loads(&begun));
    notes.extend(loads_without_effect(solved));
    notes.extend(missing);
    let mut run = compute(begun, &settings, stored, cancel, Some(events));
    run.warnings.extend(notes);
    if let Some(again) = again.filter(|_| run.state == RunState::Done) {
        events(JobEvent::Estimating);
        let clock = Instant::now();
        estimate(solved, again, &mut run, cancel);
        run.cost.companions_wall_s = clock.elapsed().as_secs_f64();
        // Its errors are left to estimate.
        if cancel.load(Ordering::Relaxed) {
            run.state = RunState::Cancelled;
        }
    }
    if run.balance.relative_drift() > NOTABLE_DRIFT {
        let remedy = match run.balance.is_of_mesh() {
            true => {
                "segments at ends that are paid out are too long: give these lines more `segments`"
            }
            false => "try a smaller step_tolerance",
        };
        run.warnings.push(format!(
            "the energy does not balance: {:.3} % of it is not accounted for; {remedy}",
            100.0 * run.balance.relative_drift()
        ));
    }
    Ok(run)
}

/// Share of the energy that may be missing without a warning.
const NOTABLE_DRIFT: f64 = 0.02;

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

/// The difference of an extreme along a line from that of a companion.
fn along_error(of: &Quantity, companion: &MotionRun) -> Option<f64> {
    let same = companion.along.iter().find(|other| other.id == of.id)?;
    Some((of.value - same.value).abs())
}

/// The least error of an extreme along a line by the mesh: a place along it is known to a segment.
fn resolution(of: &Quantity, profiles: &[Profile]) -> f64 {
    let QuantityId::Statistic {
        of: subject,
        statistic,
        ..
    } = &of.id
    else {
        return 0.0;
    };
    let line = subject.line_quantity().map_or("", |(_, line)| line);
    let profile = profiles.iter().find(|profile| profile.line == line);
    profile.map_or(0.0, |profile| {
        line_statistics::resolution(profile, *statistic)
    })
}

/// The errors of all results from companions: from the same start with longer steps, and on half the segments.
fn estimate(solved: &SolvedSystem, same: Start, run: &mut MotionRun, cancel: &AtomicBool) {
    let second = Refinement {
        ratio: 2.0,
        order: 2.0,
    };
    let mut longer = run.settings.clone();
    longer.shape_interval_s = None;
    longer.time_step_s *= 2.0;
    longer.step_tolerance = longer.step_tolerance.map(|t| COARSER_STEPS * t);
    let mesh = MotionSettings {
        shape_interval_s: None,
        ..run.settings.clone()
    };
    let companions = [("time", Ok(same), longer), ("mesh", start(solved, 2), mesh)];
    for (what, begun, settings) in companions {
        let other = begun
            .map_err(|why| why.problem)
            .and_then(|begun| match settings.instability(&begun.system) {
                Some(why) => Err(why),
                None => Ok(compute(begun, &settings, None, cancel, None)),
            })
            .and_then(|other| match (other.state, &other.failure) {
                (RunState::Done, _) if what == "mesh" && other.work.nodes == run.work.nodes => {
                    Err("its lines have the least segments already".to_owned())
                }
                (RunState::Done, _) => Ok(other),
                (_, Some(why)) => Err(why.clone()),
                (_, None) => Err("it was stopped".to_owned()),
            });
        match other {
            Ok(other) => {
                for (number, coarse) in other.channels.iter().enumerate() {
                    let Some(channel) = run.channels.get_mut(number) else {
                        continue;
                    };
                    let summaries = [&channel.summary, &coarse.summary];
                    let histories = [&run.history, &other.history];
                    let differences = differences(&channel.id, summaries, histories, number);
                    let errors = differences.map(|difference| second.presumed(difference, 0.0));
                    match what {
                        "time" => channel.time_error = Some(errors),
                        _ => channel.mesh_error = Some(errors),
                    }
                }
                for line in &mut run.along {
                    let error = along_error(line, &other).map(|d| second.presumed(d, 0.0));
                    match what {
                        "time" => line.time_error = error,
                        _ => {
                            line.mesh_error = error.map(|e| e.max(resolution(line, &run.profiles)))
                        }
                    }
                }
                run.companions.push(other.history);
            }
            Err(why) => run
                .warnings
                .push(format!("the {what} error is not estimated: {why}")),
        }
    }
}
