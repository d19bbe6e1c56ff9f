//! Line that slides over a rough bed until tension and friction hold it.
//!
//! Friction opposes the way of every node from where the line was laid ([`crate::physics::FrictionAnchor`]), up to its limit. A line that
//! was only pulled is found with friction that resists that pull and no other. Where a node then bears more than friction does, as in a
//! current across the line, it slides: friction counts in every direction, and the equilibrium is sought again.
//!
//! Newton's method by itself overshoots, since the force of a node that slides does not change along its way: pseudo-transient steps with
//! the secant of friction in the place of its derivative (Kačanov's method: iteratively reweighted least squares) bring it near, and
//! Newton with the exact derivative ends the search. What is found is a function of where the line was laid and of where its ends
//! are, of no steps in which the current grew.

use super::equilibrium::{
    Equilibrium, EquilibriumSearch, length, nearby, pseudo_time, set_at_rest,
};
use crate::solve::{Newton, State, StaticSearch};

/// Rounds of steps with the secant, each followed by a trial of Newton's method; steps in a round and iterations of a trial.
const ROUNDS: u64 = 40;
const STEPS: usize = 15;
const FINISHING: usize = 30;
/// Greatest displacement of a step, and the one at which pseudo-time steps stay as long as they are, by the length of the line.
const FARTHEST: f64 = 0.02;
const USUAL: f64 = 0.0015;
/// Shortest pseudo-time step \[s\], and the longest.
const SHORTEST: f64 = 1e-6;
const LONGEST: f64 = 1e9;

impl EquilibriumSearch<'_> {
    /// Moves `state` to the equilibrium that the line slides to, after so many iterations; none without friction, or if there is none.
    pub(crate) fn slide<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        state: &mut State,
        iterations: u64,
    ) -> Option<Equilibrium> {
        let secant = system.with_secant_friction()?;
        for grip in &mut state.memory.grips {
            grip.laid = false;
        }
        state.extrapolated_tension.clear();
        set_at_rest(state);
        let size = length(state);
        let mut newton = self.newton(system);
        newton.iterations = iterations;
        newton.max_iterations = FINISHING;
        let mut trial = state.clone();
        let mut h = 0.1 * size.sqrt();
        for round in 1..=ROUNDS {
            newton.max_displacement = FARTHEST * size;
            self.step_with_secant(&secant, t, (&mut newton, &mut *state), (&mut h, size))?;
            if let Some(found) = self.accept(system, t, &mut newton, state, round) {
                return Some(found);
            }
            trial.copy_from(state);
            newton.max_displacement = 0.3 * size;
            if let Ok(found) = self.finish(system, t, &mut newton, &mut trial, round)
                && nearby(state, &trial)
            {
                state.copy_from(&trial);
                return Some(found);
            }
        }
        None
    }

    /// Pseudo-transient steps of a system with the secant of friction; none if stopped or nothing holds the line.
    fn step_with_secant<S: StaticSearch>(
        &self,
        secant: &S,
        t: f64,
        (newton, state): (&mut Newton, &mut State),
        (h, size): (&mut f64, f64),
    ) -> Option<()> {
        for _ in 0..STEPS {
            if self.is_stopped() || *h < SHORTEST {
                return None;
            }
            match newton.iterate(secant, t, state, pseudo_time(*h)) {
                Ok((_, moved)) => {
                    *h *= (USUAL * size / moved).sqrt().clamp(0.5, 2.2);
                    *h = h.min(LONGEST);
                }
                Err(_) => *h *= 0.1,
            }
            set_at_rest(state);
        }
        Some(())
    }
}
