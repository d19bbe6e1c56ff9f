//! A line of several sections in the local frame, and its equilibrium with given grounded runs.

use super::convex_newton::BayUnknowns;
use super::elements::{Bay, ElementRange, LineElements};
use super::solution::LocalFrame;
use super::span::length;
use super::suspended;

/// A line of several sections in the local frame.
pub(super) struct CompositeLine {
    pub chain: LineElements,
    pub x: f64,
    pub z: f64,
    /// Depth of the bed below A.
    pub bed: Option<f64>,
    pub frame: LocalFrame,
}

/// The equilibrium with given grounded runs.
pub(super) struct ContactPattern {
    pub grounded: Vec<ElementRange>,
    pub bays: Vec<Bay>,
    pub state: BayUnknowns,
    pub slack: bool,
    pub evaluations: u32,
}

impl CompositeLine {
    pub(super) fn last(&self) -> usize {
        self.chain.elements.len() - 1
    }

    /// The maximal run of sinking elements around one, if that one sinks.
    pub(super) fn run(&self, at: usize) -> ElementRange {
        let sinks = |i: &usize| self.chain.elements[*i].total() >= 0.0;
        let first = (0..=at).rev().take_while(sinks).last().unwrap_or(at);
        let last = (at..=self.last()).take_while(sinks).last().unwrap_or(at);
        (first, last)
    }

    /// A start: a uniform line of the same weight and compliance.
    pub(super) fn guess(&self) -> (f64, f64) {
        let chain = &self.chain;
        let all = chain.absolute_weight();
        let w = (chain.weight.abs().max(0.05 * all) / chain.length).max(1e-200);
        let ea = chain.length / chain.compliance.max(1e-200);
        let up = if chain.weight < 0.0 { -1.0 } else { 1.0 };
        let free = suspended::solve(self.x, up * self.z, chain.length, w, ea, None);
        let (h, v) = free.map_or((all, 0.0), |f| (f.h, up * f.v_mean));
        (h.max(1e-3 * all).max(1e-200), v - 0.5 * chain.weight)
    }

    /// Largest tension anywhere.
    pub(super) fn top(&self, bays: &[Bay], state: &BayUnknowns) -> f64 {
        let v = bays
            .iter()
            .zip(&state.offsets)
            .flat_map(|(bay, offset)| self.chain.parts(bay, *offset))
            .map(|part| {
                let span = self.chain.part_span(&part);
                part.va
                    .abs()
                    .max((part.va + span.weight * span.length).abs())
            })
            .fold(0.0, f64::max);
        length(state.h, v)
    }

    /// Unstretched length on the bed.
    pub(super) fn grounded_length(&self, pattern: &ContactPattern) -> f64 {
        let off: f64 = pattern
            .bays
            .iter()
            .zip(&pattern.state.offsets)
            .flat_map(|(bay, offset)| self.chain.parts(bay, *offset))
            .map(|part| part.length)
            .sum();
        if pattern.grounded.is_empty() {
            return 0.0;
        }
        let lying = self.chain.length - off;
        if lying > 1e-12 * self.chain.length {
            lying
        } else {
            0.0
        }
    }
}
