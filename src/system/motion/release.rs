//! Ends of lines that are let go.

use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::scene::EndCondition;

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

/// All of a system, the earliest first.
#[must_use]
pub fn releases(system: &MovingSystem) -> Vec<Release> {
    let lines = system.network.lines.iter().enumerate();
    let mut all: Vec<Release> = lines
        .flat_map(|(line, given)| {
            let ends = given.releases.into_iter().enumerate();
            ends.filter_map(move |(end, time)| time.map(|time| Release { time, line, end }))
        })
        .collect();
    all.sort_by(|one, other| one.time.total_cmp(&other.time));
    all
}

impl MovingSystem {
    /// Lets an end of a line go: it moves on from where it is, by itself.
    pub fn let_go(&mut self, release: Release, state: &mut SystemState) {
        let Release { line, end, .. } = release;
        let Some(joint) = self.joints.let_go[line][end] else {
            return;
        };
        let from = state.attached[line][end];
        let joints = &mut state.joints;
        joints.x[joint] = joints.x[from];
        joints.v[joint] = joints.v[from];
        joints.a[joint] = joints.a[from];
        state.attached[line][end] = joint;
        self.scenes[line].line.ends[end] = EndCondition::Free;
    }
}
