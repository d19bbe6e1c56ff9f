//! Whether the time step of a file is stable, and what error it leaves.

use std::f64::consts::PI;

use super::Audit;
use super::finding::{Finding, Topic};
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
    let growth = |mode: &FastestMode| scheme.amplification(mode, step).ln() / step;
    let fastest = modes
        .into_iter()
        .max_by(|one, other| growth(one).total_cmp(&growth(other)));
    let Some(mode) = fastest else { return };
    let growth = growth(&mode);
    let longest = scheme.longest_step(&mode);
    let axial = axial(mooring, model, scheme, step);
    let spans = [given, mooring.setting("cfl"), setting];
    let span = spans
        .into_iter()
        .flatten()
        .next()
        .map(|one| one.span.clone());
    let mut found = Vec::new();
    if growth > GROWTH {
        found.push(unstable(scheme, step, given.is_some(), (longest, &mode)));
    } else if let Some((line, period, error)) = &axial
        && *error > PERIOD
    {
        let what = format!(
            "steps of {} leave an error of {} in the first axial period of line {line}, {}",
            si(step, "s"),
            percent(*error),
            si(*period, "s")
        );
        let remedy = format!("choose dtM {} or less", si(0.25 * step, "s"));
        let finding = Finding::new(Topic::Step, "dtM", what, remedy);
        found.push(finding.figure(step, 0.25 * step, "s"));
    }
    for mut one in found {
        one.span.clone_from(&span);
        audit.findings.push(one);
    }
    audit.step = Some(StepAudit {
        scheme: scheme.name(),
        step,
        is_given: given.is_some(),
        longest,
        fastest: mode,
        growth,
        axial,
    });
}

fn unstable(
    scheme: Scheme,
    step: f64,
    is_given: bool,
    (longest, mode): (Option<f64>, &FastestMode),
) -> Finding {
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
    let (limit, remedy) = match longest {
        Some(longest) => (
            longest,
            format!("choose dtM {} or less", si(0.9 * longest, "s")),
        ),
        None => (
            0.3 / mode.frequency,
            format!(
                "give the lines internal damping (BA), or choose RK4 and dtM {} or less",
                si(2.5 / mode.frequency, "s")
            ),
        ),
    };
    Finding::new(Topic::Step, "dtM", what, remedy).figure(step, limit, "s")
}

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
    let undamped = FastestMode {
        frequency: 2.0 * PI / period,
        damping: 0.0,
    };
    Some((line, period, scheme.period_error(&undamped, step)))
}
