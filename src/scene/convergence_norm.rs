//! How much of a displacement the forces of a line feel: along a segment all of its stiffness, across it next to none.

use super::Scene;
use crate::numerics::V3;
use crate::solve::State;

impl Scene {
    /// The displacement \[m\] that, along the stiffest part of the line, would change a force as much as these do at
    /// most, to first order, with inertia, drag and dampers left out. A segment counts as if it were taut.
    pub(super) fn force_norm_displacement(&self, d: &[V3], state: &State) -> f64 {
        let force = self.squared_force_in_segments(d, state).sqrt();
        let felt = force.max(self.force_in_bending(d)) / self.stiffest();
        felt.max(self.displacement_on_bed(d, state))
    }

    /// By stretching segments, and by turning their tension, taken as the force typical of the line; squared \[N²\].
    fn squared_force_in_segments(&self, d: &[V3], state: &State) -> f64 {
        let mut most = 0.0_f64;
        for (i, segment) in self.segments.iter().enumerate() {
            let inverse = 1.0 / segment.axial.length;
            let opened = d[i + 1] - d[i];
            let along = opened.dot(&(state.x[i + 1] - state.x[i])) * inverse;
            let stretched = segment.axial.ea * along;
            let turned = self.force_scale * self.force_scale * opened.norm_squared();
            most = most.max((stretched * stretched).max(turned) * inverse * inverse);
        }
        most
    }

    /// The greatest displacement of a node that lies on the bed \[m\]. There every one counts in full: what friction bears adds
    /// up along the line, and is remembered.
    fn displacement_on_bed(&self, d: &[V3], state: &State) -> f64 {
        let Some(bed) = &self.bed else { return 0.0 };
        let lies = |i: &usize| self.push(bed, *i, state).force > 0.0;
        let nodes = (0..self.footprint.len()).filter(lies);
        nodes.map(|i| d[i].amax()).fold(0.0, f64::max)
    }

    /// By bending the line at its nodes and clamps, the forces of the moments \[N\].
    fn force_in_bending(&self, d: &[V3]) -> f64 {
        let Some(flexure) = &self.flexure else {
            return 0.0;
        };
        let of_turn = |k: f64, turn: V3, length: f64| 2.0 * k * turn.amax() / (length * length);
        let mut most = 0.0_f64;
        for i in 1..self.segments.len() {
            let turn = d[i - 1] + d[i + 1] - d[i] * 2.0;
            most = most.max(of_turn(flexure.joints[i], turn, flexure.spans[i]));
        }
        let last = self.segments.len() - 1;
        for (clamp, i) in flexure.clamps.iter().zip([0, last]) {
            if let Some((_, k)) = clamp {
                let length = self.segments[i].axial.length;
                most = most.max(of_turn(*k, d[i + 1] - d[i], length));
            }
        }
        most
    }
}
