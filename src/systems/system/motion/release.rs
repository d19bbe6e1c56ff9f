//! Ends of lines that are let go.

use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::scene::EndCondition;
use crate::system::network::ReleaseCondition;

/// An end of a line that is let go at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Release {
    /// When \[s\].
    pub time: f64,
    /// Which line.
    pub line: usize,
    /// Which end: 0 for A, 1 for B.
    pub end: usize,
}

/// Those of a system that a time is given for, the earliest first.
#[must_use]
pub fn by_time(system: &MovingSystem) -> Vec<Release> {
    let at = |(line, end, time): (usize, usize, Option<f64>)| {
        time.map(|time| Release { time, line, end })
    };
    let mut all: Vec<Release> = ends(system, |given| given.time).filter_map(at).collect();
    all.sort_by(|one, other| one.time.total_cmp(&other.time));
    all
}

/// The first end whose tension has come to where it is let go, at this time \[s\].
#[must_use]
pub fn by_tension(system: &MovingSystem, state: &SystemState, time: f64) -> Option<Release> {
    let pulled = |(line, end, limit): (usize, usize, Option<f64>)| {
        let limit = limit?;
        let held = system.joints.released[line][end] != Some(state.attached[line][end]);
        let (scene, here) = (system.scene(line, state), &state.lines[line]);
        let tension = scene.tension_at(end * (here.x.len() - 1), here);
        (held && tension >= limit).then_some(Release { time, line, end })
    };
    ends(system, |given| given.tension).find_map(pulled)
}

/// The ends of all lines with something of when they are let go.
fn ends(
    system: &MovingSystem,
    of: fn(&ReleaseCondition) -> Option<f64>,
) -> impl Iterator<Item = (usize, usize, Option<f64>)> {
    let lines = system.network.lines.iter().enumerate();
    lines.flat_map(move |(line, given)| {
        let ends = given.releases.iter().enumerate();
        ends.map(move |(end, given)| (line, end, of(given)))
    })
}

impl MovingSystem {
    /// Whether an end was let go already.
    #[must_use]
    pub fn is_released(&self, release: Release, state: &SystemState) -> bool {
        let Release { line, end, .. } = release;
        self.joints.released[line][end] == Some(state.attached[line][end])
    }

    /// Frees the ends that were let go in an earlier run.
    pub fn free_released_ends(&mut self, state: &mut SystemState) {
        for line in 0..self.scenes.len() {
            for end in 0..2 {
                if self.joints.released[line][end] == Some(state.attached[line][end]) {
                    self.free_end(line, end, state);
                }
            }
        }
    }

    /// An end that nothing prescribes any more.
    fn free_end(&mut self, line: usize, end: usize, state: &mut SystemState) {
        self.scenes[line].line.ends[end] = EndCondition::Free;
        self.scenes[line].unclamp(end);
        let paid = self.paid.iter().position(|paid| paid.line == line);
        if let Some(scene) = paid.and_then(|number| state.paid.get_mut(number)) {
            scene.line.ends[end] = EndCondition::Free;
            scene.unclamp(end);
        }
    }

    /// Lets an end of a line go: it moves on from where it is, by itself.
    pub fn release(&mut self, release: Release, state: &mut SystemState) {
        let Release { line, end, .. } = release;
        let Some(joint) = self.joints.released[line][end] else {
            return;
        };
        let from = state.attached[line][end];
        if from == joint {
            return;
        }
        let joints = &mut state.joints;
        joints.x[joint] = joints.x[from];
        joints.v[joint] = joints.v[from];
        joints.a[joint] = joints.a[from];
        state.attached[line][end] = joint;
        self.free_end(line, end, state);
    }
}
