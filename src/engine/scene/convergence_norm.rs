//! Newton's convergence norm on force: a displacement along a segment acts through its stiffness, transverse to it hardly.

use super::LumpedLine;
use crate::numerics::V3;
use crate::solve::State;

impl LumpedLine {
    /// The greatest force \[N\] in a segment by the displacements d, to first order and as if all were taut: by stretching, and
    /// by rotating a tension of [`LumpedLine::force_scale`].
    pub(super) fn force_in_segments(&self, d: &[V3], state: &State) -> f64 {
        let mut most = 0.0_f64;
        for (i, segment) in self.segments.iter().enumerate() {
            let inverse = segment.axial.inverse_length();
            let opened = d[i + 1] - d[i];
            let along = opened.dot(&(state.x[i + 1] - state.x[i])) * inverse;
            let stretched = segment.axial.ea * along;
            let turned = self.force_scale * self.force_scale * opened.norm_squared();
            most = most.max((stretched * stretched).max(turned) * inverse * inverse);
        }
        most.sqrt()
    }
}
