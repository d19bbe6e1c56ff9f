//! Whether the file's starting state is in equilibrium, and where the program's ways to rest stop short of it.

use std::f64::consts::TAU;

use super::Audit;
use super::finding::{AuditFinding, Topic};
use super::lumped::relaxation::{Ended, RelaxationSettings, dynamic, stationary};
use super::lumped::{LumpedModel, equilibrium};
use crate::import::mooring::{Mooring, ProgramSetting};
use crate::number::{percent, si};
use crate::numerics::V3;

/// Tensions off by this share are a finding.
const OFF: f64 = 0.01;
/// Tensions below this share of the greatest, or of the weight of a line, are held against that.
const SMALL: f64 = 0.02;
/// Part of dtIC after which tensions are sampled: as documented, and as `MoorDyn` in C++ does, which divides twice.
const SAMPLES: [f64; 2] = [0.1, 0.01];

/// A way to rest, and what it leaves.
#[derive(Debug, Clone, PartialEq)]
pub struct StartAudit {
    /// Which.
    pub by: &'static str,
    /// When and why it ended \[s\]; nothing for the file as it stands.
    pub ended: Option<(f64, Ended)>,
    /// The line whose tension is worst.
    pub line: String,
    /// Its end.
    pub end: &'static str,
    /// Tension there \[N\].
    pub tension: f64,
    /// The same at rest \[N\].
    pub at_rest: f64,
    /// By how much it is off, by the tension at rest.
    pub off: f64,
    /// Greatest distance of a node from its place at rest \[m\].
    pub displaced: f64,
    /// Whether the program would do so by these settings.
    pub counts: bool,
}

/// Number of a setting, or the program's default.
#[must_use]
pub fn number(mooring: &Mooring, name: &str, default: f64) -> f64 {
    let setting = mooring.setting(name).and_then(ProgramSetting::number);
    setting.filter(|value| value.is_finite()).unwrap_or(default)
}

/// Shortest natural period of a segment \[s\], by which `MoorDyn` chooses its step.
#[must_use]
pub fn shortest_period(model: &LumpedModel) -> f64 {
    let periods = model
        .lines
        .iter()
        .map(|line| TAU * line.segment * (line.mass / line.elasticity.initial()).sqrt());
    periods.fold(f64::INFINITY, f64::min)
}

/// The time step of the file \[s\], or the default of `MoorDyn` by its Courant number.
#[must_use]
pub fn step_of(mooring: &Mooring, model: &LumpedModel) -> f64 {
    let by_default = number(mooring, "cfl", 0.5) * shortest_period(model);
    number(mooring, "dtm", by_default)
}

/// Follows the program to rest; `rest` are the lumped masses in equilibrium.
pub fn find(mooring: &Mooring, model: &LumpedModel, rest: &[V3], audit: &mut Audit) {
    if model.creeps {
        audit
            .not_judged
            .push("The start: ropes that creep while they come to rest.".to_owned());
        return;
    }
    // With bodies held where the file has them, the nodes rest elsewhere.
    let held;
    let rest = match model.holds_bodies {
        false => rest,
        true => match equilibrium::at_rest(model, &model.start) {
            Ok(found) => {
                held = found;
                &held
            }
            Err(why) => {
                let what =
                    format!("The start: with bodies held it was not brought to rest ({why}).");
                audit.not_judged.push(what);
                return;
            }
        },
    };
    let step = step_of(mooring, model);
    let settings = RelaxationSettings {
        step,
        interval: number(mooring, "dtic", 1.0),
        longest: number(mooring, "tmaxic", 120.0),
        drag_scale: number(mooring, "cdscaleic", 5.0),
        threshold: number(mooring, "threshic", 0.001),
        courant: step / shortest_period(model),
    };
    let is_legacy = number(mooring, "icgendynamic", 0.0) != 0.0;
    let is_off = settings.longest <= 0.0 || settings.interval <= 0.0 || step <= 0.0;
    audit.starts.push(StartAudit {
        counts: is_off,
        ..judged(mooring, model, rest, &model.start, "the file", None)
    });
    if !is_off {
        relaxed(mooring, (model, rest), &settings, is_legacy, audit);
    }
    findings(mooring, model, &settings, audit);
}

/// The names of the run of OpenFAST, and of that of MoorDyn in C++.
const OPENFAST: &str = "OpenFAST dynamic";
const LEGACY: &str = "C++ dynamic";

/// Parts of a step with which a way to rest that diverges is tried again.
const SHORTER: [f64; 3] = [0.5, 0.25, 0.125];

/// What mends a way to rest that grows without bound: a step with which it was tried and does not.
fn mended(model: &LumpedModel, settings: &RelaxationSettings, by: &str) -> String {
    let bounded = |share: &f64| {
        let tried = RelaxationSettings {
            step: share * settings.step,
            courant: share * settings.courant,
            longest: settings.longest.min(settings.interval),
            ..*settings
        };
        let found = match by {
            OPENFAST => dynamic(model, &tried, SAMPLES[0] * settings.interval),
            LEGACY => dynamic(model, &tried, SAMPLES[1] * settings.interval),
            _ => stationary(model, &tried),
        };
        found.ended != Ended::Diverged
    };
    let within = settings.longest.min(settings.interval);
    match SHORTER.iter().copied().find(bounded) {
        Some(share) => format!(
            "choose dtM {} or less, with which it stays bounded within {}",
            si(share * settings.step, "s"),
            si(within, "s")
        ),
        None => "none by the step: with an eighth of it, it grows all the same".to_owned(),
    }
}

/// The program's ways to rest, as far as they are not too long.
fn relaxed(
    mooring: &Mooring,
    (model, rest): (&LumpedModel, &[V3]),
    settings: &RelaxationSettings,
    is_legacy: bool,
    audit: &mut Audit,
) {
    let run = |which: usize| match which {
        0 => stationary(model, settings),
        which => dynamic(model, settings, SAMPLES[which - 1] * settings.interval),
    };
    let ((first, second), third) = rayon::join(|| rayon::join(|| run(0), || run(1)), || run(2));
    // MoorDyn in OpenFAST has RK2 alone: a file of another scheme is for the one in C++.
    let scheme = mooring.setting("tscheme");
    let is_for_other = scheme.is_some_and(|setting| !setting.value.eq_ignore_ascii_case("rk2"));
    if is_for_other {
        audit.not_judged.push(
            "OpenFAST dynamic, which is shown by RK2: the file is of a scheme that MoorDyn in OpenFAST does not have."
                .to_owned(),
        );
    }
    let names = [
        ("C++ stationary", !is_legacy),
        (OPENFAST, mooring.setting("dtm").is_some() && !is_for_other),
        (LEGACY, is_legacy),
    ];
    for ((by, counts), found) in names.into_iter().zip([first, second, third]) {
        if found.ended == Ended::TooLong {
            let what = format!(
                "{by}: after {} in steps of {} it has not ended, and is not repeated further.",
                si(found.time, "s"),
                si(settings.step, "s")
            );
            audit.not_judged.push(what);
            continue;
        }
        let ended = Some((found.time, found.ended));
        audit.starts.push(StartAudit {
            counts,
            ..judged(mooring, model, rest, &found.x, by, ended)
        });
    }
}

/// Places of the nodes against those at rest.
fn judged(
    mooring: &Mooring,
    model: &LumpedModel,
    rest: &[V3],
    x: &[V3],
    by: &'static str,
    ended: Option<(f64, Ended)>,
) -> StartAudit {
    let ends = |line: usize| [(0, "A"), (model.lines[line].nodes.len() - 2, "B")];
    let lines = || (0..model.lines.len()).flat_map(|k| ends(k).map(|end| (k, end)));
    let at_rest = |(line, (segment, _)): (usize, (usize, _))| model.tension(line, segment, rest);
    let greatest = lines().map(at_rest).fold(0.0, f64::max);
    let weights = model.lines.iter().map(|line| model.weight(line).abs());
    let least = SMALL * weights.fold(greatest, f64::max);
    let mut worst = StartAudit {
        by,
        ended,
        line: String::new(),
        end: "B",
        tension: 0.0,
        at_rest: 0.0,
        off: 0.0,
        displaced: 0.0,
        counts: false,
    };
    for (line, (segment, end)) in lines() {
        let (now, then) = (
            model.tension(line, segment, x),
            model.tension(line, segment, rest),
        );
        let off = (now - then) / then.max(least).max(f64::MIN_POSITIVE);
        if worst.line.is_empty() || off.is_nan() || off.abs() > worst.off.abs() {
            worst.line.clone_from(&mooring.lines[line].id);
            (worst.end, worst.tension, worst.at_rest, worst.off) = (end, now, then, off);
        }
    }
    let nodes = x
        .iter()
        .zip(rest)
        .zip(&model.free)
        .filter(|(_, free)| **free);
    let apart = nodes.map(|((x, rest), _)| (x - rest).norm());
    worst.displaced = apart.fold(0.0, f64::max);
    worst
}

/// One finding of all ways to rest that the settings lead to and that stop short.
fn findings(
    mooring: &Mooring,
    model: &LumpedModel,
    settings: &RelaxationSettings,
    audit: &mut Audit,
) {
    let is_short = |start: &&StartAudit| {
        let diverged = matches!(start.ended, Some((_, Ended::Diverged)));
        start.counts && (diverged || start.off.is_nan() || start.off.abs() > OFF)
    };
    let short: Vec<&StartAudit> = audit.starts.iter().filter(is_short).collect();
    let worst = short
        .iter()
        .max_by(|one, other| one.off.abs().total_cmp(&other.off.abs()));
    let Some(worst) = worst else { return };
    let words: Vec<String> = short.iter().map(|start| words(start)).collect();
    let remedy = match worst.ended {
        Some((_, Ended::Diverged)) => mended(model, settings, worst.by),
        None => {
            "give TmaxIC, or write the places at rest that `seacable run` gives for free points into the file".to_owned()
        }
        _ => {
            "write the places at rest that `seacable run` gives for free points into the file; lower threshIC and raise dtIC and TmaxIC".to_owned()
        }
    };
    let names = match settings.longest <= 0.0 {
        true => ["tmaxic"; 2],
        false => ["threshic", "tmaxic"],
    };
    let place = names.iter().find_map(|name| mooring.setting(name));
    let subject = place.map_or("threshIC", |setting| setting.written.as_str());
    let mut finding = AuditFinding::new(Topic::Start, subject, words.join("; "), remedy);
    finding = finding.figure(worst.tension, worst.at_rest, "N");
    finding.span = place.map(|setting| setting.span.clone());
    audit.findings.push(finding);
}

/// Where a way to rest stops.
fn words(start: &StartAudit) -> String {
    let stops = match start.ended {
        None => "without relaxation the run starts".to_owned(),
        Some((time, Ended::Converged)) => {
            format!("{} stops after {}", start.by, si(time, "s"))
        }
        Some((time, Ended::OutOfTime | Ended::TooLong)) => {
            format!("{} ends its time of {}", start.by, si(time, "s"))
        }
        Some((time, Ended::Diverged)) => {
            return format!("{} grows without bound within {}", start.by, si(time, "s"));
        }
    };
    format!(
        "{stops} with {} at end {} of line {}, {} off the {} of its equilibrium, a node up to {} from its place",
        si(start.tension, "N"),
        start.end,
        start.line,
        percent(start.off.abs()),
        si(start.at_rest, "N"),
        si(start.displaced, "m")
    )
}
