//! Rods clamped at odds with the way they go: clamps turned a part at a time.
//!
//! The moment of a segment that meets its clamp at an angle θ goes with sin θ, so that past a right angle it falls
//! again and nothing is left to turn the rod back: Newton from a straight line ends in a fold there, which is none of
//! the rod's equilibria. With the clamps turned the way the line goes it has one nearby, and from there it follows them,
//! every step from the equilibrium before; where a turn makes it snap to another shape, it creeps there.

use super::equilibrium::{Equilibrium, EquilibriumSearch};
use crate::solve::{Newton, State, StaticSearch};

/// Shares of the turn a step: the first and longest, one from which the line may creep, and the shortest.
const LONGEST: f64 = 0.125;
const SHORT: f64 = 0.02;
const SHORTEST: f64 = 1e-3;

impl EquilibriumSearch {
    /// Moves `state` to an equilibrium through those with the clamps on their way; leaves it where there is none.
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
        let (mut share, mut step, mut steps) = (0.0, 0.0, 0);
        loop {
            let next: f64 = f64::min(share + step, 1.0);
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
                    share = next;
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
