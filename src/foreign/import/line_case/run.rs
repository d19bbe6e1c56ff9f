//! Waves, the run in time and its output.

use super::copied::{copy, copy_keys};
use super::end_clumps;
use super::places::is_on_vessel;
use super::source::LineSource;
use super::surface;
use crate::import::to_case::case_text::{CaseText, numbers, text};

/// Writes the environment; above water that it does not say to be crossed all counts as under it, as of a line.
pub(super) fn environment(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    copy(system, source, "environment");
    let surface = ["environment", "water_surface"];
    let wet = source.case.environment.water_density_kg_per_m3 > 0.0;
    if source.node(&surface).is_some() || !wet || !surface::rises_above_water(source) {
        return;
    }
    if source.node(&["environment"]).is_none() {
        system.table("[environment]", None);
    }
    system.assumed("water_surface", "\"ignored\"", "as of a line");
}

/// Writes the waves; their gauge is where a case has it.
pub(super) fn waves(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let Some(node) = source.node(&["waves"]) else {
        return;
    };
    system.table("[[waves]]", Some(&node.span));
    copy_keys(system, source, node, &[]);
    let waves = source.case.waves.as_ref();
    if waves.is_some_and(|waves| waves.gauge_m.is_none()) {
        gauge(system, source);
    }
}

/// Writes where the height of the waves is recorded: over an end of the line, which of a system is no point where it is on a vessel.
fn gauge(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let given = source.node(&["waves", "gauge_over"]).is_some();
    let both = &source.case.ends;
    let over = [&both.b, &both.a].into_iter();
    let over = over.filter(|end| end.position_m.is_some()).find(|_| !given);
    let Some(end) = over else { return };
    let is_point = end.kind.is_held() && !is_on_vessel(source, end);
    match is_point {
        true => system.assumed("gauge_over", &text(&end.name), "an end of the line"),
        false => {
            let place = end.position_m.unwrap_or_default();
            system.assumed("gauge_m", &numbers(&place[..2]), "over an end of the line");
        }
    }
}

/// Writes how the system is computed, what is recorded of a run in time, and the natural modes that are asked for.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let solver = source.node(&["solver"]);
    system.table("[solver]", solver.map(|node| &node.span));
    if let Some(node) = solver {
        copy_keys(system, source, node, &[]);
    }
    if source.is_in_time() && source.node(&["solver", "duration_s"]).is_none() {
        let duration = format!("{:?}", source.case.solver.duration_s);
        system.assumed("duration_s", &duration, "as a case leaves it out");
    }
    output(system, source);
    copy(system, source, "modes");
}

/// Writes what is recorded; forces on held ends, which a line leaves out only where its case says so.
fn output(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let output = source.node(&["output"]);
    system.table("[output]", output.map(|node| &node.span));
    if let Some(node) = output {
        copy_keys(system, source, node, &[]);
    }
    let is_given = |key| source.node(&["output", key]).is_some();
    if !is_given("uplift") && !source.case.checks.is_empty() {
        system.assumed("uplift", "true", "checks may be of it");
    }
    // The weight of a clump that hangs on a held end is no part of the force of the line.
    let hangs = end_clumps::left_out(source).next().is_some();
    if !is_given("forces") && !hangs {
        system.assumed("forces", "true", "as of a line");
    }
}
