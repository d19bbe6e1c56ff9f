//! Waves, the run in time and its output.

use super::copied::{copy, copy_keys, value_of};
use super::ends;
use super::published;
use super::source::LineSource;
use crate::import::to_case::case_text::{CaseText, numbers};

/// Writes the environment; above water that it does not say to be crossed all counts as under it, as of a line.
pub(super) fn environment(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    copy(system, source, "environment");
    let surface = ["environment", "water_surface"];
    let wet = source.case.environment.water_density_kg_per_m3 > 0.0;
    if source.node(&surface).is_some() || !wet || !ends::rises_above_water(source) {
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
        let ends = &source.case.ends;
        let place = ends.b.position_m.or(ends.a.position_m).unwrap_or_default();
        system.assumed("gauge_m", &numbers(&place[..2]), "over an end of the line");
    }
}

/// Writes how the system is computed, and what is recorded of a run in time.
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
    let forces = published::reads_forces(source);
    let output = source.node(&["output"]);
    let is_checked = !source.case.checks.is_empty();
    if output.is_none() && !forces && !is_checked {
        return;
    }
    system.table("[output]", output.map(|node| &node.span));
    for key in ["interval_s", "shape_interval_s", "response_from_s"] {
        if let Some(node) = source.node(&["output", key]) {
            system.given(key, &value_of(source, node), &node.span, "");
        }
    }
    if is_checked {
        system.assumed("uplift", "true", "checks may be of it");
    }
    if forces {
        system.assumed("forces", "true", "a published curve is of one");
    }
}
