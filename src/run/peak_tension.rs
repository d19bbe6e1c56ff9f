//! Greatest tensions over every step, for sections whose material has a breaking load.
//!
//! The tension of a node is computed where a segment beside it was longest: once a peak, not at every step on the way up.

use crate::case::{Case, Section};
use crate::scene::Scene;
use crate::solve::State;

/// Detects the peaks; without a breaking load it watches no segment.
pub(super) struct PeakTension {
    watched: Vec<WatchedSegment>,
    /// The state of the step before, where any segment is watched.
    before: Option<State>,
}

/// A segment of a section with a breaking load.
struct WatchedSegment {
    segment: usize,
    /// Square of its greatest length so far \[m²\].
    longest: f64,
    /// Square of its length in the step before \[m²\].
    latest: f64,
}

impl WatchedSegment {
    fn squared_length(&self, state: &State) -> f64 {
        (state.x[self.segment + 1] - state.x[self.segment]).norm_squared()
    }

    /// Whether it was never longer than in the step before.
    fn at_its_longest(&self) -> bool {
        self.latest == self.longest && self.longest > 0.0
    }
}

impl PeakTension {
    /// For the segments of the sections whose material states a breaking load.
    pub(super) fn of(case: &Case, scene: &Scene) -> Self {
        let limited = |section: &Section| {
            let material = case.materials.get(&section.material);
            material.is_some_and(|m| m.break_load_n.is_some())
        };
        let reaches = scene.labels.joints.windows(2).zip(&case.line);
        let watched = reaches
            .filter(|(_, section)| limited(section))
            .flat_map(|(joints, _)| joints[0].node..joints[1].node)
            .map(|segment| WatchedSegment {
                segment,
                longest: 0.0,
                latest: 0.0,
            });
        Self {
            watched: watched.collect(),
            before: None,
        }
    }

    /// Squares of the greatest lengths of the segments so far \[m²\].
    pub(super) fn greatest_lengths(&self) -> Vec<f64> {
        self.watched.iter().map(|w| w.longest).collect()
    }

    /// Continues with the greatest lengths so far and the last state before.
    pub(super) fn restore(&mut self, longest: &[f64], state: &State) {
        for (watched, longest) in self.watched.iter_mut().zip(longest) {
            watched.longest = *longest;
            watched.latest = watched.squared_length(state);
        }
        self.remember(state);
    }

    /// Takes a step in: what has passed its peak raises the greatest tensions of its nodes \[N\].
    pub(super) fn update(&mut self, scene: &Scene, state: &State, most: &mut [f64]) {
        for watched in &mut self.watched {
            let length = watched.squared_length(state);
            if length > watched.longest {
                watched.longest = length;
            } else if watched.at_its_longest() {
                settle(watched.segment, scene, self.before.as_ref(), most);
            }
            watched.latest = length;
        }
        self.remember(state);
    }

    /// The same for all that are at their longest, before the march ends or the line changes.
    pub(super) fn settle(&self, scene: &Scene, most: &mut [f64]) {
        for watched in self.watched.iter().filter(|w| w.at_its_longest()) {
            settle(watched.segment, scene, self.before.as_ref(), most);
        }
    }

    fn remember(&mut self, state: &State) {
        match &mut self.before {
            _ if self.watched.is_empty() => {}
            Some(before) => before.copy_from(state),
            None => self.before = Some(state.clone()),
        }
    }
}

/// Raises the greatest tensions \[N\] of both nodes of a segment to those of a state.
fn settle(segment: usize, scene: &Scene, state: Option<&State>, most: &mut [f64]) {
    let Some(state) = state else { return };
    for node in [segment, segment + 1] {
        most[node] = most[node].max(scene.tension_at(node, state));
    }
}
