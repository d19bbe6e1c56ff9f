//! The settings that the solver uses, those included that the case leaves open.

use super::Settings;
use super::outlook::{Outlook, StepLengths};
use crate::case::{Case, Method, Solver};
use crate::dynamics::numerical_damping::NumericalDamping;
use crate::numerics::V3;
use crate::physics::EndMotion;
use crate::scene::{EndCondition, Scene};
use crate::solve::{Kinematics, StaticSearch};

/// Share of the stability limit that explicit steps take when left open: the companion that estimates the
/// time error takes twice that and must still be stable.
const EXPLICIT_SHARE: f64 = 0.45;

/// Steps an axial period of the payload on its line, or a period of prescribed motion, is divided into.
/// at least; steps that vary are shorter where their error asks for it.
const STEPS_A_PERIOD: f64 = 20.0;

/// The settings of a run of this case.
#[must_use]
pub fn settings(case: &Case, scene: &Scene) -> Settings {
    let solver = &case.solver;
    let still = solver.method == Method::Static;
    let explicit = solver.method == Method::Rk4;
    let limit = explicit.then(|| scene.explicit_limit());
    let (step, automatic) = match solver.time_step_s {
        _ if still => (0.0, false),
        Some(step) => (step, false),
        None => (longest_step(solver, scene, limit.map(|l| l.0)), true),
    };
    Settings {
        method: method_name(solver.method).to_owned(),
        duration_s: if still { 0.0 } else { solver.duration_s },
        time_step_s: step,
        time_step_automatic: automatic,
        step_tolerance: (automatic && solver.method == Method::Alpha)
            .then_some(solver.step_tolerance),
        rho_inf: (solver.method == Method::Alpha).then_some(solver.rho_inf),
        stability_limit_s: limit.map(|l| l.0),
        stability_limit_at: limit
            .map(|l| format!("segment {} ({})", l.1, section_of(case, scene, l.1))),
        position_tolerance_m: (!explicit).then(|| position_tolerance(case, scene)),
        nodes: scene.nodes(),
        output_interval_s: if still { 0.0 } else { case.output.interval_s },
        error_method: String::new(),
        ..Settings::default()
    }
}

/// The word for a method, as in case files.
#[must_use]
pub fn method_name(method: Method) -> &'static str {
    match method {
        Method::Auto => "auto",
        Method::Static => "static",
        Method::Quasi => "quasi",
        Method::Rk4 => "rk4",
        Method::Alpha => "alpha",
    }
}

/// Newton's tolerance: the user's, or less where the line is so stiff that this would hide a force.
#[must_use]
pub fn position_tolerance(case: &Case, scene: &Scene) -> f64 {
    case.solver
        .position_tolerance_m
        .min(scene.position_tolerance(1e-4))
}

/// The step of a case that sets none: the longest that it allows, where that is alpha's to vary.
fn longest_step(solver: &Solver, scene: &Scene, limit: Option<f64>) -> f64 {
    let own = solver
        .longest_step_s
        .filter(|_| solver.method == Method::Alpha);
    own.unwrap_or_else(|| automatic_step(scene, limit))
}

/// A share of the stability limit for explicit methods. For implicit ones a share of the shortest period that
/// the scene forces: of prescribed motion, or of the payload bouncing on its line,
/// `2 pi sqrt(m / k)` with k the line's axial stiffness.
fn automatic_step(scene: &Scene, limit: Option<f64>) -> f64 {
    let stable = limit.map_or(f64::INFINITY, |limit| limit * EXPLICIT_SHARE);
    let bounce = stable.min(bounce_period(scene) / STEPS_A_PERIOD);
    let ends = motions(scene).filter_map(|motion| motion.longest_step(STEPS_A_PERIOD));
    ends.fold(bounce, f64::min)
}

/// The motions of the ends that are held.
fn motions(scene: &Scene) -> impl Iterator<Item = &EndMotion> {
    scene.line.ends.iter().filter_map(|end| match end {
        EndCondition::Prescribed(motion) => Some(motion),
        EndCondition::Free => None,
    })
}

/// The shortest period that the scene forces \[s\]: of prescribed motion, or of the line and its payload bouncing.
fn forced_period(scene: &Scene) -> f64 {
    let ends = motions(scene).filter_map(EndMotion::period);
    ends.fold(bounce_period(scene), f64::min)
}

/// Period of the line and its payload bouncing along themselves \[s\].
fn bounce_period(scene: &Scene) -> f64 {
    let line = &scene.line;
    let compliance = line.segments.iter().map(|s| s.axial.length / s.axial.ea);
    let added = line.bodies.iter().map(|b| b.body.added.max());
    let mass = line.mass.iter().sum::<f64>() + added.sum::<f64>();
    std::f64::consts::TAU * (mass * compliance.sum::<f64>()).sqrt()
}

/// By how much the motion that errors are measured by may exceed that of the ends that cause it.
const RESPONSE: f64 = 10.0;

/// Distance \[m\] and speed \[m/s\] that the errors of a step are measured by: of the whole line and of its fall by its own length
/// or, where ends that move disturb a line at rest and nothing else does, of [`RESPONSE`] times their motion.
pub(super) fn motion_scale(case: &Case, scene: &Scene) -> (f64, f64) {
    let length = scene.line.arc.last().copied().unwrap_or(1.0);
    let speed = (case.environment.gravity_m_per_s2 * length).sqrt();
    let disturbed = !scene.start.in_equilibrium
        || scene.start.velocity != V3::zeros()
        || case.start.from_run.is_some()
        || case.traveller.is_some()
        || case.waves.is_some()
        || !scene.events.is_empty();
    let duration = case.solver.duration_s;
    let moved = motions(scene).map(|motion| motion.extent(duration));
    let (far, fast) = moved.fold((0.0_f64, 0.0_f64), |a, b| (a.0.max(b.0), a.1.max(b.1)));
    if disturbed || far <= 0.0 || fast <= 0.0 {
        return (length, speed);
    }
    (length.min(RESPONSE * far), speed.min(RESPONSE * fast))
}

/// Sets the numerical damping of generalized-alpha in steps of these lengths \[s\] and numbers.
pub(super) fn set_numerical_damping(settings: &mut Settings, scene: &Scene, steps: &[(f64, u64)]) {
    if let (Some(rho), false) = (settings.rho_inf, steps.is_empty()) {
        let period = forced_period(scene);
        let omega = std::f64::consts::TAU / period;
        settings.numerical_damping = Some(NumericalDamping::over(rho, omega, steps).damping);
        settings.numerical_damping_period_s = Some(period);
    }
}

/// A mode that loses more than this share of its amplitude in a cycle, or whose period is longer by more than a tenth of
/// it, gives a warning.
const NOTABLE: f64 = 0.01;

/// A warning of the numerical damping and period error of natural modes of these frequencies \[Hz\] by generalized-alpha, in
/// steps of these lengths \[s\] and numbers.
pub(super) fn damped_modes_warning(
    settings: &Settings,
    steps: &[(f64, u64)],
    hz: &[f64],
) -> Option<String> {
    let rho = settings.rho_inf.filter(|_| !steps.is_empty())?;
    let of = |hz: f64| NumericalDamping::over(rho, std::f64::consts::TAU * hz, steps);
    let notable = |hz: &&f64| {
        let made = of(**hz);
        made.lost_a_cycle() > NOTABLE || made.elongation > 0.1 * NOTABLE
    };
    let lowest = hz.iter().filter(notable).copied().reduce(f64::min)?;
    let highest = hz.iter().copied().reduce(f64::max)?;
    let words = |hz: f64| {
        let made = of(hz);
        format!(
            "that of {:.3} s loses {:.2} % of its amplitude a cycle and has its period longer by {:.2} %",
            1.0 / hz,
            100.0 * made.lost_a_cycle(),
            100.0 * made.elongation
        )
    };
    let mut text = format!(
        "steps of {} change natural modes by themselves: {}",
        words_for(steps),
        words(lowest)
    );
    if highest > lowest {
        text.push_str("; ");
        text.push_str(&words(highest));
    }
    Some(text)
}

/// Lengths of steps in words, of one length or from the shortest to the longest.
fn words_for(steps: &[(f64, u64)]) -> String {
    let lengths = || steps.iter().map(|(h, _)| *h);
    let (shortest, longest) = (
        lengths().fold(f64::INFINITY, f64::min),
        lengths().fold(0.0, f64::max),
    );
    if shortest < longest {
        format!("{shortest:.3e} to {longest:.3e} s")
    } else {
        format!("{longest:.3e} s")
    }
}

/// The outlook for a case that leaves the choice of the method open.
pub(super) fn outlook(case: &Case, scene: &Scene) -> Outlook {
    let (limit, segment) = scene.explicit_limit();
    let of = section_of(case, scene, segment);
    let given = case.solver.time_step_s;
    let step = |limit| given.unwrap_or_else(|| automatic_step(scene, limit));
    Outlook::of_steps(&StepLengths {
        duration: case.solver.duration_s,
        limit,
        limited_by: [
            format!("segment {segment}, {of}"),
            format!("segment {segment} ({of})"),
        ],
        given,
        explicit: step(Some(limit)),
        implicit: step(None),
    })
}

/// Name of the section that a segment belongs to.
fn section_of(case: &Case, scene: &Scene, segment: usize) -> String {
    let index = scene
        .labels
        .joints
        .iter()
        .take_while(|j| j.node <= segment)
        .count();
    index
        .checked_sub(1)
        .and_then(|i| case.line.get(i))
        .map_or_else(|| "rod of the payload".to_owned(), |s| s.name.clone())
}
