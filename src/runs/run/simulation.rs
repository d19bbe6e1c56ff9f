//! A simulation: brings the line to its start, then runs the method of the case.

use std::sync::atomic::{AtomicBool, Ordering};

use super::initial_equilibrium::find_equilibrium;
use super::line_under_way::LineUnderWay;
use super::march::{MarchResult, MarchStart, Marching};
use super::observer::{LineAtEnd, RunEnd, RunRecord};
use super::recorder::Recorder;
use super::settings::refused;
use super::warm_start::warm_start;
use super::{ResumedRun, RunState, Settings, Work};
use crate::case::{Case, Method};
use crate::dynamics::March;
use crate::scene::Scene;
use crate::solve::{Kinematics, State};

/// Brings a line to its start and runs the method of its case.
pub(super) fn simulate<'a>(
    line: LineUnderWay<'a>,
    recorder: Recorder<'a>,
    warnings: &mut Vec<String>,
    resume: Option<&'a ResumedRun>,
) -> (MarchResult, RunRecord) {
    let (case, settings, phases) = (line.case, line.settings, line.phases);
    let cancel = recorder.cancel();
    let mut state = phases[0].initial_state();
    let found = find_start(case, &phases[0], &mut state, cancel, warnings, resume);
    let (start, failure) = match found {
        Ok(start) => (start, None),
        Err((work, failure)) => (MarchStart::at_rest(None, work), Some(failure)),
    };
    let work = start.work;
    let march = March {
        duration: settings.duration_s,
        step: settings.time_step_s,
    };
    let mut marching = Marching::new(line, state, march, recorder, start);
    let refused = failure.or_else(|| refusal(case, settings).map(Failure::OfMethod));
    let result = match refused {
        None if case.solver.method == Method::Static => marching.record_alone(work),
        None => marching.run(),
        Some(Failure::Stopped) => MarchResult::stopped(work),
        Some(Failure::OfRest(why)) => MarchResult {
            state: RunState::Failed,
            failure: Some(why),
            ..marching.record_alone(work)
        },
        Some(Failure::OfMethod(why)) => MarchResult::failed(why, work),
    };
    let (line, state, recorder) = marching.into_parts();
    let end = LineAtEnd {
        scene: line.scene(),
        state: recorder.fault().is_none().then_some(&state),
    };
    let record = recorder.finish(&RunEnd { lines: &[end] });
    (result, record)
}

/// Why there is nothing to march.
enum Failure {
    /// The search for the start was stopped.
    Stopped,
    /// There is no equilibrium; where the search came to is recorded.
    OfRest(String),
    /// The method, or the run to start from, is refused.
    OfMethod(String),
}

/// The start of a line, and its state there.
///
/// # Errors
/// What the search took, and why there is no start.
fn find_start<'a>(
    case: &Case,
    scene: &Scene,
    state: &mut State,
    cancel: &AtomicBool,
    warnings: &mut Vec<String>,
    resume: Option<&'a ResumedRun>,
) -> Result<MarchStart<'a, State>, (Work, Failure)> {
    let mut work = Work::default();
    let earlier_warnings = warnings.len();
    let warm = warm_start(case, scene).map_err(|why| (work, Failure::OfMethod(why)))?;
    let warm = warm.filter(|_| resume.is_none());
    let from_run = warm.is_some() && case.solver.method != Method::Static;
    let mut method_state = None;
    if let Some(warm) = warm {
        (*state, method_state) = (warm.state, warm.method_state);
    }
    if let Some(resume) = resume {
        work.iterations = resume.checkpoint.start_iterations;
        warnings.extend(resume.checkpoint.warnings.iter().cloned());
    } else if !from_run {
        let found = find_equilibrium(case, scene, state, cancel, (&mut work, &mut *warnings));
        found.map_err(|why| match cancel.load(Ordering::Relaxed) {
            true => (work, Failure::Stopped),
            false => (work, Failure::OfRest(why)),
        })?;
        if case.solver.method != Method::Static {
            // Its ends move from now on: a motion without a ramp has its velocity at once.
            scene.prescribe(0.0, state);
        }
    }
    scene.apply_start_velocity(state);
    Ok(MarchStart {
        resume,
        from_run,
        method_state,
        warnings: warnings[earlier_warnings..].to_vec(),
        work,
    })
}

/// Why a method is refused before its first step, in words.
fn refusal(case: &Case, settings: &Settings) -> Option<String> {
    let (problem, remedy) = refused(settings).filter(|_| case.solver.is_in_time())?;
    Some(format!("{problem}; {remedy}"))
}
