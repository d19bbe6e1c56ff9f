//! Speed against error of any case: every method at several settings, its cost beside its error in time.
//!
//! Errors are held against a reference of another method in much finer steps, whose own error is estimated; a point with
//! an error below ten times that is marked. The error of the mesh is listed separately. Cost is
//! CPU time, the least of several repeats on one thread, and counts of work that no machine changes (Hairer and Wanner
//! 1996 call the picture of both a work-precision diagram).

mod equal_error;
mod error;
mod view;

use std::sync::atomic::{AtomicBool, Ordering};

pub use equal_error::{MedianPoint, WorkComparison, compare, comparison_table};
pub use error::Errors;
pub use view::{chart, mesh_table, table};

use crate::case::{Case, Method};
use crate::run::job::{self, Request};
use crate::run::{Quantity, Run, RunState};
use crate::scene;

/// What is to be measured.
#[derive(Debug, Clone)]
pub struct SpeedPlan {
    /// The points, method by method, the coarsest setting first.
    pub points: Vec<SpeedSetting>,
    /// The reference.
    pub reference: SpeedSetting,
    /// The same in steps of twice its length, for the error of the reference.
    pub coarser: SpeedSetting,
    /// What was left out and why, in words.
    pub left_out: Vec<String>,
}

/// A method at one setting.
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedSetting {
    /// The curve it is a point of: `alpha, steps vary`.
    pub solver: String,
    /// What sets its accuracy: `tolerance 2e-5`.
    pub setting: String,
    /// The case computed so, without companion runs.
    pub case: Case,
}

/// A point of the table.
#[derive(Debug, Clone)]
pub struct SpeedPoint {
    /// What was computed.
    pub setting: SpeedSetting,
    /// The run, the cheapest of its repeats.
    pub run: Run,
    /// Its errors against the reference; absent where it failed.
    pub errors: Option<Errors>,
}

/// The results.
#[derive(Debug, Clone)]
pub struct SpeedStudy {
    /// The points.
    pub points: Vec<SpeedPoint>,
    /// What they are held against.
    pub reference: SpeedPoint,
    /// Single numbers of the case as it stands, with their errors in time and by half the mesh.
    pub mesh: Vec<Quantity>,
    /// What was left out and why, in words.
    pub left_out: Vec<String>,
}

/// Why there is no study.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SpeedError {
    /// Nothing moves.
    #[error(
        "the case is static: nothing is marched through time; choose a method with --set solver.method=alpha"
    )]
    Static,
    /// The line cannot be made.
    #[error("{0}")]
    Scene(String),
    /// The reference did not come to its end.
    #[error("the reference, {setting}, failed: {why}")]
    Reference {
        /// What it is.
        setting: String,
        /// Why it failed.
        why: String,
    },
    /// The user stopped it.
    #[error("stopped")]
    Stopped,
}

/// Evaluations of the force at all nodes that the reference may cost; about a minute.
const DEAREST: f64 = 1e9;

/// Shares of the tolerance of the case at which steps of varying length are measured.
const TOLERANCES: [f64; 5] = [4.0, 1.0, 0.25, 0.0625, 0.015_625];

/// Shares of the longest step that suits the case at which constant steps are measured.
const STEPS: [f64; 5] = [1.0, 0.5, 0.25, 0.125, 0.0625];

/// Shares of the stability limit at which RK4 is measured.
const EXPLICIT: [f64; 2] = [0.9, 0.45];

/// The points for a case, and the reference: RK4 at a sixteenth of its limit, or, where that would take too long,
/// generalized-alpha in constant steps, 64 to the longest, without numerical damping to speak of.
///
/// # Errors
/// [`SpeedError`] where the case is static or no line can be built from it.
pub fn plan(case: &Case) -> Result<SpeedPlan, SpeedError> {
    if case.solver.method == Method::Static {
        return Err(SpeedError::Static);
    }
    let scene = scene::build(case, 1).map_err(|e| SpeedError::Scene(e.to_string()))?;
    let limit = scene.explicit_limit().0;
    let longest = longest_step(case, &scene);
    let mut points = Vec::new();
    for share in TOLERANCES {
        let tolerance = rounded(case.solver.step_tolerance * share);
        let mut case = with(case, Method::Alpha, None);
        case.solver.step_tolerance = tolerance;
        points.push(SpeedSetting {
            solver: "alpha, steps vary".to_owned(),
            setting: format!("tolerance {tolerance:.1e}"),
            case,
        });
    }
    let constant = |solver: &str, method, step: f64| SpeedSetting {
        solver: solver.to_owned(),
        setting: format!("step {step:.2e} s"),
        case: with(case, method, Some(step)),
    };
    points.extend(STEPS.map(|share| constant("alpha", Method::Alpha, rounded(longest * share))));
    let evaluations =
        |step: f64| 4.0 * case.solver.duration_s / step * scene.line.mass.len() as f64;
    let mut left_out = vec![
        "quasi: it leaves inertia out, so that its distance is one of models and not of time steps"
            .to_owned(),
    ];
    let affordable = |step: &f64| evaluations(*step) <= DEAREST;
    let explicit = EXPLICIT.map(|share| rounded(limit * share));
    let (fine, solver, method) = match rounded(limit / 16.0) {
        step if affordable(&step) => (step, "rk4", Method::Rk4),
        _ => (rounded(longest / 64.0), "alpha", Method::Alpha),
    };
    if method != Method::Rk4 {
        left_out.push(format!(
            "rk4 as reference: stable steps are {limit:.1e} s, which would take {:.0e} evaluations of the force; the \
             reference is alpha itself in steps much finer",
            evaluations(limit / 16.0) / scene.line.mass.len() as f64
        ));
    }
    points.extend(
        explicit
            .iter()
            .filter(|step| affordable(step))
            .map(|step| constant("rk4", Method::Rk4, *step)),
    );
    if !explicit.iter().all(affordable) {
        left_out.push("rk4: its stable steps are too many to wait for".to_owned());
    }
    Ok(SpeedPlan {
        points,
        reference: constant(solver, method, fine),
        coarser: constant(solver, method, 2.0 * fine),
        left_out,
    })
}

/// Computes a plan, reporting each run before it begins: its number, how many there are, its name.
///
/// # Errors
/// [`SpeedError`] where the reference fails or the user stops it.
pub fn compute(
    case: &Case,
    plan: SpeedPlan,
    repeats: usize,
    cancel: &AtomicBool,
    progress: &mut dyn FnMut(usize, usize, &str),
) -> Result<SpeedStudy, SpeedError> {
    let mut runner = Runner {
        total: plan.points.len() + 3,
        begun: 0,
        cancel,
        progress,
    };
    let reference = runner.reference(&plan.reference, plan.reference.name())?;
    // The whole difference to twice the step: no order is presumed where forces may jump.
    let own = error::errors(&runner.run(&plan.coarser, 1)?, &reference);
    let mut points = Vec::with_capacity(plan.points.len());
    for setting in plan.points {
        let run = runner.run(&setting, repeats)?;
        let errors = error::errors(&run, &reference);
        points.push(SpeedPoint {
            setting,
            run,
            errors,
        });
    }
    let mut estimated = case.clone();
    estimated.solver.error_estimate = true;
    let unchanged = SpeedSetting {
        solver: "as the case stands".to_owned(),
        setting: "and with half the segments".to_owned(),
        case: estimated,
    };
    let mesh = runner.run(&unchanged, 1)?.summary;
    Ok(SpeedStudy {
        points,
        reference: SpeedPoint {
            setting: plan.reference,
            run: reference,
            errors: own,
        },
        mesh,
        left_out: plan.left_out,
    })
}

impl SpeedSetting {
    /// Curve and setting.
    fn name(&self) -> String {
        format!("{}, {}", self.solver, self.setting)
    }
}

/// Runs settings one after the other, and reports each before it begins.
struct Runner<'a> {
    /// How many there are, and have begun.
    total: usize,
    begun: usize,
    cancel: &'a AtomicBool,
    progress: &'a mut dyn FnMut(usize, usize, &str),
}

impl Runner<'_> {
    /// The run of a setting, the cheapest of several.
    fn run(&mut self, setting: &SpeedSetting, repeats: usize) -> Result<Run, SpeedError> {
        self.begun += 1;
        (self.progress)(self.begun, self.total, &setting.name());
        let run = cheapest(&setting.case, repeats, self.cancel);
        let stopped = self.cancel.load(Ordering::Relaxed);
        if stopped {
            Err(SpeedError::Stopped)
        } else {
            Ok(run)
        }
    }

    /// A run that others are held against, by its name in an error.
    fn reference(&mut self, setting: &SpeedSetting, name: String) -> Result<Run, SpeedError> {
        let run = self.run(setting, 1)?;
        if run.info.state == RunState::Done {
            return Ok(run);
        }
        Err(SpeedError::Reference {
            setting: name,
            why: run.info.failure.unwrap_or_default(),
        })
    }
}

/// The longest step that suits the case \[s\]: its own, or the one chosen for it.
fn longest_step(case: &Case, scene: &scene::Scene) -> f64 {
    let open = with(case, Method::Alpha, None);
    let chosen = crate::run::settings::settings(&open, scene).time_step_s;
    case.solver
        .time_step_s
        .map_or(chosen, |step| step.max(chosen))
}

/// To two digits, so that a setting is what its name says.
fn rounded(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

fn with(case: &Case, method: Method, step: Option<f64>) -> Case {
    let mut case = case.clone();
    case.solver.method = method;
    case.solver.time_step_s = step;
    case.solver.error_estimate = false;
    case
}

/// A run of the case, the one of several that took the least CPU time.
fn cheapest(case: &Case, repeats: usize, cancel: &AtomicBool) -> Run {
    let request = Request {
        case: case.clone(),
        text: String::new(),
        file: String::new(),
        overrides: Vec::new(),
        id: "speed".to_owned(),
    };
    let once = || job::execute(&request, cancel, &mut |_| {});
    let mut best = once();
    for _ in 1..repeats {
        if cancel.load(Ordering::Relaxed) || best.info.state != RunState::Done {
            break;
        }
        let again = once();
        if again.info.cost.cpu_s < best.info.cost.cpu_s {
            best = again;
        }
    }
    best
}
