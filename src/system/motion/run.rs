//! A system computed in time, with the numerical errors of its results.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::alpha::SystemAlpha;
use super::breaks;
use super::moving_system::MovingSystem;
use super::recorder::{ChannelSummary, EnergyBalance, Recorder};
use super::release::{Release, by_tension, by_time};
use super::settings::MotionSettings;
use super::start::{Start, start};
use super::system_state::SystemState;
use crate::case::ChannelId;
use crate::dynamics::{Integrator, March, MarchError, MarchProgress, Stepper};
use crate::numerics::richardson::Refinement;
use crate::solve::{AcceptedStep, Marched, NewtonError, Progressing};
use crate::system::SolvedSystem;
use crate::system::model::MotionInputs;
use crate::system::rest::UnsolvedSystem;

/// A computed run.
#[derive(Debug, Clone)]
pub struct MotionRun {
    /// Settings that it used.
    pub settings: MotionSettings,
    /// The channels, with their statistics and errors.
    pub channels: Vec<ChannelResult>,
    /// Output times \[s\].
    pub time: Vec<f64>,
    /// Values at the output times, channel by channel.
    pub rows: Vec<Vec<f64>>,
    /// Work done.
    pub work: MotionWork,
    /// The energy balance.
    pub balance: EnergyBalance,
    /// What happened to the lines, in words.
    pub happened: Vec<String>,
    /// Why it ended before its end, if it did.
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
    /// Wall time of the run without its companions \[s\].
    pub seconds: f64,
    /// Time at its end \[s\].
    pub reached: f64,
}

/// A channel of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelResult {
    /// Its name.
    pub id: ChannelId,
    /// Over the whole run.
    pub summary: ChannelSummary,
    /// Errors of the least, greatest, mean and last value by the time steps; nothing where they are not estimated.
    pub time_error: Option<[f64; 4]>,
    /// The same by the mesh.
    pub mesh_error: Option<[f64; 4]>,
}

impl ChannelSummary {
    /// Least, greatest, mean and last value.
    #[must_use]
    pub fn numbers(&self) -> [f64; 4] {
        [self.least.0, self.greatest.0, self.mean, self.last]
    }
}

/// By how much more error the companion allows in a step that varies: steps are about twice as long.
const COARSER_STEPS: f64 = 8.0;

/// Computes a system in time, with companions of longer steps and of half the segments.
///
/// # Errors
/// Where the divided lines do not come to rest. A run that fails later says so in [`MotionRun::failure`].
pub fn run(
    solved: &SolvedSystem,
    given: &MotionInputs,
    cancel: &AtomicBool,
    progress: &mut dyn FnMut(f64),
) -> Result<MotionRun, UnsolvedSystem> {
    let begun = start(solved, 1)?;
    let interval = solved.file.output.interval_s;
    let settings = MotionSettings::new(given, interval, &begun.system);
    let mut run = compute(begun, &settings, cancel, progress);
    if given.error_estimate && run.failure.is_none() {
        estimate(solved, given, &mut run, cancel);
    }
    if run.balance.relative_drift() > NOTABLE_DRIFT {
        run.warnings.push(format!(
            "the energy does not balance: {:.3} % of it is not accounted for; try a smaller step_tolerance",
            100.0 * run.balance.relative_drift()
        ));
    }
    Ok(run)
}

/// Share of the energy that may be missing without a warning.
const NOTABLE_DRIFT: f64 = 0.02;

/// The errors of all results from companions.
fn estimate(solved: &SolvedSystem, given: &MotionInputs, run: &mut MotionRun, cancel: &AtomicBool) {
    let second = Refinement {
        ratio: 2.0,
        order: 2.0,
    };
    let mut longer = run.settings.clone();
    longer.step_tolerance = longer.step_tolerance.map(|allowed| allowed * COARSER_STEPS);
    if given.time_step_s.is_some() {
        longer.time_step_s *= 2.0;
    }
    let same_mesh = start(solved, 1);
    let coarse_mesh = start(solved, 2);
    let companions = [
        ("time", same_mesh, longer),
        ("mesh", coarse_mesh, run.settings.clone()),
    ];
    for (what, begun, settings) in companions {
        let other = begun
            .map(|begun| compute(begun, &settings, cancel, &mut |_| {}))
            .map_err(|why| why.problem)
            .and_then(|other| match other.failure.clone() {
                None => Ok(other),
                Some(why) => Err(why),
            });
        match other {
            Ok(other) => {
                for (channel, coarse) in run.channels.iter_mut().zip(&other.channels) {
                    let (fine, coarse) = (channel.summary.numbers(), coarse.summary.numbers());
                    let errors = std::array::from_fn(|k| second.presumed(fine[k], coarse[k]));
                    match what {
                        "time" => channel.time_error = Some(errors),
                        _ => channel.mesh_error = Some(errors),
                    }
                }
            }
            Err(why) => run.warnings.push(format!(
                "the {what} error is not estimated, its companion run did not finish: {why}"
            )),
        }
    }
}

/// Marches from the start to the end.
fn compute(
    begun: Start,
    settings: &MotionSettings,
    cancel: &AtomicBool,
    progress: &mut dyn FnMut(f64),
) -> MotionRun {
    let clock = Instant::now();
    let Start {
        mut system,
        mut state,
        iterations,
    } = begun;
    let mut method = SystemAlpha::new(
        &system,
        &state,
        settings.rho_inf,
        settings.position_tolerance_m,
        settings.max_iterations,
    );
    if let Some(limits) = settings.limits(&system) {
        method = method.controlled(limits);
    }
    let mut recorder = Recorder::new(&system, settings.interval_s);
    let mut place = MarchProgress::default();
    let march = March {
        duration: settings.duration_s,
        step: settings.time_step_s,
    };
    let mut failure = method
        .accelerate(&system, 0.0, &mut state)
        .err()
        .map(|why| in_words(&system, 0.0, &why));
    system.commit(0.0, 0.0, &mut state);
    let bodies = method.bodies().to_vec();
    recorder.accept(&system, &bodies, 0.0, &state);
    let mut happened = Vec::new();
    let mut events = by_time(&system).into_iter().peekable();
    while failure.is_none() && !march.is_over(&place) {
        let until = events.peek().map_or(f64::INFINITY, |event| event.time);
        let mut pulled = None;
        let mut sink = |instant: AcceptedStep<'_, SystemState>| {
            recorder.accept(&system, &bodies, instant.time, instant.state);
            progress(instant.time);
            pulled = by_tension(&system, instant.state, instant.time);
            match pulled.is_some() || cancel.load(Ordering::Relaxed) {
                true => Progressing::Stop,
                false => Progressing::Continue,
            }
        };
        let going = march.advance(
            &mut place,
            until,
            &mut method,
            &system,
            &mut state,
            &mut sink,
        );
        match going {
            Err(error) => failure = Some(march_in_words(&system, &error)),
            Ok(Progressing::Stop) if pulled.is_none() => {
                failure = Some("it was stopped".to_owned());
            }
            Ok(_) => {}
        }
        if let Some(event) = pulled {
            release(&mut system, &mut method, event, &mut state);
            recorder.jump(&system, &bodies, event.time, &state);
            happened.push(in_time(&system, event));
        }
        while failure.is_none()
            && let Some(event) = events.next_if(|event| march.is_at(&place, event.time))
        {
            release(&mut system, &mut method, event, &mut state);
            recorder.jump(&system, &bodies, place.time, &state);
            happened.push(in_time(&system, event));
        }
    }
    recorder.end();
    let work = MotionWork {
        nodes: system
            .scenes
            .iter()
            .map(crate::scene::Scene::line_nodes)
            .sum(),
        joints: system.joints.envelope.len(),
        steps: place.steps,
        rejections: place.rejections,
        iterations: iterations + method.work_counts().iterations,
        seconds: clock.elapsed().as_secs_f64(),
        reached: place.time,
    };
    MotionRun {
        happened,
        ..result(recorder, settings, work, failure)
    }
}

/// What happened to an end, in words.
fn in_time(system: &MovingSystem, event: Release) -> String {
    let line = &system.network.lines[event.line].name;
    let end = ["A", "B"][event.end];
    if breaks::is_first(system, event.line) && event.end == 1 {
        return format!("{:.6} s: line {line} breaks", event.time);
    }
    format!("{:.6} s: end {end} of line {line} is let go", event.time)
}

/// Lets an end go, and starts the method anew.
fn release(
    system: &mut MovingSystem,
    method: &mut SystemAlpha,
    event: Release,
    state: &mut SystemState,
) {
    system.let_go(event, state);
    method.restart(system, event.time, state);
}

fn result(
    recorder: Recorder,
    settings: &MotionSettings,
    work: MotionWork,
    failure: Option<String>,
) -> MotionRun {
    let summaries = recorder.summaries(work.reached);
    let channels = recorder.channels.ids.iter().zip(summaries);
    let channel = |(id, summary): (&ChannelId, ChannelSummary)| ChannelResult {
        id: id.clone(),
        summary,
        time_error: None,
        mesh_error: None,
    };
    MotionRun {
        settings: settings.clone(),
        channels: channels.map(channel).collect(),
        time: recorder.time,
        rows: recorder.rows,
        work,
        balance: recorder.balance,
        happened: Vec::new(),
        failure,
        warnings: Vec::new(),
    }
}

fn march_in_words(system: &MovingSystem, error: &MarchError) -> String {
    format!(
        "{} (the step was halved down to {:.3e} s)",
        in_words(system, error.time, &error.why),
        error.step
    )
}

/// Why a step failed, with the line and node.
fn in_words(system: &MovingSystem, time: f64, why: &NewtonError) -> String {
    let node = system.node_name(why.node());
    let problem = match why {
        NewtonError::NotConverged {
            iterations, moved, ..
        } => format!(
            "Newton did not converge in {iterations} iterations: {node} still moves by {moved:.3e} m; try a smaller time_step_s, or more segments there"
        ),
        NewtonError::Singular { .. } => {
            format!("nothing holds {node}: give it mass, drag or tension")
        }
        NewtonError::NotFinite { .. } => format!("a force is not finite at {node}"),
        NewtonError::Runaway { .. } | NewtonError::Unstable { .. } => format!("{why}, {node}"),
    };
    format!("at t = {time:.6} s {problem}")
}
