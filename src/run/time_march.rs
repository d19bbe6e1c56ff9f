//! The march of a run: from event to event, on the line as it is in between.

use std::time::Duration;

use super::compute::refused;
use super::recorder::Recorder;
use super::store::StoreError;
use super::{Checkpoint, Resume, RunState, Settings, Work};
use crate::dynamics::{March, MarchError, MarchProgress, MethodState, Stepper, WorkCounts};
use crate::scene::Scene;
use crate::solve::{Hysteresis, Instant, Kinematics, Progressing, Sink, State};

/// How a computation ended.
pub(super) struct MarchResult {
    pub(super) state: RunState,
    pub(super) failure: Option<String>,
    pub(super) work: Work,
    /// Lengths of the steps \[s\], and how many of each.
    pub(super) lengths: Vec<(f64, u64)>,
}

/// The line as it is at first, and after each of its events.
pub(super) fn phases(scene: Scene) -> Vec<Scene> {
    let events = scene.events.clone();
    let mut phases = vec![scene];
    for event in events {
        let next = phases[phases.len() - 1].after(event.change);
        phases.push(next);
    }
    phases
}

/// How much computing a run that is killed may lose, at an output time or the next one after.
const BETWEEN_CHECKPOINTS: Duration = Duration::from_secs(2);

/// Where a march begins: at time zero, or where an earlier run stands.
pub(super) struct From<'a> {
    /// An earlier run.
    pub(super) resume: Option<&'a Resume>,
    /// Whether it begins where another run stands.
    pub(super) began: bool,
    /// What the method carries on from there.
    pub(super) carried: Option<&'a MethodState>,
    /// What the start gave to be said, for those who go on later.
    pub(super) warnings: &'a [String],
}

/// Marches a line through all its phases.
pub(super) fn march<'a, M: Stepper<Scene>>(
    mut method: M,
    settings: &Settings,
    phases: &'a [Scene],
    state: &mut State,
    sink: &mut Recorder<'a>,
    mut work: Work,
    from: &From<'_>,
) -> MarchResult {
    let march = March {
        duration: settings.duration_s,
        step: settings.time_step_s,
        output: settings.output_interval_s,
    };
    let (mut place, first) = match from.resume {
        Some(resume) => match take_up(resume, &mut method, phases, state, sink) {
            Ok(place) => (place, resume.checkpoint.phase),
            Err(error) => return refused(error.to_string(), work),
        },
        None => (MarchProgress::default(), 0),
    };
    let mut result = Ok(match from.resume {
        Some(_) => Progressing::Continue,
        None => set_out(&mut method, &phases[0], state, sink, from),
    });
    for (phase, scene) in phases.iter().enumerate().skip(first) {
        if !matches!(result, Ok(Progressing::Continue)) {
            break;
        }
        if phase > first {
            sink.enter(scene);
            method.restart(scene, place.time, state);
        }
        let until = scene.events.get(phase).map_or(f64::INFINITY, |e| e.time);
        let mut keep =
            |place: &MarchProgress, method: &M, state: &State, sink: &mut Recorder<'a>| {
                let grid = march.grid();
                sink.tell_checkpoint(Checkpoint {
                    whole_step_s: grid.dt,
                    per_output: grid.per_output,
                    phase,
                    start_iterations: work.iterations,
                    peaks: sink.extremes(|c| c.peak),
                    troughs: sink.extremes(|c| c.trough),
                    longest: sink.longest(),
                    front: Some(sink.front.clone()),
                    warnings: from.warnings.to_vec(),
                    place: *place,
                    state: state.clone(),
                    carried: method.method_state(),
                    profile: sink.profile.clone(),
                    response: sink.response().cloned(),
                });
            };
        result = run_phase(
            &march,
            &mut place,
            until,
            &mut method,
            scene,
            state,
            sink,
            &mut keep,
        );
        if march.is_over(&place) {
            break;
        }
    }
    let WorkCounts {
        iterations,
        evaluations,
    } = method.work_counts();
    work.iterations += iterations;
    work.evaluations += evaluations;
    MarchResult {
        lengths: march.lengths(&place).collect(),
        ..ended(result, &place, work)
    }
}

/// Marches to the end of a phase, from output to output, and tells of the run as it stands now and then and at its end.
#[expect(
    clippy::too_many_arguments,
    reason = "the parts of one march, used nowhere else"
)]
fn run_phase<'a, M: Stepper<Scene>>(
    march: &March,
    place: &mut MarchProgress,
    until: f64,
    method: &mut M,
    scene: &'a Scene,
    state: &mut State,
    sink: &mut Recorder<'a>,
    keep: &mut dyn FnMut(&MarchProgress, &M, &State, &mut Recorder<'a>),
) -> Result<Progressing, MarchError> {
    let grid = march.grid();
    let mut kept = std::time::Instant::now();
    while !march.is_over(place) && place.time < until {
        let output = grid.output(place.whole / grid.per_output + 1);
        let before = place.whole;
        let going = march.advance(place, output.min(until), method, scene, state, sink)?;
        if going == Progressing::Stop {
            return Ok(going);
        }
        let at_output = place.whole.is_multiple_of(grid.per_output) && place.whole > before;
        if at_output && (march.is_over(place) || kept.elapsed() >= BETWEEN_CHECKPOINTS) {
            keep(place, method, state, sink);
            kept = std::time::Instant::now();
        }
        if output >= until {
            break;
        }
    }
    Ok(Progressing::Continue)
}

/// Begins at time zero: what the line remembers of its start, and the first row.
fn set_out<'a, M: Stepper<Scene>>(
    method: &mut M,
    scene: &'a Scene,
    state: &mut State,
    sink: &mut Recorder<'a>,
    from: &From<'_>,
) -> Progressing {
    scene.update_wave_kinematics(0.0, state);
    // What another run remembers it has committed already.
    if !from.began {
        scene.commit(0.0, 0.0, state);
    }
    if let Some(carried) = from.carried {
        method.restore(carried);
    }
    sink.accept(Instant {
        time: 0.0,
        state,
        steps: 0,
        output: true,
    })
}

/// Sets everything as it stood at a checkpoint.
fn take_up<'a, M: Stepper<Scene>>(
    resume: &Resume,
    method: &mut M,
    phases: &'a [Scene],
    state: &mut State,
    sink: &mut Recorder<'a>,
) -> Result<MarchProgress, StoreError> {
    let from = &resume.checkpoint;
    sink.take_up(resume)?;
    let scene = &phases[from.phase.min(phases.len() - 1)];
    sink.enter(scene);
    *state = from.state.clone();
    scene.update_wave_kinematics(from.place.time, state);
    method.restore(&from.carried);
    Ok(from.place)
}

fn ended(
    result: Result<Progressing, MarchError>,
    place: &MarchProgress,
    work: Work,
) -> MarchResult {
    let (state, failure) = match &result {
        Ok(Progressing::Stop) => (RunState::Cancelled, None),
        Ok(Progressing::Continue) => (RunState::Done, None),
        Err(error) => (
            RunState::Failed,
            Some(format!("{error}; {}", advice(error))),
        ),
    };
    MarchResult {
        state,
        failure,
        work: Work {
            steps: place.steps,
            rejections: place.rejections,
            ..work
        },
        lengths: Vec::new(),
    }
}

/// What to try after a step that failed at every length.
fn advice(error: &MarchError) -> &'static str {
    use crate::solve::NewtonError::{NotConverged, NotFinite, Runaway, Singular, Unstable};
    match error.why {
        NotConverged { .. } => {
            "try a smaller time_step_s, a smaller rho_inf, or more segments near that node"
        }
        Singular { .. } => "give that part of the line mass, drag or tension",
        Runaway { .. } => {
            "give the line tangential drag or axial damping, or use the solver `alpha`"
        }
        Unstable { .. } => "use the solver `alpha`, or try a smaller time_step_s",
        NotFinite { .. } => "try a smaller time_step_s, and look for extreme inputs near that node",
    }
}
