//! Newton's method for statics, the quasi-static march and every implicit time step.
//!
//! The unknown is a displacement `d`; position, velocity and acceleration follow it by the three [`Factors`] of the method. The
//! tangent is exact, also across slack and contact (semismooth Newton). There is no line search on the residual norm: on
//! snapping lines it added iterations.
//!
//! Convergence: the largest displacement of an iteration falls below the tolerance; or, since convergence is quadratic, the
//! extrapolated next one does (`|d1| = c |d0|²` with c measured on the iterations before, near there, and a safety factor), which saves
//! an assembly a step. Transverse to the line, where a displacement changes the forces little, a step with error control has a
//! larger tolerance than along it. An iteration that cycles, as between two sides of a kink, stops early: the march then
//! halves its step at less cost.

use super::convergence::{Convergence, ConvergenceRate};
use super::{Factors, Residual, State};
use crate::numerics::{BlockBand, V3};

/// Newton's method with its work arrays and the measured rate of convergence. Allocates in [`Newton::new`], and at the first
/// iteration of a pentadiagonal system.
#[derive(Debug, Clone)]
pub struct Newton {
    /// Largest displacement of a node at which an iteration counts as converged \[m\].
    pub tolerance: f64,
    /// The same transverse to the line, if larger: [`Newton::tolerance`] then holds for
    /// [`Residual::force_norm_displacement`] \[m\].
    pub transverse_tolerance: f64,
    /// Largest change of a node's velocity at which an iteration counts as converged \[m/s\]: for forces that depend steeply
    /// on velocity, the more so the shorter the step.
    pub velocity_tolerance: f64,
    /// Greatest number of iterations.
    pub max_iterations: usize,
    /// Greatest displacement of a node in an iteration \[m\]: all are scaled down together.
    pub max_displacement: f64,
    /// Number of iterations in a row that do not halve the least displacement so far, after which the iteration stops; unlimited
    /// by default.
    pub stagnation_limit: usize,
    /// Iterations so far, over all calls.
    pub iterations: u64,
    residual: Vec<V3>,
    tangent: BlockBand,
    /// Absent until two iterations were seen.
    rate: Option<ConvergenceRate>,
}

/// Why Newton's method failed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NewtonError {
    /// The iterations were used up, or cycled.
    #[error(
        "Newton did not converge in {iterations} iterations: node {node} still moves by {moved:.3e} m"
    )]
    NotConverged {
        /// Iterations made.
        iterations: usize,
        /// The node that moved most in the last one.
        node: usize,
        /// By how much \[m\].
        moved: f64,
    },
    /// The tangent cannot be solved.
    #[error("the tangent is singular at node {node}: nothing holds it")]
    Singular {
        /// The node.
        node: usize,
    },
    /// A force is not finite.
    #[error("a force is not finite at node {node}")]
    NotFinite {
        /// The node.
        node: usize,
    },
    /// The equations are solved far from where the line was.
    #[error(
        "node {node} would move by {moved:.3e} m in one step, three times as far as the line is long or more: \
         too little slows it along the line"
    )]
    Runaway {
        /// The node.
        node: usize,
        /// How far it would move \[m\].
        moved: f64,
    },
    /// An explicit step exceeds the stability limit of the decay at a node.
    #[error("the explicit step is too long for how fast drag slows node {node}")]
    Unstable {
        /// The node.
        node: usize,
    },
}

impl NewtonError {
    /// The node concerned.
    #[must_use]
    pub fn node(&self) -> usize {
        match *self {
            Self::NotConverged { node, .. }
            | Self::Singular { node }
            | Self::NotFinite { node }
            | Self::Runaway { node, .. }
            | Self::Unstable { node } => node,
        }
    }
}

impl Newton {
    /// For a system of `nodes` nodes; tolerance \[m\].
    #[must_use]
    pub fn new(nodes: usize, tolerance: f64, max_iterations: usize) -> Self {
        Self {
            tolerance,
            transverse_tolerance: tolerance,
            velocity_tolerance: f64::INFINITY,
            max_iterations,
            max_displacement: f64::INFINITY,
            stagnation_limit: usize::MAX,
            iterations: 0,
            residual: vec![V3::zeros(); nodes],
            tangent: BlockBand::new(nodes),
            rate: None,
        }
    }

    /// The measured rate of convergence, to be saved with a march.
    #[must_use]
    pub fn rate(&self) -> Option<ConvergenceRate> {
        self.rate
    }

    /// Restores the rate and the count of a saved march.
    pub fn restore(&mut self, rate: Option<ConvergenceRate>, iterations: u64) {
        self.rate = rate;
        self.iterations = iterations;
    }

    /// Resets the measured rate, as after a discontinuity of the state.
    pub fn reset_rate(&mut self) {
        self.rate = None;
    }

    /// Moves `state` to where its residual vanishes, velocities and accelerations following the
    /// positions by `c`. Returns the number of iterations.
    ///
    /// # Errors
    /// [`NewtonError`]; `state` then holds the last iterate.
    pub fn solve<S: Residual>(
        &mut self,
        system: &S,
        t: f64,
        state: &mut State,
        c: Factors,
    ) -> Result<usize, NewtonError> {
        // The factor of damping is 0 in statics.
        let tolerance = if c.damping > 0.0 {
            self.tolerance.min(self.velocity_tolerance / c.damping)
        } else {
            self.tolerance
        };
        // At rest nothing follows that would mend an iteration left out.
        let rate = self.rate.filter(|rate| !rate.is_bound || c.damping > 0.0);
        let mut convergence = Convergence::new(tolerance, rate);
        let (mut worst, mut made) = ((0, f64::INFINITY), 0);
        while made < self.max_iterations && convergence.idle() < self.stagnation_limit {
            made += 1;
            worst = self.iterate(system, t, state, c)?;
            let moved = self.convergence_norm(system, state, worst.1);
            let reached = convergence.is_reached(moved);
            self.rate = convergence.rate();
            // A bound says that all was linear so far: nothing of a tension that sets in.
            let by_bound = moved > tolerance && self.rate.is_some_and(|rate| rate.is_bound);
            if reached && !(by_bound && system.passes_kink(&self.residual, state)) {
                return Ok(made);
            }
        }
        self.reset_rate();
        let (node, moved) = worst;
        Err(NewtonError::NotConverged {
            iterations: made,
            node,
            moved,
        })
    }

    /// The displacement of the last iteration in the norm of convergence \[m\]; `moved` is its maximum norm.
    fn convergence_norm<S: Residual>(&self, system: &S, state: &State, moved: f64) -> f64 {
        // A force that depends steeply on velocity does so in every direction.
        if self.transverse_tolerance <= self.tolerance || self.velocity_tolerance.is_finite() {
            return moved;
        }
        let along = system.force_norm_displacement(&self.residual, state);
        along.max(moved * self.tolerance / self.transverse_tolerance)
    }

    /// One iteration; returns the node that moves most and by how much \[m\], before scaling to
    /// [`Newton::max_displacement`].
    ///
    /// # Errors
    /// [`NewtonError::Singular`] and [`NewtonError::NotFinite`].
    pub fn iterate<S: Residual>(
        &mut self,
        system: &S,
        t: f64,
        state: &mut State,
        c: Factors,
    ) -> Result<(usize, f64), NewtonError> {
        self.iterations += 1;
        if system.is_pentadiagonal() && !self.tangent.is_wide() {
            self.tangent.widen();
        }
        system.linearise(t, state, c, &mut self.residual, &mut self.tangent);
        let free = system.free();
        self.tangent
            .solve(free.clone(), &mut self.residual)
            .map_err(|e| self.singular_or_not_finite(system, t, state, e.node))?;
        let mut worst = (free.start, 0.0);
        for i in free.clone() {
            let moved = self.residual[i].amax();
            if !moved.is_finite() {
                return Err(NewtonError::NotFinite { node: i });
            }
            if moved > worst.1 {
                worst = (i, moved);
            }
        }
        // Prescribed nodes do not move.
        self.residual[..free.start].fill(V3::zeros());
        self.residual[free.end..].fill(V3::zeros());
        if !state.extrapolated_tension.is_empty() {
            system.extrapolate_tensions(&self.residual, state);
        }
        let share = if worst.1 > self.max_displacement {
            self.max_displacement / worst.1
        } else {
            1.0
        };
        for i in free {
            let d = self.residual[i] * share;
            state.x[i] -= d;
            state.v[i] -= d * c.damping;
            state.a[i] -= d * c.mass;
        }
        Ok(worst)
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

    /// The largest residual of a free node \[N\], and its node.
    pub fn largest_residual<S: Residual>(
        &mut self,
        system: &S,
        t: f64,
        state: &State,
    ) -> (usize, f64) {
        system.residual(t, state, &mut self.residual);
        let mut worst = (0, 0.0);
        for i in system.free() {
            let size = self.residual[i].norm();
            if size.is_nan() || size > worst.1 {
                worst = (i, size);
            }
        }
        worst
    }
}
