//! The linearised equations of a line: one band.

use super::newton::Iterated;
use super::{Factors, Kinematics, NewtonError, Residual, State};
use crate::numerics::{BlockBand, V3};

/// Residuals of the nodes, and then their displacements; and the tangent.
#[derive(Debug, Clone)]
pub struct BandedEquations {
    pub(super) residual: Vec<V3>,
    tangent: BlockBand,
}

impl BandedEquations {
    /// Of this number of nodes.
    #[must_use]
    pub fn new(nodes: usize) -> Self {
        Self {
            residual: vec![V3::zeros(); nodes],
            tangent: BlockBand::new(nodes),
        }
    }

    /// Why the tangent cannot be factored: it is singular, or a force is not finite.
    fn singular_or_not_finite<S: Residual>(
        &mut self,
        system: &S,
        t: f64,
        state: &State,
        node: usize,
    ) -> NewtonError {
        system.residual(t, state, &mut self.residual);
        let bad = system
            .free()
            .find(|&i| !self.residual[i].iter().all(|c| c.is_finite()));
        bad.map_or(NewtonError::Singular { node }, |node| {
            NewtonError::NotFinite { node }
        })
    }
}

impl<S: Residual> Iterated for S {
    type Work = BandedEquations;

    fn equations(&self, state: &State) -> BandedEquations {
        BandedEquations::new(state.x.len())
    }

    fn displace(
        &self,
        work: &mut BandedEquations,
        t: f64,
        state: &State,
        c: Factors,
    ) -> Result<(usize, f64), NewtonError> {
        if self.is_pentadiagonal() && !work.tangent.is_wide() {
            work.tangent.widen();
        }
        self.linearise(t, state, c, &mut work.residual, &mut work.tangent);
        let free = Kinematics::free(self);
        work.tangent
            .solve(free.clone(), &mut work.residual)
            .map_err(|e| work.singular_or_not_finite(self, t, state, e.node))?;
        let mut worst = (free.start, 0.0);
        for i in free.clone() {
            let moved = work.residual[i].amax();
            if !moved.is_finite() {
                return Err(NewtonError::NotFinite { node: i });
            }
            if moved > worst.1 {
                worst = (i, moved);
            }
        }
        // Prescribed nodes do not move.
        work.residual[..free.start].fill(V3::zeros());
        work.residual[free.end..].fill(V3::zeros());
        Ok(worst)
    }

    fn apply(&self, work: &BandedEquations, state: &mut State, c: Factors, share: f64) {
        if !state.extrapolated_tension.is_empty() {
            self.extrapolate_tensions(&work.residual, state);
        }
        for i in Kinematics::free(self) {
            let d = work.residual[i] * share;
            state.x[i] -= d;
            state.v[i] -= d * c.damping;
            state.a[i] -= d * c.mass;
        }
    }

    fn norm_on_force(&self, work: &BandedEquations, state: &State) -> f64 {
        self.force_norm_displacement(&work.residual, state)
    }

    /// A bound says that all was linear so far: nothing of a tension that sets in.
    fn is_misjudged(&self, work: &BandedEquations, state: &State, by_bound: bool) -> bool {
        by_bound && self.passes_kink(&work.residual, state)
    }
}
