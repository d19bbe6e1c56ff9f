//! What was computed, how, and at what cost.

use crate::{
    document::Report,
    number::{duration, si},
};
use seacable_runs::run::{RunInfo, RunState, Settings};

/// Title, source and state of a run of a file with this title, source and notes.
pub(crate) fn head(page: &mut Report, info: &RunInfo, [title, source, notes]: [&str; 3]) {
    page.title(title);
    page.pairs(&[
        ("Run", info.id.clone()),
        ("Case", info.case_file.clone()),
        ("Set on top", info.overrides.join(", ")),
        ("Source", source.to_owned()),
        ("Started", info.started.clone()),
        ("State", state(info)),
        ("Version", format!("seacable {}", info.version)),
    ]);
    if !notes.trim().is_empty() {
        page.gap();
        page.paragraph(notes);
    }
}

fn state(info: &RunInfo) -> String {
    match info.state {
        RunState::Done => "complete".to_owned(),
        RunState::Partial => "PARTIAL: it has not come to its end, see the warnings".to_owned(),
        RunState::Cancelled => "CANCELLED before its end; what it had is shown".to_owned(),
        RunState::Failed => {
            let why = info.failure.as_deref().unwrap_or("no reason was given");
            format!("FAILED: {why}")
        }
    }
}

/// What the reader must know before trusting the numbers.
pub(crate) fn warnings(page: &mut Report, warnings: &[String]) {
    if !warnings.is_empty() {
        page.heading("Warnings");
        for warning in warnings {
            page.item("* ", warning);
        }
    }
}

/// The solver's settings, those it chose itself marked so.
pub(crate) fn settings(page: &mut Report, info: &RunInfo) {
    let s = &info.settings;
    let limit = s.stability_limit_s.map(|limit| {
        let at = s
            .stability_limit_at
            .as_ref()
            .map_or_else(String::new, |at| format!(", set by {at}"));
        format!("{}{at}", si(limit, "s"))
    });
    page.heading("Solver");
    page.pairs(&[
        ("Method", method(&s.method)),
        ("Chosen", s.method_reason.clone().unwrap_or_default()),
        ("Accuracy", s.accuracy.clone().unwrap_or_default()),
        ("Simulated time", si(s.duration_s, "s")),
        ("Time step", step(s)),
        (
            "Error allowed in a step",
            s.step_tolerance.map(|t| si(t, "-")).unwrap_or_default(),
        ),
        ("Stability limit", limit.unwrap_or_default()),
        (
            "Spectral radius",
            s.rho_inf.map(|r| r.to_string()).unwrap_or_default(),
        ),
        (
            "Numerical damping",
            numerical_damping(s).unwrap_or_default(),
        ),
        (
            "Newton tolerance",
            s.position_tolerance_m
                .map(|t| si(t, "m"))
                .unwrap_or_default(),
        ),
        ("Nodes", s.nodes.to_string()),
        ("Output interval", si(s.output_interval_s, "s")),
        ("Error estimate", s.error_method.clone()),
    ]);
}

fn step(settings: &Settings) -> String {
    if settings.time_step_s <= 0.0 {
        return String::new();
    }
    let step = si(settings.time_step_s, "s");
    let varies = settings.step_tolerance.is_some();
    match (varies, settings.time_step_automatic) {
        (true, _) => format!("at most {step}, varied by the solver"),
        (false, true) => format!("{step} (chosen by the solver)"),
        (false, false) => step,
    }
}

/// The numerical damping of the method, where it is known.
#[must_use]
pub fn numerical_damping(settings: &Settings) -> Option<String> {
    let ratio = settings.numerical_damping?;
    let period = si(settings.numerical_damping_period_s?, "s");
    Some(format!("{ratio:.1e} of critical at a period of {period}"))
}

fn method(word: &str) -> String {
    let long = match word {
        "static" => "static equilibrium (Newton on the nodes)",
        "quasi" => "quasi-static march (equilibrium at each instant, no inertia)",
        "rk4" => "explicit Runge-Kutta of order 4",
        "alpha" => "implicit generalized-alpha",
        other => other,
    };
    long.to_owned()
}

/// Work counts and cost.
pub(crate) fn work(page: &mut Report, info: &RunInfo) {
    let (work, cost) = (info.work, info.cost);
    page.heading("Work and cost");
    page.pairs(&[
        (
            "Steps",
            format!(
                "{} accepted, {} rejected and halved",
                work.steps, work.rejections
            ),
        ),
        ("Newton iterations", work.iterations.to_string()),
        ("Force evaluations", work.evaluations.to_string()),
        ("CPU time", duration(cost.cpu_s)),
        ("Wall time", duration(cost.wall_s)),
        (
            "Error estimation",
            format!("{} of wall time", duration(cost.companions_wall_s)),
        ),
    ]);
}
