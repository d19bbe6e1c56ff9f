//! One computation of a case, without companions: scene, settings, start, march.

use std::sync::atomic::{AtomicBool, Ordering};

use rustix::time::{ClockId, clock_gettime};

use super::initial_equilibrium::come_to_rest;
use super::job::Event;
use super::natural_modes;
use super::published_curve;
use super::recorder::Recorder;
use super::requested_statistics::RequestedStatistic;
use super::settings::{position_tolerance, settings, tell_damping, tell_of_modes};
use super::steady_state;
use super::time_march::{From, MarchResult, march, phases};
use super::warm_start::warm_start;
use super::wave_decomposition;
use super::{Cost, History, LineShape, Profile, Quantity, Resume, RunState, Settings, Work};
use crate::case::{Case, Method, WaterSurface};
use crate::dynamics::generalized_alpha::{ErrorLimits, GeneralizedAlpha};
use crate::dynamics::quasi_static::QuasiStatic;
use crate::dynamics::rk4::Rk4;
use crate::scene::{self, Scene};
use crate::solve::{ExplicitRhs, Instant, Kinematics, Progressing, Sink, State};

/// What one computation gave.
#[derive(Debug, Clone)]
pub(super) struct Computed {
    pub(super) state: RunState,
    pub(super) failure: Option<String>,
    pub(super) warnings: Vec<String>,
    pub(super) settings: Settings,
    pub(super) work: Work,
    pub(super) cost: Cost,
    pub(super) history: History,
    pub(super) shapes: Vec<LineShape>,
    pub(super) profile: Profile,
    /// The single numbers wanted, and what they are; absent where they cannot be taken.
    pub(super) wanted: Vec<RequestedStatistic>,
    pub(super) numbers: Vec<Option<f64>>,
    /// What is told of natural modes and of when the motion is steady, without errors.
    pub(super) modes: Vec<Quantity>,
    /// Differences from the published curves of the case, without errors.
    pub(super) curves: Vec<Quantity>,
}

/// The time step of a computation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum StepScale {
    /// As the case sets it, or as chosen for it.
    AsSet,
    /// Such that the time error is `r^p` times as large, p the order of the method: r times the step or, where the steps
    /// vary, `r^(p + 1)` times the error in each (which grows with one power more) and r times the longest.
    Times(f64),
}

impl Computed {
    /// Nothing but a reason.
    fn failed(failure: String) -> Self {
        Self {
            state: RunState::Failed,
            failure: Some(failure),
            warnings: Vec::new(),
            settings: Settings::default(),
            work: Work::default(),
            cost: Cost::default(),
            history: History::default(),
            shapes: Vec::new(),
            profile: Profile::default(),
            wanted: Vec::new(),
            numbers: Vec::new(),
            modes: Vec::new(),
            curves: Vec::new(),
        }
    }
}

/// Computes a case as it stands, going on from where an earlier run stands if there is one.
pub(super) fn compute_from(
    case: &Case,
    from: Option<&Resume>,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(Event),
) -> Computed {
    compute_on(case, 1, StepScale::AsSet, from, cancel, events)
}

/// Computes a case on a mesh coarsened by `coarsening`.
pub(super) fn compute(
    case: &Case,
    coarsening: usize,
    step: StepScale,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(Event),
) -> Computed {
    compute_on(case, coarsening, step, None, cancel, events)
}

fn compute_on(
    case: &Case,
    coarsening: usize,
    step: StepScale,
    from: Option<&Resume>,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(Event),
) -> Computed {
    let scene = match scene::build(case, coarsening) {
        Ok(scene) => scene,
        Err(error) => return Computed::failed(error.to_string()),
    };
    let mut settings = settings(case, &scene);
    if let StepScale::Times(ratio) = step {
        settings.time_step_s *= ratio;
        settings.step_tolerance = settings.step_tolerance.map(|t| ratio.powi(3) * t);
    }
    let channels = crate::case::channels(case).into_iter();
    events(Event::Started {
        channels: channels.map(|channel| channel.id).collect(),
    });
    let (cpu, wall) = (cpu_time(), std::time::Instant::now());
    let stop = || cancel.load(Ordering::Relaxed);
    let mut warnings = warnings(&scene, &settings);
    let phases = phases(scene);
    let mut recorder = Recorder::new(case, &phases[0], events, &stop);
    let ended = solve(case, &phases, &settings, &mut recorder, &mut warnings, from);
    recorder.finish();
    wave_decomposition::decompose_response(case, &phases[0], &mut recorder.profile);
    let cost = Cost {
        cpu_s: cpu_time() - cpu,
        wall_s: wall.elapsed().as_secs_f64(),
        companions_wall_s: 0.0,
    };
    tell_damping(&mut settings, &phases[0], &ended.lengths);
    warnings.extend(out_of_water(case, &recorder.profile));
    warnings.extend(recorder.front.warning());
    let mut modes = told_modes(case, &phases[0], &mut warnings);
    warnings.extend(tell_of_modes(
        &settings,
        &ended.lengths,
        &frequencies(&modes),
    ));
    modes.extend(steady_state::settling_quantity(
        case,
        recorder.kept.shapes(),
    ));
    let Recorder {
        kept,
        gather,
        troubles,
        profile,
        ..
    } = recorder;
    warnings.extend(troubles);
    let (history, shapes) = kept.into_parts();
    let (wanted, numbers) = gather.finish(&history.channels, &profile);
    let curves = published_curve::differences(case, &history);
    Computed {
        state: ended.state,
        failure: ended.failure,
        warnings,
        settings,
        work: ended.work,
        cost,
        history,
        shapes,
        profile,
        wanted,
        numbers,
        modes,
        curves,
    }
}

/// Natural modes where the case asks for them, or a warning why there are none.
fn told_modes(case: &Case, scene: &Scene, warnings: &mut Vec<String>) -> Vec<Quantity> {
    natural_modes::frequencies(case, scene).unwrap_or_else(|why| {
        warnings.push(format!("natural modes are not told: {why}"));
        Vec::new()
    })
}

/// The frequencies among numbers \[Hz\].
fn frequencies(numbers: &[Quantity]) -> Vec<f64> {
    let frequency = |q: &&Quantity| q.unit() == "Hz";
    let hz = numbers.iter().filter(frequency);
    hz.map(|q| q.value).collect()
}

/// CPU time of this thread \[s\].
fn cpu_time() -> f64 {
    let t = clock_gettime(ClockId::ThreadCPUTime);
    t.tv_sec as f64 + 1e-9 * t.tv_nsec as f64
}

/// A run that gave up before its first step.
pub(super) fn refused(failure: String, work: Work) -> MarchResult {
    MarchResult {
        state: RunState::Failed,
        failure: Some(failure),
        work,
        lengths: Vec::new(),
    }
}

/// Brings the line to its start and runs the method of the case.
fn solve<'a>(
    case: &Case,
    phases: &'a [Scene],
    settings: &Settings,
    sink: &mut Recorder<'a>,
    warnings: &mut Vec<String>,
    from: Option<&Resume>,
) -> MarchResult {
    let scene = &phases[0];
    let mut state = scene.initial_state();
    let mut work = Work::default();
    let said = warnings.len();
    let began = match warm_start(case, scene) {
        Ok(began) => began.filter(|_| from.is_none()),
        Err(failure) => return refused(failure, work),
    };
    let began = began.map(|began| {
        state = began.state;
        began.carried
    });
    let in_motion = began.is_some() && case.solver.method != Method::Static;
    if let Some(resume) = from {
        work.iterations = resume.checkpoint.start_iterations;
        warnings.extend(resume.checkpoint.warnings.iter().cloned());
    } else if !in_motion
        && let Err(failure) = come_to_rest(case, scene, &mut state, &mut work, warnings)
    {
        give(sink, &state);
        return refused(failure, work);
    }
    scene.apply_start_velocity(&mut state);
    let carried = began.flatten();
    let from = &From {
        resume: from,
        began: in_motion,
        carried: carried.as_ref(),
        warnings: &warnings[said..],
    };
    run_method(case, settings, phases, &mut state, sink, work, from)
}

/// Runs the method of the case from where the line is now.
fn run_method<'a>(
    case: &Case,
    settings: &Settings,
    phases: &'a [Scene],
    state: &mut State,
    sink: &mut Recorder<'a>,
    work: Work,
    from: &From<'_>,
) -> MarchResult {
    let scene = &phases[0];
    let nodes = scene.nodes();
    let tolerance = position_tolerance(case, scene);
    let newton = case.solver.max_iterations;
    match case.solver.method {
        Method::Static => {
            give(sink, state);
            MarchResult {
                state: RunState::Done,
                failure: None,
                work,
                lengths: Vec::new(),
            }
        }
        Method::Quasi => {
            let method = QuasiStatic::new(nodes, tolerance, newton);
            march(method, settings, phases, state, sink, work, from)
        }
        Method::Rk4 => {
            if settings
                .stability_limit_s
                .is_some_and(|limit| settings.time_step_s > limit)
            {
                return refused(unstable(settings), work);
            }
            scene.update_wave_kinematics(0.0, state);
            if from.carried.is_none() {
                scene.accelerate(0.0, state);
            }
            march(Rk4::new(nodes), settings, phases, state, sink, work, from)
        }
        Method::Alpha | Method::Auto => {
            scene.update_wave_kinematics(0.0, state);
            // Its acceleration is its own: derived anew it would lose an order.
            if from.carried.is_none() {
                scene.accelerate(0.0, state);
            }
            let method = GeneralizedAlpha::new(nodes, case.solver.rho_inf, tolerance, newton);
            let method = match settings.step_tolerance {
                Some(tolerance) => method.controlled(control(case, scene, tolerance)),
                None => method,
            };
            let method = match scene.slip_speed() {
                Some(slip) => method.resolving(SHARE_OF_SLIP * slip),
                None => method,
            };
            march(method, settings, phases, state, sink, work, from)
        }
    }
}

/// Friction that goes with the velocity is known to this share of its greatest once velocities are known to this share of
/// its slip speed.
const SHARE_OF_SLIP: f64 = 1e-3;

/// Errors allowed in a step, from the dimensionless tolerance of the case.
fn control(case: &Case, scene: &Scene, tolerance: f64) -> ErrorLimits {
    let length = scene.arc.last().copied().unwrap_or(1.0);
    let speed = (case.environment.gravity_m_per_s2 * length).sqrt();
    ErrorLimits {
        position: tolerance * length,
        velocity: 2.0 * tolerance * speed,
    }
}

/// Gives a single state to the sink.
fn give(sink: &mut Recorder<'_>, state: &State) {
    let _: Progressing = sink.accept(Instant {
        time: 0.0,
        state,
        steps: 0,
        output: true,
    });
}

fn unstable(settings: &Settings) -> String {
    format!(
        "time step {} s is above the stability limit of RK4, {:.3e} s, set by {}; \
         choose a smaller step, leave it open, or use the solver `alpha`",
        settings.time_step_s,
        settings.stability_limit_s.unwrap_or_default(),
        settings.stability_limit_at.as_deref().unwrap_or_default(),
    )
}

/// A node this little above still water is at it \[m\].
const LITTLE: f64 = 1e-3;

/// That a part of the line was above still water and counted as under water all the same, at output times.
fn out_of_water(case: &Case, profile: &Profile) -> Option<String> {
    let water = &case.environment;
    if water.water_surface == WaterSurface::Crossed || water.water_density_kg_per_m3 <= 0.0 {
        return None;
    }
    let above = profile.z_max.iter().filter(|z| **z > LITTLE).count();
    (above > 0).then(|| {
        format!(
            "{above} of {} nodes came above still water and counted as under water all the same; \
             environment.water_surface = \"crossed\" gives them their weight in air",
            profile.z_max.len()
        )
    })
}

/// What the user should know before trusting the numbers.
fn warnings(scene: &Scene, settings: &Settings) -> Vec<String> {
    let mut list = scene.remarks.clone();
    if settings.method == "quasi" && scene.weight.iter().sum::<f64>() > 0.0 {
        list.push(
            "quasi-static: inertia is left out; compare with `alpha` to see whether it matters"
                .to_owned(),
        );
    }
    list
}
