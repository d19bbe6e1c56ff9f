//! Static equilibrium of the discretised line by Newton on the nodes, with the exact tangent.
//!
//! Newton starts from the initial guess with the mixed iteration ([`Residual::extrapolate_tensions`]), then without, which suits
//! a line that is slack somewhere. If neither converges: pseudo-transient continuation with one iteration a step, backward
//! Euler from rest (`M (x - x_k) / h² = f(x)`), which dissipates all kinetic energy, with h grown while steps are short, and
//! Newton to finish; then continuation in the angle of the clamps (`statics/continuation.rs`); last, dynamic relaxation with
//! every pseudo-time step converged. A state is accepted on the displacement and then on the residual force, and never with a
//! fold in a line that bends, where forces balance but no equilibrium is stable. On a rough bed that does not hold it there, the line slides
//! (`statics/sliding.rs`).

use std::sync::atomic::{AtomicBool, Ordering};

use crate::numerics::{BlockBand, V3};
use crate::solve::{Factors, Newton, NewtonError, Residual, State, StaticSearch};

/// Settings of the search.
#[derive(Debug, Clone, Copy)]
pub struct EquilibriumSearch<'a> {
    /// Largest residual force accepted, relative to the force scale of the line \[-\].
    pub force_tolerance: f64,
    /// Greatest Newton iterations a try.
    pub max_iterations: usize,
    /// Greatest steps of pseudo-time.
    pub max_steps: usize,
    /// Set by another thread, it ends the search.
    pub stop: Option<&'a AtomicBool>,
}

impl Default for EquilibriumSearch<'_> {
    fn default() -> Self {
        Self {
            force_tolerance: 1e-8,
            max_iterations: 40,
            max_steps: 400,
            stop: None,
        }
    }
}

/// An equilibrium, and the work of finding it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equilibrium {
    /// Newton iterations, all tries counted.
    pub iterations: u64,
    /// Steps of pseudo-time; 0 if Newton alone converged.
    pub steps: u64,
    /// Largest residual force left \[N\].
    pub residual: f64,
    /// Whether it is that of a bed without friction.
    pub friction_released: bool,
}

/// No equilibrium was found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("no equilibrium found in {iterations} iterations: {}", self.reason())]
pub struct EquilibriumError {
    /// Newton iterations, all tries counted.
    pub iterations: u64,
    /// Largest residual force left \[N\].
    pub residual: f64,
    /// Where.
    pub node: usize,
    /// The first node at which the best shape bends by a right angle or more, if it does.
    pub kinked_node: Option<usize>,
    /// The last failure of Newton.
    pub why: Option<NewtonError>,
    /// Whether it was stopped before its end.
    pub stopped: bool,
    /// Where the best shape slides on the bed, if it does.
    pub sliding: Option<SlidingNode>,
}

/// A node that friction on the bed does not hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SlidingNode {
    /// The node.
    pub node: usize,
    /// Whether it is slack on a slope steeper than friction bears.
    pub down_slope: bool,
}

impl EquilibriumError {
    fn reason(&self) -> String {
        if self.stopped {
            return "it was stopped".to_owned();
        }
        match self.sliding {
            Some(SlidingNode {
                node,
                down_slope: true,
            }) => {
                return format!(
                    "at node {node} the line slides down the slope, which friction on the bed does not bear"
                );
            }
            Some(SlidingNode { node, .. }) => {
                return format!(
                    "at node {node} the line slides on the bed, and no place was found where friction and tension hold it"
                );
            }
            None => {}
        }
        if let Some(node) = self.kinked_node {
            return format!(
                "the line bends by a right angle or more at node {node}, which segments of this length cannot carry; \
                 use shorter segments there, or turn the clamp the way the line goes, or set the bending stiffness to 0"
            );
        }
        format!(
            "a force of {:.3e} N is left at node {}; a line that is slack, or that nothing holds, has none, \
             and one whose drag falls while its speed rises (a drag crisis) may have none",
            self.residual, self.node
        )
    }
}

const STATICS: Factors = Factors {
    mass: 0.0,
    damping: 0.0,
    stiffness: 1.0,
};

/// Greatest number of iterations of a trial after a step of pseudo-time.
const FINISHING: usize = 12;

/// Greatest number of times that stiffnesses which ropes share are solved for: each time leaves less than a fifth of the error.
const SHARING: usize = 40;

/// Relative change of such a stiffness \[-\] at which it is solved for.
const SHARED: f64 = 1e-11;

impl EquilibriumSearch<'_> {
    /// Moves `state` to an equilibrium at time t, at rest.
    ///
    /// # Errors
    /// [`EquilibriumError`]; `state` is then the best shape reached.
    pub fn run<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        state: &mut State,
    ) -> Result<Equilibrium, EquilibriumError> {
        let start = state.clone();
        let found = self.find(system, t, state);
        let sliding = found.is_ok().then(|| sliding_node(system, state)).flatten();
        let error = match (found, sliding) {
            (Ok(found), None) => return Ok(found),
            (Err(error), _) if error.stopped => return Err(error),
            (Ok(found), sliding) => EquilibriumError {
                iterations: found.iterations,
                residual: found.residual,
                node: 0,
                kinked_node: None,
                why: None,
                stopped: false,
                sliding,
            },
            (Err(error), _) => error,
        };
        if sliding.is_some_and(|sliding| sliding.down_slope) {
            return Err(error);
        }
        let mut slid = if sliding.is_some() {
            state.clone()
        } else {
            start.clone()
        };
        if let Some(found) = self.slide(system, t, &mut slid, error.iterations) {
            *state = slid;
            return Ok(found);
        }
        let mut newton = self.newton(system);
        match self.friction_released(system, t, &mut newton, start) {
            Some((there, found)) if !system.pulls_on_bed(&there) => {
                *state = there;
                Ok(found)
            }
            _ => Err(error),
        }
    }

    /// The search with friction that resists the pull on a line laid, and no other.
    fn find<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        state: &mut State,
    ) -> Result<Equilibrium, EquilibriumError> {
        let mut newton = self.newton(system);
        let size = length(state);
        newton.max_displacement = 0.3 * size;
        set_at_rest(state);
        let mut trial = state.clone();
        system.initialise_tensions(&mut trial);
        if let Ok(found) = self.finish(system, t, &mut newton, &mut trial, 0) {
            return Ok(self.stable_branch(system, t, &mut newton, (state, trial), found));
        }
        trial.copy_from(state);
        newton.max_iterations = FINISHING;
        if let Ok(found) = self.finish(system, t, &mut newton, &mut trial, 0)
            && nearby(state, &trial)
        {
            *state = trial;
            return Ok(found);
        }
        trial.copy_from(state);
        if system.flows_over_rough_bed()
            && let Some(found) = self.slide(system, t, &mut trial, newton.iterations)
        {
            *state = trial;
            return Ok(found);
        }
        trial.copy_from(state);
        if let Some(found) = self.pseudo_transient(system, t, &mut newton, &mut trial, size) {
            *state = trial;
            return Ok(found);
        }
        if let Some(found) = self.continue_clamps(system, t, &mut newton, state) {
            return Ok(found);
        }
        newton.max_displacement = f64::INFINITY;
        self.dynamic_relaxation(system, t, &mut newton, state)
    }

    /// Storage for [`EquilibriumSearch::refine`].
    #[must_use]
    pub fn newton<S: StaticSearch>(&self, system: &S) -> Newton {
        let tolerance = system.position_tolerance(0.1 * self.force_tolerance);
        Newton::new(system.nodes(), tolerance, self.max_iterations)
    }

    /// Moves `state` to the equilibrium at time t that Newton alone finds from it: for a state near an equilibrium, as after a
    /// small motion of the ends. Allocates nothing.
    ///
    /// # Errors
    /// Why Newton failed; none if it left a force or a fold. `state` then holds the last iterate.
    pub fn refine<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        newton: &mut Newton,
        state: &mut State,
    ) -> Result<Equilibrium, Option<NewtonError>> {
        set_at_rest(state);
        self.finish(system, t, newton, state, 0)
    }

    /// The equilibrium on a bed without friction, in which friction then holds the line: for slack line on a rough bed that has
    /// none with the initial friction.
    fn friction_released<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        newton: &mut Newton,
        mut start: State,
    ) -> Option<(State, Equilibrium)> {
        let smooth = system.without_friction()?;
        start.memory.grips.clear();
        let there = self.run(&smooth, t, &mut start).ok()?;
        system.reset_friction(&mut start);
        let found = self.accept(system, t, newton, &start, there.steps)?;
        let iterations = found.iterations + there.iterations;
        Some((
            start,
            Equilibrium {
                iterations,
                friction_released: true,
                ..found
            },
        ))
    }

    /// The equilibrium that Newton found; for an unstable one of a clamped rod, the one by continuation in the angle of the
    /// clamps if that is stable.
    fn stable_branch<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        newton: &mut Newton,
        (state, there): (&mut State, State),
        found: Equilibrium,
    ) -> Equilibrium {
        let stays = |state: &State| instabilities(system, t, state) == Some(0);
        if system.with_clamps(state, 1.0).is_some() && !stays(&there) {
            let mut other = state.clone();
            if let Some(turned) = self.continue_clamps(system, t, newton, &mut other)
                && stays(&other)
            {
                *state = other;
                return turned;
            }
        }
        *state = there;
        found
    }

    /// Whether it is to end.
    pub(super) fn is_stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }

    /// Newton to the end, accepted on the residual.
    pub(super) fn finish<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        newton: &mut Newton,
        state: &mut State,
        steps: u64,
    ) -> Result<Equilibrium, Option<NewtonError>> {
        for _ in 0..SHARING {
            if self.is_stopped() {
                return Err(None);
            }
            newton.reset_rate();
            let solved = newton.solve(system, t, state, STATICS);
            state.extrapolated_tension.clear();
            solved.map_err(Some)?;
            if system.share_stiffness(state) <= SHARED {
                break;
            }
        }
        self.accept(system, t, newton, state, steps).ok_or(None)
    }

    /// The state itself, if its residual is small enough.
    pub(super) fn accept<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        newton: &mut Newton,
        state: &State,
        steps: u64,
    ) -> Option<Equilibrium> {
        if system.kinked_node(state).is_some() {
            return None;
        }
        let (_, residual) = newton.largest_residual(system, t, state);
        let enough = (self.force_tolerance * system.force_scale()).max(system.rounding_force());
        (residual <= enough).then_some(Equilibrium {
            iterations: newton.iterations,
            steps,
            residual,
            friction_released: false,
        })
    }

    /// Pseudo-transient continuation: one mixed iteration a step of pseudo-time, until Newton converges. Mixed iterations hold slack segments at
    /// a least tension: where they come to rest so, no more of them lead to an equilibrium.
    pub(super) fn pseudo_transient<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        newton: &mut Newton,
        state: &mut State,
        size: f64,
    ) -> Option<Equilibrium> {
        system.initialise_tensions(state);
        let mut trial = state.clone();
        let at_rest = system.position_tolerance(self.force_tolerance);
        let mut h = 0.1 * size.sqrt();
        let mut calm = 0;
        for step in 1..=self.max_steps as u64 {
            if self.is_stopped() {
                return None;
            }
            let moved = newton.iterate(system, t, state, pseudo_time(h)).ok()?.1;
            set_at_rest(state);
            h *= (0.03 * size / moved).clamp(0.3, 1.7);
            calm = if moved < 0.03 * size { calm + 1 } else { 0 };
            if calm >= 4 {
                calm = 0;
                trial.copy_from(state);
                if let Ok(found) = self.finish(system, t, newton, &mut trial, step) {
                    state.copy_from(&trial);
                    return Some(found);
                }
                trial.copy_from(state);
                trial.extrapolated_tension.clear();
                if let Some(found) = self.accept(system, t, newton, &trial, step) {
                    state.copy_from(&trial);
                    return Some(found);
                }
                if let Ok(found) = self.finish(system, t, newton, &mut trial, step)
                    && nearby(state, &trial)
                {
                    state.copy_from(&trial);
                    return Some(found);
                }
                if moved <= at_rest && !state.extrapolated_tension.is_empty() {
                    return None;
                }
            }
        }
        None
    }

    /// Dynamic relaxation: converged steps of pseudo-time, until Newton converges or the residual vanishes.
    fn dynamic_relaxation<S: StaticSearch>(
        &self,
        system: &S,
        t: f64,
        newton: &mut Newton,
        state: &mut State,
    ) -> Result<Equilibrium, EquilibriumError> {
        let mut trial = state.clone();
        let mut h = 0.1;
        let mut why = None;
        for step in 1..=self.max_steps as u64 {
            if self.is_stopped() {
                break;
            }
            trial.copy_from(state);
            newton.reset_rate();
            match newton.solve(system, t, &mut trial, pseudo_time(h)) {
                Ok(_)
                    if system.kinked_node(&trial).is_none()
                        || system.kinked_node(state).is_some() =>
                {
                    set_at_rest(&mut trial);
                    state.copy_from(&trial);
                    h *= 2.5;
                    match self.finish(system, t, newton, &mut trial, step) {
                        Ok(found) if nearby(state, &trial) => {
                            state.copy_from(&trial);
                            return Ok(found);
                        }
                        Ok(_) => {}
                        Err(error) => why = error,
                    }
                    // Slack line on the bed has no unique shape for Newton, but is at rest.
                    if let Some(found) = self.accept(system, t, newton, state, step) {
                        return Ok(found);
                    }
                }
                // A step that folds the line is too long, as one that does not converge.
                failed => {
                    why = failed.err();
                    h *= 0.25;
                    if h < 1e-9 {
                        break;
                    }
                }
            }
        }
        let (node, residual) = newton.largest_residual(system, t, state);
        Err(EquilibriumError {
            iterations: newton.iterations,
            residual,
            node,
            kinked_node: system.kinked_node(state),
            why,
            stopped: self.is_stopped(),
            sliding: None,
        })
    }
}

pub(super) fn pseudo_time(h: f64) -> Factors {
    Factors {
        mass: 1.0 / (h * h),
        damping: 0.0,
        stiffness: 1.0,
    }
}

/// The number of unstable directions of an equilibrium: 0 if it is stable. Counts the negative pivots of the tangent, in still
/// water as many as its negative eigenvalues (Sylvester). None if the tangent is singular, as with slack line.
pub fn instabilities<S: Residual>(system: &S, t: f64, state: &State) -> Option<usize> {
    let mut residual = vec![V3::zeros(); system.nodes()];
    let mut tangent = BlockBand::new(system.nodes());
    if system.is_pentadiagonal() {
        tangent.widen();
    }
    system.linearise(t, state, STATICS, &mut residual, &mut tangent);
    tangent.solve(system.free(), &mut residual).ok()?;
    Some(tangent.negative_pivots(system.free()))
}

/// A node that friction on the bed does not hold.
fn sliding_node<S: StaticSearch>(system: &S, state: &State) -> Option<SlidingNode> {
    system.sliding_node(state).map(|node| SlidingNode {
        node,
        down_slope: system.slides_slack(state),
    })
}

/// Whether two states are near: Newton may jump from a moving line to an unstable shape far away.
pub(super) fn nearby(from: &State, to: &State) -> bool {
    let size = from
        .x
        .iter()
        .map(|p| (p - from.x[0]).norm())
        .fold(1.0, f64::max);
    from.x
        .iter()
        .zip(&to.x)
        .all(|(a, b)| (a - b).norm() < 0.2 * size)
}

/// Stretched length of the line.
pub(super) fn length(state: &State) -> f64 {
    state.x.windows(2).map(|x| (x[1] - x[0]).norm()).sum()
}

pub(super) fn set_at_rest(state: &mut State) {
    for (v, a) in state.v.iter_mut().zip(&mut state.a) {
        *v = nalgebra::zero();
        *a = nalgebra::zero();
    }
}
