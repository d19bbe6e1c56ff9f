//! Speed against error of any case: every method at several settings, its cost beside its error in time.
//!
//! Errors are held against a reference of another method in much finer steps, whose own error is estimated; a point with
//! an error below ten times that is marked. The error of the mesh is listed separately. Cost is
//! CPU time, the least of several repeats on one thread, and counts of work that no machine changes (Hairer and Wanner
//! 1996 call the picture of both a work-precision diagram).

pub mod at_rest;
mod equal_error;
mod error;
mod view;

use std::sync::atomic::{AtomicBool, Ordering};

pub use equal_error::{MedianPoint, WorkComparison, compare, comparison_table};
pub use error::SolutionErrors;
pub use view::{chart, mesh_table, table};

use super::timed::{StepBounds, Timed};
use crate::case::Method;
use crate::run::accuracy::steps::Steps;
use crate::run::job::{self, Request};
use crate::run::{Quantity, Run, RunState};

/// What is to be measured.
#[derive(Debug, Clone)]
pub struct SpeedPlan<C> {
    /// The points, method by method, the coarsest setting first.
    pub points: Vec<SpeedSetting<C>>,
    /// The reference.
    pub reference: SpeedSetting<C>,
    /// The same in steps of twice its length, for the error of the reference.
    pub coarser: SpeedSetting<C>,
    /// What was left out and why, in words.
    pub left_out: Vec<String>,
}

/// A method at one setting, by name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SettingName {
    /// The curve it is a point of: `alpha, steps vary`.
    pub solver: String,
    /// What sets its accuracy: `tolerance 2e-5`.
    pub setting: String,
}

/// A method at one setting.
#[derive(Debug, Clone)]
pub struct SpeedSetting<C> {
    /// Its name.
    pub name: SettingName,
    /// Its steps.
    pub steps: Steps,
    /// The scene computed so, without companion runs.
    pub case: C,
}

/// A point of the table.
#[derive(Debug, Clone)]
pub struct SpeedPoint {
    /// What was computed.
    pub setting: SettingName,
    /// The run, the cheapest of its repeats.
    pub run: Run,
    /// Its errors against the reference; absent where it failed.
    pub errors: Option<SolutionErrors>,
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
        "nothing is marched at rest, so that there are no steps to compare; choose a method for a case with --set solver.method=alpha, add a \
         table `[solver]` with its `duration_s` to a system"
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

/// Steps of a reference that is not explicit by the longest that suits the scene.
const FINEST: f64 = 1.0 / 64.0;
/// Why a scene without inertia is measured by one method.
const HAS_INERTIA: &str = "alpha, rk4: the case leaves inertia out, so that their distance is one of models and not of time steps; choose \
     one with --set solver.method=alpha";
/// Evaluations of the force at all nodes that the reference may cost; about a minute.
const DEAREST: f64 = 1e9;

/// Shares of the tolerance of the case at which steps of varying length are measured.
const TOLERANCES: [f64; 5] = [4.0, 1.0, 0.25, 0.0625, 0.015_625];

/// Shares of the longest step that suits the case at which constant steps are measured.
const STEPS: [f64; 5] = [1.0, 0.5, 0.25, 0.125, 0.0625];

/// Shares of the stability limit at which RK4 is measured.
const EXPLICIT: [f64; 2] = [0.9, 0.45];

/// The points for a scene, and the reference: RK4 at a sixteenth of its limit, or, where that would take too long,
/// generalized-alpha in constant steps, 64 to the longest, without numerical damping to speak of.
///
/// # Errors
/// [`SpeedError`] where the case is static or no line can be built from it.
pub fn plan<C: Timed>(case: &C) -> Result<SpeedPlan<C>, SpeedError> {
    let own = moving(case)?;
    let bounds = case.bounds().map_err(SpeedError::Scene)?;
    let by_tolerance = TOLERANCES.map(|share| by_tolerance(case, own, share));
    let constant = |method, step: f64| {
        let steps = Steps {
            method,
            length: Some(step),
            ..own
        };
        let solver = match method {
            Method::Rk4 => "rk4",
            Method::Quasi => "quasi",
            _ => "alpha",
        };
        setting(case, solver, format!("step {step:.2e} s"), steps)
    };
    let longest = bounds.longest;
    if own.method == Method::Quasi {
        let by = |share: f64| constant(Method::Quasi, rounded(longest * share));
        return Ok(SpeedPlan {
            points: STEPS.map(by).into(),
            reference: by(FINEST),
            coarser: by(2.0 * FINEST),
            left_out: vec![HAS_INERTIA.to_owned()],
        });
    }
    let implicit = STEPS.map(|share| constant(Method::Alpha, rounded(longest * share)));
    let explicit = EXPLICIT.map(|share| rounded(bounds.explicit * share));
    let evaluations = |step: f64| 4.0 * case.duration_s() / step * bounds.nodes as f64;
    let affordable = |step: &f64| step.is_finite() && evaluations(*step) <= DEAREST;
    let (fine, method) = match rounded(bounds.explicit / 16.0) {
        step if affordable(&step) => (step, Method::Rk4),
        _ => (rounded(longest * FINEST), Method::Alpha),
    };
    let dearest = evaluations(bounds.explicit / 16.0) / bounds.nodes.max(1) as f64;
    let affordable: Vec<f64> = explicit.into_iter().filter(affordable).collect();
    let left_out = left_out(&bounds, method, dearest, affordable.len() == EXPLICIT.len());
    let explicit = affordable.iter().map(|step| constant(Method::Rk4, *step));
    Ok(SpeedPlan {
        points: by_tolerance
            .into_iter()
            .chain(implicit)
            .chain(explicit)
            .collect(),
        reference: constant(method, fine),
        coarser: constant(method, 2.0 * fine),
        left_out,
    })
}

/// Generalized-alpha in steps that vary, by this share of the tolerance that the case sets.
fn by_tolerance<C: Timed>(case: &C, own: Steps, share: f64) -> SpeedSetting<C> {
    let tolerance = rounded(own.tolerance * share);
    let steps = Steps {
        method: Method::Alpha,
        length: None,
        tolerance,
        ..own
    };
    let name = format!("tolerance {tolerance:.1e}");
    setting(case, "alpha, steps vary", name, steps)
}

/// What a plan leaves out, and why: with the method of its reference, the evaluations of the force at a node that RK4 would take as one, and
/// whether all explicit steps are measured.
fn left_out(
    bounds: &StepBounds,
    reference: Method,
    dearest: f64,
    has_explicit: bool,
) -> Vec<String> {
    let mut left_out = vec![
        "quasi: it leaves inertia out, so that its distance is one of models and not of time steps"
            .to_owned(),
    ];
    let limit = bounds.explicit;
    if limit.is_infinite() {
        left_out.push("rk4: there is no line whose segments bind its steps".to_owned());
        return left_out;
    }
    if reference != Method::Rk4 {
        left_out.push(format!(
            "rk4 as reference: stable steps are {limit:.1e} s, which would take {dearest:.0e} evaluations of the force; the \
             reference is alpha itself in steps much finer"
        ));
    }
    if !has_explicit {
        left_out.push("rk4: its stable steps are too many to wait for".to_owned());
    }
    left_out
}

/// The steps of a scene that moves.
fn moving(case: &impl Timed) -> Result<Steps, SpeedError> {
    let steps = case.steps();
    match steps.method {
        Method::Static => Err(SpeedError::Static),
        _ => Ok(steps),
    }
}

fn setting<C: Timed>(case: &C, solver: &str, setting: String, steps: Steps) -> SpeedSetting<C> {
    SpeedSetting {
        name: SettingName {
            solver: solver.to_owned(),
            setting,
        },
        steps,
        case: case.stepped(steps).estimating(false),
    }
}

/// Computes a plan, reporting each run before it begins: its number, how many there are, its name.
///
/// # Errors
/// [`SpeedError`] where the reference fails or the user stops it.
pub fn compute<C: Timed>(
    case: &C,
    plan: SpeedPlan<C>,
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
    let (fine, coarser) = (&plan.reference, &plan.coarser);
    let reference = runner.reference(&fine.case, &fine.name, fine.name.to_string())?;
    // The whole difference to twice the step: no order is presumed where forces may jump.
    let own = error::errors(&runner.run(&coarser.case, &coarser.name, 1)?, &reference);
    let mut points = Vec::with_capacity(plan.points.len());
    for SpeedSetting { name, case, .. } in plan.points {
        let run = runner.run(&case, &name, repeats)?;
        let errors = error::errors(&run, &reference);
        points.push(SpeedPoint {
            setting: name,
            run,
            errors,
        });
    }
    let unchanged = SettingName {
        solver: "as the case stands".to_owned(),
        setting: "and with half the segments".to_owned(),
    };
    let mesh = runner.run(&case.estimating(true), &unchanged, 1)?.summary;
    Ok(SpeedStudy {
        points,
        reference: SpeedPoint {
            setting: plan.reference.name,
            run: reference,
            errors: own,
        },
        mesh,
        left_out: plan.left_out,
    })
}

impl std::fmt::Display for SettingName {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}, {}", self.solver, self.setting)
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
    fn run<C: Timed>(
        &mut self,
        case: &C,
        name: &SettingName,
        repeats: usize,
    ) -> Result<Run, SpeedError> {
        self.begun += 1;
        (self.progress)(self.begun, self.total, &name.to_string());
        let run = cheapest(case, repeats, self.cancel);
        let stopped = self.cancel.load(Ordering::Relaxed);
        if stopped {
            Err(SpeedError::Stopped)
        } else {
            Ok(run)
        }
    }

    /// A run that others are held against, by its name in an error.
    fn reference<C: Timed>(
        &mut self,
        case: &C,
        name: &SettingName,
        in_error: String,
    ) -> Result<Run, SpeedError> {
        let run = self.run(case, name, 1)?;
        if run.info.state == RunState::Done {
            return Ok(run);
        }
        Err(SpeedError::Reference {
            setting: in_error,
            why: run.info.failure.unwrap_or_default(),
        })
    }
}

/// To two digits, so that a setting is what its name says.
fn rounded(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

/// A run of the case, the one of several that took the least CPU time.
fn cheapest<C: Timed>(case: &C, repeats: usize, cancel: &AtomicBool) -> Run {
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
