//! Alternate equilibria: the mirrored shape of a line that bends, and line without tension.

use std::f64::consts::PI;

use super::{EndCondition, Scene};
use crate::numerics::V3;
use crate::solve::State;

impl Scene {
    /// The shape mirrored at the chord between prescribed ends, and the node farthest from the chord; none if an end is free, the
    /// line is straight, or bending cannot carry half the weight there: a half wave of height a and length L carries
    /// `EI a (pi/L)⁴` a metre.
    #[must_use]
    pub fn mirrored(&self, state: &State) -> Option<(State, usize)> {
        if self
            .line
            .ends
            .iter()
            .any(|end| matches!(end, EndCondition::Free))
        {
            return None;
        }
        let last = state.x.len() - 1;
        let from = state.x[0];
        let chord = state.x[last] - from;
        let along = chord.try_normalize(1e-9 * self.line.arc[last])?;
        let aside = |x: &V3| {
            let d = x - from;
            d - along * along.dot(&d)
        };
        let offs = state.x.iter().map(|x| aside(x).norm());
        let (node, off) = offs
            .enumerate()
            .fold((0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
        if off < 1e-3 * self.line.arc[last] {
            return None;
        }
        let stiffest = self.line.segments.iter().map(|s| s.ei).fold(0.0, f64::max);
        let carried = stiffest * off * (PI / self.line.arc[last]).powi(4);
        if carried < 0.5 * self.line.weight.iter().sum::<f64>().abs() / self.line.arc[last] {
            return None;
        }
        let side = aside(&state.x[node]) / off;
        let mut other = state.clone();
        for x in &mut other.x {
            let d = side.dot(&(*x - from));
            *x -= side * (2.0 * d);
        }
        Some((other, node))
    }

    /// Length of line without tension on a bed without friction \[m\]: its shape is indeterminate.
    #[must_use]
    pub fn untensioned_on_bed(&self, state: &State) -> f64 {
        let Some(bed) = self.seabed().filter(|bed| bed.friction.is_none()) else {
            return 0.0;
        };
        self.untensioned(state, |i| {
            bed.height(&state.x[i]).max(bed.height(&state.x[i + 1])) <= 0.0
        })
    }

    /// Length of line without tension afloat on the surface \[m\]: its shape is indeterminate.
    #[must_use]
    pub fn untensioned_afloat(&self, state: &State) -> f64 {
        let Some(water) = self.line.water.as_ref().filter(|water| water.crossed) else {
            return 0.0;
        };
        self.untensioned(state, |i| {
            let [one, other] = [i, i + 1].map(|node| state.x[node].z.abs());
            one.max(other) <= 2.0 * water.radius[i]
        })
    }

    /// Length of those of these segments that have no tension \[m\].
    fn untensioned(&self, state: &State, among: impl Fn(usize) -> bool) -> f64 {
        let lengths = self.line.segments.iter().enumerate();
        lengths
            .filter(|(i, _)| among(*i) && self.is_slack(*i, state))
            .map(|(_, s)| s.axial.length)
            .sum()
    }

    /// Whether segment i has no tension.
    pub(super) fn is_slack(&self, i: usize, state: &State) -> bool {
        let tension = self.line.tension_now(i, &self.line.chord(i, state), state);
        tension.value <= 1e-6 * self.line.force_scale
    }
}
