//! Continuation in the angle of the clamps, for rods clamped at a large angle to the line.
//!
//! The moment of a segment at an angle θ to its clamp varies as sin θ and falls past a right angle: Newton from a straight line
//! then ends in a fold, which is no equilibrium of the rod. With the clamps along the line there is one nearby, and the
//! continuation follows it step by step to the given angles; across a snap to another branch, by pseudo-transient steps.

use super::equilibrium::{Equilibrium, EquilibriumSearch};
use crate::solve::{Newton, State, StaticSearch};

/// Fractions of the angle a step: the first and longest, one from which pseudo-transient steps may help, and the shortest.
const LONGEST: f64 = 0.125;
const SHORT: f64 = 0.02;
const SHORTEST: f64 = 1e-3;

impl EquilibriumSearch<'_> {
    /// Moves `state` to an equilibrium by continuation in the angle of the clamps; leaves it if there is none.
    pub(super) fn continue_clamps<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        newton: &mut Newton,
        state: &mut State,
    ) -> Option<Equilibrium> {
        let start = state.clone();
        let mut here = start.clone();
        let size = here.x.windows(2).map(|x| (x[1] - x[0]).norm()).sum();
        let (mut fraction, mut step, mut steps) = (0.0, 0.0, 0);
        loop {
            let next: f64 = f64::min(fraction + step, 1.0);
            let turned = system.with_clamps(&start, next)?;
            let mut trial = here.clone();
            steps += 1;
            let mut found = self.finish(&turned, t, newton, &mut trial, steps).ok();
            if found.is_none() && step <= SHORT {
                trial.copy_from(&here);
                found = self.pseudo_transient(&turned, t, newton, &mut trial, size);
            }
            match found {
                Some(found) if next >= 1.0 => {
                    state.copy_from(&trial);
                    return Some(Equilibrium { steps, ..found });
                }
                Some(_) => {
                    here.copy_from(&trial);
                    fraction = next;
                    step = if step > 0.0 {
                        f64::min(2.0 * step, LONGEST)
                    } else {
                        LONGEST
                    };
                }
                None if step > SHORTEST => step *= 0.5,
                None => return None,
            }
        }
    }
}
