//! Settings as the solver will use them, also those the case leaves open.

use super::Settings;
use crate::case::{Case, Method};
use crate::scene::{End, Scene};
use crate::solve::System;

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
        None => (automatic_step(case, scene, limit.map(|l| l.0)), true),
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
    }
}

/// The word for a method, as in case files.
#[must_use]
pub fn method_name(method: Method) -> &'static str {
    match method {
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

/// A share of the stability limit for explicit methods. For implicit ones a share of the shortest period that
/// the scene forces: of prescribed motion, or of the payload bouncing on its line,
/// `2 pi sqrt(m / k)` with k the line's axial stiffness.
fn automatic_step(case: &Case, scene: &Scene, limit: Option<f64>) -> f64 {
    if let Some(limit) = limit {
        return limit * EXPLICIT_SHARE;
    }
    let compliance: f64 = scene
        .segments
        .iter()
        .map(|s| s.axial.length / s.axial.ea)
        .sum();
    let mass = scene.mass.iter().sum::<f64>()
        + scene.bodies.iter().map(|b| b.body.added.max()).sum::<f64>();
    let mut period = std::f64::consts::TAU * (mass * compliance).sqrt();
    for end in &scene.ends {
        if let End::Held(motion) = end
            && motion.omega > 0.0
        {
            period = period.min(std::f64::consts::TAU / motion.omega);
        }
    }
    (period / STEPS_A_PERIOD).min(case.output.interval_s)
}

/// Name of the section that a segment belongs to.
fn section_of(case: &Case, scene: &Scene, segment: usize) -> String {
    let index = scene
        .joints
        .iter()
        .take_while(|j| j.node <= segment)
        .count();
    index
        .checked_sub(1)
        .and_then(|i| case.line.get(i))
        .map_or_else(String::new, |s| s.name.clone())
}
