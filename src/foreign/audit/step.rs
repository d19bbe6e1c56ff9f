//! Whether the time step of a file is stable, and what error it leaves.

use std::f64::consts::PI;

use super::Audit;
use super::finding::{AuditFinding, Topic};
use super::lumped::LumpedModel;
use super::lumped::spectrum::{FastestMode, Scheme, fastest};
use super::start::step_of;
use crate::import::mooring::Mooring;
use crate::number::{percent, si};
use crate::numerics::V3;

/// Rate at which a motion may grow \[1/s\]: drag takes more.
const GROWTH: f64 = 0.01;
/// Error of the period of a first axial mode that is a finding.
const PERIOD: f64 = 0.05;

/// The time step of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct StepAudit {
    /// The scheme.
    pub scheme: &'static str,
    /// The step \[s\].
    pub step: f64,
    /// Whether the file gives it.
    pub is_given: bool,
    /// The longest stable step \[s\]; nothing where every step lets the fastest mode grow.
    pub longest: Option<f64>,
    /// The fastest mode of the lumped masses.
    pub fastest: FastestMode,
    /// Rate at which it grows \[1/s\]; negative where it decays.
    pub growth: f64,
    /// The line with the shortest first axial mode, its period \[s\], and the error of that by the step.
    pub axial: Option<(String, f64, f64)>,
    /// How the step does by RK2, which `MoorDyn` in `OpenFAST` has alone, where the file names another scheme.
    pub by_rk2: Option<StepByRk2>,
}

/// A step by RK2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepByRk2 {
    /// Rate at which the fastest mode grows \[1/s\].
    pub growth: f64,
    /// A step that was tried and lets nothing grow \[s\]; the step itself where that does not.
    pub stable: Option<f64>,
}

impl StepByRk2 {
    /// Whether the step lets nothing grow.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.growth <= GROWTH
    }
}

/// Parts of a step that are tried: halves of halves.
const HALVINGS: i32 = 12;

/// The rate \[1/s\] at which the mode grows that grows fastest by steps of this length.
fn growth(scheme: Scheme, modes: &[FastestMode], step: f64) -> f64 {
    let rates = modes
        .iter()
        .map(|mode| scheme.amplification(mode, step).ln() / step);
    rates.fold(f64::NEG_INFINITY, f64::max)
}

/// The longest of this step, its half, a quarter and so on that passes.
fn shortened(step: f64, passes: impl Fn(f64) -> bool) -> Option<f64> {
    let tried = (0..=HALVINGS).map(|halvings| step * 0.5_f64.powi(halvings));
    tried.into_iter().find(|step| passes(*step))
}

/// The same that lets no mode grow.
fn stable(scheme: Scheme, modes: &[FastestMode], step: f64) -> Option<f64> {
    shortened(step, |step| growth(scheme, modes, step) <= GROWTH)
}

/// Judges the step about the system at rest.
pub fn find(mooring: &Mooring, model: &LumpedModel, rest: &[V3], audit: &mut Audit) {
    if model.creeps {
        audit
            .not_judged
            .push("The time step: ropes that creep.".to_owned());
        return;
    }
    let setting = mooring.setting("tscheme");
    let name = setting.map_or("RK2", |setting| setting.value.as_str());
    let Some(scheme) = Scheme::named(name) else {
        audit
            .not_judged
            .push(format!("The time step of the scheme {name}."));
        return;
    };
    let modes = fastest(model, rest);
    let given = mooring.setting("dtm");
    let step = step_of(mooring, model);
    if !(step > 0.0 && step.is_finite()) {
        return;
    }
    let rate = |mode: &FastestMode| growth(scheme, std::slice::from_ref(mode), step);
    let fastest = modes
        .iter()
        .copied()
        .max_by(|one, other| rate(one).total_cmp(&rate(other)));
    let Some(mode) = fastest else { return };
    let growth = growth(scheme, &modes, step);
    let longest = scheme.longest_step(&mode);
    let axial = axial(mooring, model, scheme, step);
    let settings = given.or_else(|| mooring.setting("cfl")).or(setting);
    let span = settings.map(|one| one.span.clone());
    let too_long = axial.as_ref().filter(|axial| axial.2 > PERIOD);
    let found = match growth > GROWTH {
        true => Some(unstable(
            scheme,
            step,
            given.is_some(),
            (longest, &mode, &modes),
        )),
        false => too_long.map(|axial| inaccurate(scheme, step, axial, &modes)),
    };
    audit.findings.extend(found.map(|mut one| {
        one.span = span;
        one
    }));
    audit.step = Some(StepAudit {
        scheme: scheme.name(),
        step,
        is_given: given.is_some(),
        longest,
        fastest: mode,
        growth,
        axial,
        by_rk2: (scheme != Scheme::Second).then(|| by_rk2(&modes, step)),
    });
}

/// How a step does by RK2.
fn by_rk2(modes: &[FastestMode], step: f64) -> StepByRk2 {
    StepByRk2 {
        growth: growth(Scheme::Second, modes, step),
        stable: stable(Scheme::Second, modes, step),
    }
}

/// A step that leaves too great an error in the first axial period of a line.
fn inaccurate(
    scheme: Scheme,
    step: f64,
    (line, period, error): &(String, f64, f64),
    modes: &[FastestMode],
) -> AuditFinding {
    let what = format!(
        "steps of {} leave an error of {} in the first axial period of line {line}, {}",
        si(step, "s"),
        percent(*error),
        si(*period, "s")
    );
    let left = |step: f64| scheme.period_error(&first_axial(*period), step);
    let mends = |step: f64| left(step) <= PERIOD && growth(scheme, modes, step) <= GROWTH;
    let finding = |remedy: String| AuditFinding::new(Topic::Step, "dtM", what, remedy);
    match shortened(step, mends) {
        Some(tried) => finding(format!(
            "choose dtM {} or less, with which an error of {} is left",
            si(tried, "s"),
            percent(left(tried))
        ))
        .figure(step, tried, "s"),
        None => finding(
            "none by the step: no part of it that was tried is stable and leaves less".to_owned(),
        ),
    }
}

/// The first axial mode of a line, undamped.
fn first_axial(period: f64) -> FastestMode {
    FastestMode {
        frequency: 2.0 * PI / period,
        damping: 0.0,
    }
}

fn unstable(
    scheme: Scheme,
    step: f64,
    is_given: bool,
    (longest, mode, modes): (Option<f64>, &FastestMode, &[FastestMode]),
) -> AuditFinding {
    let origin = match is_given {
        true => "",
        false => ", the default by the Courant number,",
    };
    let what = format!(
        "steps of {}{origin} by {} are unstable: the fastest mode of the segments has {} rad/s and {} of critical damping",
        si(step, "s"),
        scheme.name(),
        crate::number::digits(mode.frequency, 4),
        percent(mode.damping)
    );
    let tried = longest.and_then(|longest| stable(scheme, modes, 0.9 * longest));
    let (limit, remedy) = match tried {
        Some(tried) => (
            tried / 0.9,
            format!("choose dtM {} or less", si(tried, "s")),
        ),
        None => (0.3 / mode.frequency, otherwise_stable(scheme, mode, modes)),
    };
    AuditFinding::new(Topic::Step, "dtM", what, remedy).figure(step, limit, "s")
}

/// What makes a mode stable that grows with every step of a scheme: damping, or another scheme, each as far as it was tried and does.
fn otherwise_stable(scheme: Scheme, mode: &FastestMode, modes: &[FastestMode]) -> String {
    let damped = FastestMode {
        damping: DAMPED,
        ..*mode
    };
    let by_damping = scheme.longest_step(&damped).map(|step| {
        format!(
            "give the lines internal damping (BA), with {} of the critical one dtM {} or less",
            percent(DAMPED),
            si(0.9 * step, "s")
        )
    });
    let by_scheme = stable(Scheme::Fourth, modes, 2.5 / mode.frequency)
        .map(|step| format!("choose RK4 and dtM {} or less", si(step, "s")));
    let all: Vec<String> = [by_damping, by_scheme].into_iter().flatten().collect();
    match all.is_empty() {
        true => "none that was tried".to_owned(),
        false => all.join(", or "),
    }
}

/// Share of the critical damping with which a mode without is tried.
const DAMPED: f64 = 0.1;

/// The line with the shortest first axial mode: its period \[s\], and the error of a step in it.
fn axial(
    mooring: &Mooring,
    model: &LumpedModel,
    scheme: Scheme,
    step: f64,
) -> Option<(String, f64, f64)> {
    let periods = model.lines.iter().zip(&mooring.lines).map(|(line, of)| {
        let speed = (line.elasticity.initial() / line.mass).sqrt();
        (of.id.clone(), 2.0 * of.length.value / speed)
    });
    let (line, period) = periods.min_by(|one, other| one.1.total_cmp(&other.1))?;
    Some((
        line,
        period,
        scheme.period_error(&first_axial(period), step),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mode(frequency: f64, damping: f64) -> FastestMode {
        FastestMode { frequency, damping }
    }

    #[test]
    fn a_step_that_is_proposed_mends_the_period_and_is_stable() {
        let axial = ("1".to_owned(), 1.0, 0.2);
        let modes = [mode(2.0 * PI, 0.0), mode(40.0, 0.0)];
        for scheme in [Scheme::Euler, Scheme::Second, Scheme::Fourth] {
            let found = inaccurate(scheme, 0.2, &axial, &modes);
            let Some(figure) = found.figure else {
                // An undamped mode of 40 rad/s grows by Euler's method with every step that was tried.
                assert!(scheme == Scheme::Euler && found.remedy.starts_with("none by the step"));
                continue;
            };
            assert!(growth(scheme, &modes, figure.reference) <= GROWTH);
            assert!(scheme.period_error(&first_axial(1.0), figure.reference) <= PERIOD);
            assert!(found.remedy.contains("with which an error of"), "{found:?}");
        }
    }

    #[test]
    fn the_limit_of_rk2_is_that_of_its_damping() {
        // Of weak damping |R| = 1 where (w h)^3 = 8 zeta, of strong one at 2 on the real axis.
        let weak = [mode(10.0, 1e-4)];
        let limit = Scheme::Second.longest_step(&weak[0]).unwrap();
        assert!(
            (10.0 * limit / 8e-4_f64.cbrt() - 1.0).abs() < 5e-3,
            "{limit}"
        );
        let found = by_rk2(&[mode(1.0, 10.0)], 0.4);
        let tried = found.stable.unwrap();
        assert!(
            !found.holds() && tried <= 2.0 / (10.0 + 99f64.sqrt()),
            "{found:?}"
        );
        assert!(by_rk2(&weak, 0.5 * limit).holds());
    }
}
