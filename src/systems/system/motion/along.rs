//! Fatigue along the lines of a system in motion.

use super::broken_names;
use super::moving_system::MovingSystem;
use crate::checks::along::{AlongPlan, CountedLine};
use crate::checks::resolved::{Check, resolved};
use crate::run::along::AlongCount;
use crate::run::lines_along::LinesAlong;
use crate::system::SolvedSystem;
use crate::system::section_materials::diameter;

/// What the checks of a system count along its lines, and what they cannot count, in words. Lines that may break or are paid out are not
/// counted along: their nodes change on the way.
#[must_use]
pub fn counted_along(solved: &SolvedSystem, system: &MovingSystem) -> (LinesAlong, Vec<String>) {
    let file = &solved.file;
    // A set or a curve that cannot be read is refused where checks are resolved for a verdict.
    let checks = resolved(&file.checks, &file.files).unwrap_or_default();
    if !checks.iter().any(Check::is_along) {
        return (LinesAlong::default(), Vec::new());
    }
    let (mut lines, mut missing) = (Vec::new(), Vec::new());
    for (number, scene) in system.scenes.iter().enumerate() {
        let line = counted_line(solved, system, number);
        let plan = AlongPlan::of_checks(&checks, &line);
        if plan.spots.is_empty() && plan.missing.is_empty() {
            continue;
        }
        if changes(system, number) {
            let name = &system.network.lines[number].name;
            missing.push(format!(
                "line {name} may break or is paid out: no damage is counted along it"
            ));
            continue;
        }
        let count = AlongCount::new(plan, scene.line_nodes(), file.statistics.from_s);
        lines.push((number, count));
    }
    (LinesAlong::new(lines), missing)
}

fn counted_line(solved: &SolvedSystem, system: &MovingSystem, number: usize) -> CountedLine {
    let (line, scene) = (&system.network.lines[number], &system.scenes[number]);
    let stem = line.name.split('@').next().unwrap_or(&line.name);
    let sections = 0..line.parts.len();
    CountedLine {
        names: vec![line.name.clone(); line.parts.len()],
        diameters: sections
            .map(|section| diameter(&solved.file, stem, section))
            .collect(),
        strengths: line.parts.iter().map(|part| part.break_load).collect(),
        bounds: scene.labels.joints.iter().map(|joint| joint.node).collect(),
        bends: scene.elements.flexure.is_some(),
    }
}

/// Whether the nodes of a line change on the way.
fn changes(system: &MovingSystem, number: usize) -> bool {
    let line = &system.network.lines[number];
    let points = &system.network.points;
    let breaks = [line.from, line.to]
        .iter()
        .any(|end| broken_names::is_between(&points[*end].name));
    breaks || system.paid.iter().any(|paid| paid.line == number)
}
