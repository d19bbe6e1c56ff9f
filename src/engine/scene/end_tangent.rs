//! The tangent of a line at rest whose rows at both ends are those of the end forces.

use super::Scene;
use crate::numerics::{BlockBand, V3};
use crate::solve::{Factors, Residual, State};

const STATICS: Factors = Factors {
    mass: 0.0,
    damping: 0.0,
    stiffness: 1.0,
};

impl Scene {
    /// Sets the residual of all nodes at rest \[N\] and its derivative by their positions \[N/m\]. In the rows of the first and last
    /// node the derivative is that of the negative [end force](Scene::end_force), also where an end is held on the bed, which
    /// then bears the line there.
    pub fn linearise_with_ends(
        &self,
        t: f64,
        state: &State,
        r: &mut [V3],
        tangent: &mut BlockBand,
    ) {
        self.linearise(t, state, STATICS, r, tangent);
        if let Some(bed) = &self.elements.bed {
            for node in [0, self.line.segments.len()] {
                bed.linearise_end_force(self.at(t, state), node, &r[node], tangent);
            }
        }
    }
}
