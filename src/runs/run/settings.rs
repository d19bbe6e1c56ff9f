//! The settings that a run uses, those included that its file leaves open: by what bounds the steps of its scene, a line or a system of lines.

use super::Settings;
use super::march::too_many_steps;
use super::outlook::{Outlook, StepLengths};
use crate::case::{Method, Solver};
use crate::dynamics::ErrorLimits;
use crate::dynamics::numerical_damping::NumericalDamping;
use crate::dynamics::rk4::{BELOW_LIMIT, above_limit};

/// Share of the stability limit that explicit steps take when left open: the companion that estimates the
/// time error takes twice that and must still be stable.
const EXPLICIT_SHARE: f64 = 0.45;

/// Steps that a period of what a scene forces is divided into at least; steps that vary are shorter where their error asks for it.
pub const STEPS_A_PERIOD: f64 = 20.0;

/// By how much the motion that errors are measured by may exceed that of the ends that cause it.
const RESPONSE: f64 = 10.0;

/// What bounds the steps of a scene, whatever its file asks.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneBounds {
    /// The longest step that sees what is prescribed and how the scene bounces \[s\].
    pub longest_step: f64,
    /// The shortest period that it forces \[s\].
    pub forced_period: f64,
    /// The stability limit of explicit steps \[s\] and what sets it, in words; nothing where nothing binds them.
    pub stability: Option<(f64, String)>,
    /// The limit that explicit steps are chosen by \[s\], at most that one.
    pub explicit_limit: f64,
    /// Newton's tolerance beyond which it would hide a force \[m\].
    pub position_tolerance: f64,
    /// Number of nodes of all lines, both ends counted; 0 without lines.
    pub nodes: usize,
}

impl SceneBounds {
    /// The explicit step chosen for the scene \[s\].
    #[must_use]
    pub fn explicit_step(&self) -> f64 {
        self.longest_step.min(EXPLICIT_SHARE * self.explicit_limit)
    }

    /// The step of a run whose file gives it none: the longest that it allows, where that is alpha's to vary \[s\].
    #[must_use]
    pub fn chosen_step(&self, solver: &Solver) -> f64 {
        let own = solver.longest_step_s;
        match solver.method {
            Method::Rk4 => self.explicit_step(),
            Method::Alpha => own.unwrap_or(self.longest_step),
            Method::Static | Method::Quasi | Method::Auto => self.longest_step,
        }
    }

    /// The settings of a run of the scene.
    #[must_use]
    pub fn settings(&self, solver: &Solver, interval_s: f64) -> Settings {
        let still = !solver.is_in_time();
        let in_time = |value: f64| if still { 0.0 } else { value };
        let (explicit, alpha) = (solver.method == Method::Rk4, solver.method == Method::Alpha);
        let automatic = solver.time_step_s.is_none() && !still;
        let step = solver
            .time_step_s
            .unwrap_or_else(|| self.chosen_step(solver));
        let stability = self.stability.as_ref().filter(|_| explicit);
        let tolerance = solver.position_tolerance_m.min(self.position_tolerance);
        Settings {
            method: solver.method.name().to_owned(),
            duration_s: in_time(solver.duration_s),
            time_step_s: in_time(step),
            time_step_automatic: automatic,
            step_tolerance: (automatic && alpha).then_some(solver.step_tolerance),
            rho_inf: alpha.then_some(solver.rho_inf),
            stability_limit_s: stability.map(|(limit, _)| *limit),
            stability_limit_at: stability.map(|(_, at)| at.clone()),
            position_tolerance_m: (!explicit).then_some(tolerance),
            nodes: self.nodes,
            output_interval_s: in_time(interval_s),
            ..Settings::default()
        }
    }

    /// The outlook for a file that leaves the choice of the method open; nothing without lines, whose segments bind explicit steps.
    #[must_use]
    pub fn outlook(&self, solver: &Solver) -> Option<Outlook> {
        let (limit, at) = self.stability.as_ref().filter(|_| self.nodes > 0)?;
        let given = solver.time_step_s;
        Some(Outlook::of_steps(&StepLengths {
            duration: solver.duration_s,
            limit: *limit,
            limited_by: at,
            given,
            explicit: given.unwrap_or_else(|| self.explicit_step()),
            implicit: given.unwrap_or(self.longest_step),
        }))
    }
}

/// Why a run is refused before its first step, and what to do: unstable steps, or too many.
#[must_use]
pub fn refused(settings: &Settings) -> Option<(String, String)> {
    let (step, duration) = (settings.time_step_s, settings.duration_s);
    if duration <= 0.0 {
        return None;
    }
    if let Some(problem) = unstable(settings) {
        return Some((problem, BELOW_LIMIT.to_owned()));
    }
    let fewer = "make the line less stiff, or choose the method `alpha`";
    too_many_steps(duration, step, fewer)
}

/// Why explicit steps are unstable; nothing where they are not.
#[must_use]
pub fn unstable(settings: &Settings) -> Option<String> {
    let limit = settings.stability_limit_s?;
    let at = settings.stability_limit_at.as_deref().unwrap_or_default();
    let step = settings.time_step_s;
    (step > limit).then(|| above_limit(step, limit, at))
}

/// Distance \[m\] and speed \[m/s\] that the errors of a step are measured by: those of a line and of its fall by its own length or, where
/// only what is prescribed disturbs the scene, ten times the distance and the speed of that.
#[must_use]
pub fn motion_scale((length, speed): (f64, f64), (far, fast): (f64, f64)) -> (f64, f64) {
    if far <= 0.0 || fast <= 0.0 {
        return (length, speed);
    }
    (length.min(RESPONSE * far), speed.min(RESPONSE * fast))
}

/// Errors allowed in a step, from a dimensionless tolerance and the scale of what moves.
#[must_use]
pub fn error_limits(tolerance: f64, (distance, speed): (f64, f64)) -> ErrorLimits {
    ErrorLimits {
        position: tolerance * distance,
        velocity: 2.0 * tolerance * speed,
    }
}

/// Sets the numerical damping of generalized-alpha at the period that the scene forces \[s\], in steps of these lengths \[s\] and numbers.
pub fn set_numerical_damping(settings: &mut Settings, period: f64, steps: &[(f64, u64)]) {
    if let (Some(rho), false) = (settings.rho_inf, steps.is_empty()) {
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
