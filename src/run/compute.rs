//! One computation of a case, without companions: scene, settings, start, march.

use std::sync::atomic::{AtomicBool, Ordering};

use rustix::time::{ClockId, clock_gettime};

use super::job::Event;
use super::recorder::Recorder;
use super::settings::{position_tolerance, settings};
use super::{Cost, History, LineShape, Profile, RunState, Settings, Work};
use crate::case::{Case, Method};
use crate::dynamics::alpha::{Alpha, Control};
use crate::dynamics::quasi::Quasi;
use crate::dynamics::rk4::Rk4;
use crate::dynamics::{March, MarchError, Outcome, Stepper, Tally};
use crate::scene::{self, Scene};
use crate::solve::{Instant, Progressing, Sink, State, System};
use crate::statics::equilibrium::{Search, instabilities};

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
}

/// The time step of a computation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Step {
    /// As the case sets it, or as chosen for it.
    AsSet,
    /// Such that the time error is `2^p` times as large, p the order of the method: twice the step or, where the steps
    /// vary, `2^(p + 1)` times the error in each (which grows with one power more) and twice the longest.
    Doubled,
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
        }
    }
}

/// Computes a case on a mesh coarsened by `coarsening`.
pub(super) fn compute(
    case: &Case,
    coarsening: usize,
    step: Step,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(Event),
) -> Computed {
    let scene = match scene::build(case, coarsening) {
        Ok(scene) => scene,
        Err(error) => return Computed::failed(error.to_string()),
    };
    let mut settings = settings(case, &scene);
    if step == Step::Doubled {
        settings.time_step_s *= 2.0;
        settings.step_tolerance = settings.step_tolerance.map(|t| 8.0 * t);
    }
    let named = crate::case::channels(case)
        .into_iter()
        .map(|c| (c.name, c.unit.to_owned()));
    events(Event::Started {
        channels: named.collect(),
    });
    let (cpu, wall) = (cpu_time(), std::time::Instant::now());
    let stop = || cancel.load(Ordering::Relaxed);
    let mut recorder = Recorder::new(case, &scene, events, &stop);
    let mut warnings = warnings(&scene, &settings);
    let ended = solve(case, &scene, &settings, &mut recorder, &mut warnings);
    let cost = Cost {
        cpu_s: cpu_time() - cpu,
        wall_s: wall.elapsed().as_secs_f64(),
        companions_wall_s: 0.0,
    };
    let Recorder {
        history,
        shapes,
        profile,
        ..
    } = recorder;
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
    }
}

/// CPU time of this thread \[s\].
fn cpu_time() -> f64 {
    let t = clock_gettime(ClockId::ThreadCPUTime);
    t.tv_sec as f64 + 1e-9 * t.tv_nsec as f64
}

/// How a computation ended.
struct Ended {
    state: RunState,
    failure: Option<String>,
    work: Work,
}

/// Brings the line to its start and runs the method of the case.
fn solve(
    case: &Case,
    scene: &Scene,
    settings: &Settings,
    sink: &mut Recorder<'_>,
    warnings: &mut Vec<String>,
) -> Ended {
    let mut state = scene.initial_state();
    let mut work = Work::default();
    if let Err(failure) = come_to_rest(case, scene, &mut state, &mut work, warnings) {
        give(sink, &state);
        return Ended {
            state: RunState::Failed,
            failure: Some(failure),
            work,
        };
    }
    let nodes = scene.nodes();
    let tolerance = position_tolerance(case, scene);
    let newton = case.solver.max_iterations;
    match case.solver.method {
        Method::Static => {
            give(sink, &state);
            Ended {
                state: RunState::Done,
                failure: None,
                work,
            }
        }
        Method::Quasi => {
            let method = Quasi::new(nodes, tolerance, newton);
            march(method, settings, scene, &mut state, sink, work)
        }
        Method::Rk4 => {
            if settings
                .stability_limit_s
                .is_some_and(|limit| settings.time_step_s > limit)
            {
                return Ended {
                    state: RunState::Failed,
                    failure: Some(unstable(settings)),
                    work,
                };
            }
            scene.accelerate(0.0, &mut state);
            march(Rk4::new(nodes), settings, scene, &mut state, sink, work)
        }
        Method::Alpha => {
            scene.accelerate(0.0, &mut state);
            let method = Alpha::new(nodes, case.solver.rho_inf, tolerance, newton);
            let method = match settings.step_tolerance {
                Some(tolerance) => method.controlled(control(case, scene, tolerance)),
                None => method,
            };
            march(method, settings, scene, &mut state, sink, work)
        }
    }
}

/// A turn between neighbouring segments \[rad\] from which the mesh error is not of second order any more.
const SHARP: f64 = 0.8;

/// Brings the line to its equilibrium, where the case asks for that; says so when it would not stay there.
///
/// # Errors
/// Why there is none, in words.
fn come_to_rest(
    case: &Case,
    scene: &Scene,
    state: &mut State,
    work: &mut Work,
    warnings: &mut Vec<String>,
) -> Result<(), String> {
    if !scene.start_in_equilibrium && case.solver.method != Method::Static {
        return Ok(());
    }
    match Search::default().run(scene, 0.0, state) {
        Ok(found) => work.iterations += found.iterations,
        Err(error) => {
            work.iterations += error.iterations;
            return Err(error.to_string());
        }
    }
    if instabilities(scene, 0.0, state).is_some_and(|ways| ways > 0) {
        let unstable = "the equilibrium found is not stable: forces balance, but a line pushed aside a little would leave \
                        this shape for another one; start from another shape to find that";
        warnings.push(unstable.to_owned());
    }
    let (turn, node) = scene.sharpest_turn(state);
    if turn > SHARP {
        warnings.push(format!(
            "the line at rest turns by {:.0} degrees at node {node}: too sharply for segments of that length, and more \
             than the estimated errors show; use more segments there",
            turn.to_degrees()
        ));
    }
    Ok(())
}

/// Errors allowed in a step, from the dimensionless tolerance of the case.
fn control(case: &Case, scene: &Scene, tolerance: f64) -> Control {
    let length = scene.arc.last().copied().unwrap_or(1.0);
    let speed = (case.environment.gravity_m_per_s2 * length).sqrt();
    Control {
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

fn march<M: Stepper>(
    mut method: M,
    settings: &Settings,
    scene: &Scene,
    state: &mut State,
    sink: &mut Recorder<'_>,
    mut work: Work,
) -> Ended {
    let march = March {
        duration: settings.duration_s,
        step: settings.time_step_s,
        output: settings.output_interval_s,
    };
    let result = march.run(&mut method, scene, state, sink);
    let Tally {
        iterations,
        evaluations,
    } = method.tally();
    work.iterations += iterations;
    work.evaluations += evaluations;
    let (state, failure, steps, rejections) = match result {
        Ok(Outcome {
            steps,
            rejections,
            stopped: true,
        }) => (RunState::Cancelled, None, steps, rejections),
        Ok(Outcome {
            steps,
            rejections,
            stopped: false,
        }) => (RunState::Done, None, steps, rejections),
        Err(error) => {
            let advice = advice(&error);
            let MarchError {
                steps, rejections, ..
            } = error;
            (
                RunState::Failed,
                Some(format!("{error}; {advice}")),
                steps,
                rejections,
            )
        }
    };
    work.steps = steps;
    work.rejections = rejections;
    Ended {
        state,
        failure,
        work,
    }
}

/// What to try after a step that failed at every length.
fn advice(error: &MarchError) -> &'static str {
    use crate::solve::NewtonError::{Astray, Diverged, NotFinite, Singular, Unstable};
    match error.why {
        Diverged { .. } => {
            "try a smaller time_step_s, a smaller rho_inf, or more segments near that node"
        }
        Singular { .. } => "give that part of the line mass, drag or tension",
        Astray { .. } => {
            "give the line tangential drag or axial damping, or use the solver `alpha`"
        }
        Unstable { .. } => "use the solver `alpha`, or try a smaller time_step_s",
        NotFinite { .. } => "try a smaller time_step_s, and look for extreme inputs near that node",
    }
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
