//! A simulation: brings the line to its start, then runs the method of the case.

use std::sync::atomic::Ordering;

use super::initial_equilibrium::find_equilibrium;
use super::line_recorder::LineRecorder;
use super::settings::{motion_scale, position_tolerance};
use super::time_march::{MarchResult, MarchStart, march};
use super::warm_start::warm_start;
use super::{ResumedRun, RunState, Settings, Work};
use crate::case::{Case, Method};
use crate::dynamics::quasi_static::QuasiStatic;
use crate::dynamics::rk4::{BELOW_LIMIT, Rk4, above_limit};
use crate::dynamics::{ErrorLimits, generalized_alpha::GeneralizedAlpha};
use crate::scene::Scene;
use crate::solve::{AcceptedStep, ExplicitRhs, Kinematics, Progressing, Sink, State};

/// Brings the line to its start and runs the method of the case. `phases` is the line at first and after each of its
/// events.
pub(super) fn simulate<'a>(
    case: &Case,
    phases: &'a [Scene],
    settings: &Settings,
    recorder: &mut LineRecorder<'a>,
    warnings: &mut Vec<String>,
    resume: Option<&ResumedRun>,
) -> MarchResult {
    let mut state = phases[0].initial_state();
    let mut result = simulate_from(
        case,
        phases,
        settings,
        recorder,
        warnings,
        (&mut state, resume),
    );
    recorder.end(&state);
    if let Some(fault) = recorder.fault() {
        result.state = RunState::Failed;
        result.failure.get_or_insert(fault);
    }
    result
}

/// The same from this initial state, which becomes the last one.
fn simulate_from<'a>(
    case: &Case,
    phases: &'a [Scene],
    settings: &Settings,
    recorder: &mut LineRecorder<'a>,
    warnings: &mut Vec<String>,
    (state, resume): (&mut State, Option<&ResumedRun>),
) -> MarchResult {
    let scene = &phases[0];
    let mut work = Work::default();
    let earlier_warnings = warnings.len();
    let warm = match warm_start(case, scene) {
        Ok(warm) => warm.filter(|_| resume.is_none()),
        Err(failure) => return MarchResult::failed(failure, work),
    };
    let from_run = warm.is_some() && case.solver.method != Method::Static;
    let mut method_state = None;
    if let Some(warm) = warm {
        (*state, method_state) = (warm.state, warm.method_state);
    }
    if let Some(resume) = resume {
        work.iterations = resume.checkpoint.start_iterations;
        warnings.extend(resume.checkpoint.warnings.iter().cloned());
    } else if !from_run {
        let (cancel, notes) = (recorder.cancel(), (&mut work, &mut *warnings));
        if let Err(failure) = find_equilibrium(case, scene, state, cancel, notes) {
            if cancel.load(Ordering::Relaxed) {
                return MarchResult::stopped(work);
            }
            record_single(recorder, state);
            return MarchResult::failed(failure, work);
        }
    }
    scene.apply_start_velocity(state);
    let start = MarchStart {
        resume,
        from_run,
        method_state: method_state.as_ref(),
        warnings: &warnings[earlier_warnings..],
        work,
    };
    run_method(case, settings, phases, state, recorder, &start)
}

/// Runs the method of the case from the current state.
fn run_method<'a>(
    case: &Case,
    settings: &Settings,
    phases: &'a [Scene],
    state: &mut State,
    recorder: &mut LineRecorder<'a>,
    start: &MarchStart<'_>,
) -> MarchResult {
    let scene = &phases[0];
    let tolerance = position_tolerance(case, scene);
    let max_iterations = case.solver.max_iterations;
    let accelerate = |state: &mut State| {
        scene.update_wave_kinematics(0.0, state);
        // A known acceleration stays: derived anew from the forces it would lose an order.
        if start.method_state.is_none() {
            scene.accelerate(0.0, state);
        }
    };
    match case.solver.method {
        Method::Static => {
            record_single(recorder, state);
            MarchResult {
                state: RunState::Done,
                failure: None,
                work: start.work,
                reached: 0.0,
                lengths: Vec::new(),
            }
        }
        Method::Quasi => {
            let method = QuasiStatic::new(scene, state, tolerance, max_iterations);
            march(method, settings, phases, state, recorder, start)
        }
        Method::Rk4 => {
            let limit = settings.stability_limit_s;
            if limit.is_some_and(|limit| settings.time_step_s > limit) {
                return MarchResult::failed(unstable(settings), start.work);
            }
            accelerate(state);
            let method = Rk4::new(scene, state);
            march(method, settings, phases, state, recorder, start)
        }
        Method::Alpha | Method::Auto => {
            accelerate(state);
            let rho = case.solver.rho_inf;
            let method = GeneralizedAlpha::new(scene, state, rho, tolerance, max_iterations);
            let method = match settings.step_tolerance {
                Some(tolerance) => method.controlled(error_limits(case, scene, tolerance)),
                None => method,
            };
            let method = match scene.velocity_resolution() {
                Some(speed) => method.resolving(speed),
                None => method,
            };
            march(method, settings, phases, state, recorder, start)
        }
    }
}

/// Errors allowed in a step, from the dimensionless tolerance of the case.
fn error_limits(case: &Case, scene: &Scene, tolerance: f64) -> ErrorLimits {
    let (distance, speed) = motion_scale(case, scene);
    ErrorLimits {
        position: tolerance * distance,
        velocity: 2.0 * tolerance * speed,
    }
}

/// Records a single state.
fn record_single(recorder: &mut LineRecorder<'_>, state: &State) {
    let _: Progressing = recorder.accept(AcceptedStep {
        time: 0.0,
        state,
        steps: 0,
        whole: true,
    });
}

fn unstable(settings: &Settings) -> String {
    let problem = above_limit(
        settings.time_step_s,
        settings.stability_limit_s.unwrap_or_default(),
        settings.stability_limit_at.as_deref().unwrap_or_default(),
    );
    format!("{problem}; {BELOW_LIMIT}")
}
