//! A system at rest as one JSON object, for scripts; keys end in their units.

use serde_json::{Value, json};

use super::tables::hold_of;
use crate::verdict::RunVerdict;
use seacable_numerics::V3;
use seacable_studies::study::seas::SeaQuestion;
use seacable_systems::system::SolvedSystem;
use seacable_systems::system::ageing::SettledAge;
use seacable_systems::system::analysis::analyses::Analyses;
use seacable_systems::system::bounds::Contact;
use seacable_systems::system::loads;
use seacable_systems::system::network::Held;
use seacable_systems::system::pose::Pose;
use seacable_systems::system::stability::Stability;
use seacable_systems::system::warnings::warnings;

fn three(v: &V3) -> Value {
    json!([v.x, v.y, v.z])
}

/// The system at rest.
#[must_use]
pub fn object(solved: &SolvedSystem, analyses: &Analyses) -> Value {
    let rest = &solved.rest;
    json!({
        "kind": "system",
        "lines_are": if solved.is_discretised() { "discretised" } else { "closed forms" },
        "title": solved.file.about.title,
        "version": env!("CARGO_PKG_VERSION"),
        "stability": stability(&solved.stability),
        "other_equilibria": analyses.others.iter().map(|(other, how)| json!({
            "stability": stability(how),
            "greatest_tension_n": other.balance.tension,
            "bodies": (0..solved.network.bodies.len()).map(|k| json!({
                "name": solved.network.bodies[k].name,
                "pose": pose(&other.placement.bodies[k]),
            })).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "ageing": solved.age.as_ref().map(ageing),
        "goals": analyses.goals.iter().map(|(goal, sought)| json!({
            "vary": goal.vary,
            "result": goal.result,
            "wanted": goal.value,
            "value": sought.as_ref().ok().map(|sought| sought.value),
            "comes_to": sought.as_ref().ok().map(|sought| sought.result),
            "refused": sought.as_ref().err(),
        })).collect::<Vec<_>>(),
        "motion": null,
        "residual_n": rest.residual,
        "steps": rest.steps,
        "evaluations": rest.evaluations,
        "lines": (0..solved.network.lines.len()).map(|k| line(solved, k)).collect::<Vec<_>>(),
        "points": (0..solved.network.points.len()).map(|k| point(solved, k)).collect::<Vec<_>>(),
        "bodies": (0..solved.network.bodies.len()).map(|k| body(solved, k)).collect::<Vec<_>>(),
        "warnings": warnings(solved),
        "checks": checks(solved),
    })
}

/// The verdict of the checks on the equilibrium; nothing where the file has none, or is computed in time.
fn checks(solved: &SolvedSystem) -> Option<Value> {
    let at_rest = solved.file.as_run().is_none();
    let question = SeaQuestion::of_system(solved).ok().filter(|_| at_rest)?;
    RunVerdict::of_equilibrium(&question, solved).map(|verdict| verdict.to_json())
}

/// What the lines gained and lost, at most.
fn ageing(age: &SettledAge) -> Value {
    json!({
        "years": age.years,
        "growth_m": age.growth_m,
        "loss_of_diameter_m": age.loss_m,
        "rounds": age.rounds,
        "moved_m": age.moved_m,
    })
}

fn stability(stability: &Stability) -> Value {
    match stability {
        Stability::Stable => json!({"is": "stable"}),
        Stability::Neutral(along) => json!({"is": "neutral", "along": along}),
        Stability::Unstable(along) => json!({"is": "unstable", "along": along}),
    }
}

/// A line: forces of the line on its ends; end A is its `from`.
fn line(solved: &SolvedSystem, index: usize) -> Value {
    let network = &solved.network;
    let (line, at_rest) = (&network.lines[index], &solved.rest.balance.lines[index]);
    let [a, b] = at_rest.tensions();
    json!({
        "name": line.name,
        "from": network.points[line.from].name,
        "to": network.points[line.to].name,
        "length_m": line.length(),
        "tension_a_n": a,
        "tension_b_n": b,
        "force_a_n": three(&at_rest.force_a),
        "force_b_n": three(&at_rest.force_b),
        "on_bed_m": at_rest.on_bed(),
        "share_of_breaking_load": loads::share_of_breaking_load(network, &solved.rest, index),
        "error_n": solved.errors.lines[index].map(|own| own + solved.rest.residual),
    })
}

fn point(solved: &SolvedSystem, index: usize) -> Value {
    let point = &solved.network.points[index];
    let held = match &point.held {
        Held::At(_) => "fixed",
        Held::On(..) => "body",
        Held::Free(_) if solved.is_afloat(index) => "afloat",
        Held::Free(_) => match solved.rest.contact(index) {
            Contact::None | Contact::Pin => "free",
            Contact::Bed => "on bed",
            Contact::Surface => "afloat",
        },
    };
    json!({
        "name": point.name,
        "held": held,
        "position_m": three(&solved.rest.placement.points[index]),
        "error_m": solved.errors.points[index],
    })
}

fn pose(pose: &Pose) -> Value {
    let [roll, pitch, yaw] = pose.angles().map(f64::to_degrees);
    json!({
        "position_m": three(&pose.origin),
        "roll_deg": roll,
        "pitch_deg": pitch,
        "yaw_deg": yaw,
    })
}

fn body(solved: &SolvedSystem, index: usize) -> Value {
    let body = &solved.network.bodies[index];
    let (force, moment) = loads::on_body(&solved.network, &solved.rest, index);
    let matrix = &solved.stiffness[index];
    let rows: Vec<Vec<f64>> = (0..6)
        .map(|i| (0..6).map(|j| matrix[(i, j)]).collect())
        .collect();
    json!({
        "name": body.name,
        "held": hold_of(body),
        "pose": pose(&solved.rest.placement.bodies[index]),
        "pin_force_n": loads::of_pin(&solved.network, &solved.rest, index).as_ref().map(three),
        "lines_force_n": three(&force),
        "lines_moment_n_m": three(&moment),
        "stiffness": rows,
        "error_m": solved.errors.bodies[index].map(|[place, _]| place),
        "error_deg": solved.errors.bodies[index].map(|[_, turn]| turn.to_degrees()),
    })
}
