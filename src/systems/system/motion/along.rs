//! Fatigue along the lines of a system in motion.

use super::broken_names;
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::checks::along::{AlongPlan, CountedLine};
use crate::checks::resolved::{Check, resolved};
use crate::fatigue::spot::SpotCounter;
use crate::run::along::{AlongCount, FatigueSpot};
use crate::system::SolvedSystem;
use crate::system::section_materials::diameter;

/// What is counted along the lines of a system, each by its number.
#[derive(Debug, Clone, Default)]
pub struct LinesAlong {
    lines: Vec<(usize, AlongCount, Vec<f64>)>,
}

impl LinesAlong {
    /// Of the checks of a system, and what they cannot count, in words. Lines that may break or are paid out are not counted along: their
    /// nodes change on the way.
    #[must_use]
    pub fn of(solved: &SolvedSystem, system: &MovingSystem) -> (Self, Vec<String>) {
        let file = &solved.file;
        // A set or a curve that cannot be read is refused where checks are resolved for a verdict.
        let checks = resolved(&file.checks, &file.files).unwrap_or_default();
        if !checks.iter().any(Check::is_along) {
            return (Self::default(), Vec::new());
        }
        let (mut lines, mut missing) = (Vec::new(), Vec::new());
        for (number, scene) in system.scenes.iter().enumerate() {
            let line = counted_line(solved, system, number);
            let plan = AlongPlan::of(&checks, &line);
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
            let arc = scene.line.arc[..scene.line_nodes()].to_vec();
            let count = AlongCount::new(plan, arc.len(), file.statistics.from_s);
            lines.push((number, count, arc));
        }
        (Self { lines }, missing)
    }

    /// Takes in an accepted step.
    pub fn step(&mut self, system: &MovingSystem, time: f64, state: &SystemState) {
        for (number, count, _) in &mut self.lines {
            let scene = system.scene(*number, state);
            count.step(scene, time, &state.lines[*number]);
        }
    }

    /// Number of the places counted.
    #[must_use]
    pub fn counters(&self) -> usize {
        self.lines
            .iter()
            .map(|(_, count, _)| count.counters().len())
            .sum()
    }

    /// What is counted so far, line by line.
    #[must_use]
    pub fn state(&self) -> Vec<SpotCounter> {
        let each = self.lines.iter();
        each.flat_map(|(_, count, _)| count.counters().iter().cloned())
            .collect()
    }

    /// Continues from what was counted so far, which is of as many places.
    pub fn restore(&mut self, stored: &[SpotCounter]) {
        let mut left = stored;
        for (_, count, _) in &mut self.lines {
            let (own, rest) = left.split_at(count.counters().len());
            count.restore(own);
            left = rest;
        }
    }

    /// The damage at every place, and what could not be counted, in words.
    #[must_use]
    pub fn finish(self) -> (Vec<FatigueSpot>, Vec<String>) {
        let (mut found, mut missing) = (Vec::new(), Vec::new());
        for (_, count, arc) in self.lines {
            let (spots, why) = count.finish(&arc);
            found.extend(spots);
            missing.extend(why);
        }
        missing.dedup();
        (found, missing)
    }
}

fn counted_line(solved: &SolvedSystem, system: &MovingSystem, number: usize) -> CountedLine {
    let (line, scene) = (&system.network.lines[number], &system.scenes[number]);
    let stem = line.name.split('@').next().unwrap_or(&line.name);
    let sections = 0..line.break_loads.len();
    CountedLine {
        names: vec![line.name.clone(); line.break_loads.len()],
        diameters: sections
            .map(|section| diameter(&solved.file, stem, section))
            .collect(),
        strengths: line.break_loads.clone(),
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
