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

use std::fmt::Debug;

use super::banded::BandedEquations;
use super::convergence::{Convergence, ConvergenceRate};
use super::{Factors, PartedSystem, Residual, State};

/// What Newton's method asks of a system: its linearised equations, solved, and what their solution does.
pub trait Iterated: PartedSystem {
    /// Work arrays: residuals, the tangent, displacements.
    type Work: Clone + Debug + 'static;

    /// The work arrays at a state.
    fn equations(&self, state: &Self::State) -> Self::Work;

    /// Solves the linearised equations at a state. Returns the node that moves most and by how much \[m\].
    ///
    /// # Errors
    /// [`NewtonError::Singular`] and [`NewtonError::NotFinite`].
    fn displace(
        &self,
        work: &mut Self::Work,
        t: f64,
        state: &Self::State,
        c: Factors,
    ) -> Result<(usize, f64), NewtonError>;

    /// Makes a share of the displacements found, velocities and accelerations following the positions by `c`.
    fn apply(&self, work: &Self::Work, state: &mut Self::State, c: Factors, share: f64);

    /// The displacements found in the norm of convergence on force \[m\]: see [`Residual::force_norm_displacement`].
    fn norm_on_force(&self, work: &Self::Work, state: &Self::State) -> f64;

    /// Whether an estimate of convergence is none: the displacements found, which led to this state, passed a kink of a force. `by_bound`:
    /// the estimate is by a bound ([`ConvergenceRate::is_bound`]).
    fn is_misjudged(&self, work: &Self::Work, state: &Self::State, by_bound: bool) -> bool;

    /// The greatest of what the displacements found miss beside those of the nodes \[m\].
    fn missed(&self, _work: &Self::Work, _c: Factors) -> f64 {
        0.0
    }
}

/// Newton's method with its work arrays and the measured rate of convergence. Allocates in [`Newton::new`] and [`Newton::of_equations`],
/// and at the first iteration of a pentadiagonal line.
#[derive(Debug, Clone)]
pub struct Newton<W = BandedEquations> {
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
    /// The equations.
    pub equations: W,
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
    /// For a line of `nodes` nodes; tolerance \[m\].
    #[must_use]
    pub fn new(nodes: usize, tolerance: f64, max_iterations: usize) -> Self {
        Self::of_equations(BandedEquations::new(nodes), tolerance, max_iterations)
    }

    /// The largest residual of a free node \[N\], and its node.
    pub fn largest_residual<S: Residual>(
        &mut self,
        system: &S,
        t: f64,
        state: &State,
    ) -> (usize, f64) {
        let residual = &mut self.equations.residual;
        system.residual(t, state, residual);
        let mut worst = (0, 0.0);
        for i in system.free() {
            let size = residual[i].norm();
            if size.is_nan() || size > worst.1 {
                worst = (i, size);
            }
        }
        worst
    }
}

impl<W> Newton<W> {
    /// For a system with these work arrays; tolerance \[m\].
    #[must_use]
    pub fn of_equations(equations: W, tolerance: f64, max_iterations: usize) -> Self {
        Self {
            tolerance,
            transverse_tolerance: tolerance,
            velocity_tolerance: f64::INFINITY,
            max_iterations,
            max_displacement: f64::INFINITY,
            stagnation_limit: usize::MAX,
            iterations: 0,
            equations,
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
    pub fn solve<S: Iterated<Work = W>>(
        &mut self,
        system: &S,
        t: f64,
        state: &mut S::State,
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
            let by_bound = self.rate.is_some_and(|rate| rate.is_bound);
            let equations = &self.equations;
            let is_reached = reached
                && (moved <= tolerance || !system.is_misjudged(equations, state, by_bound))
                && system.missed(equations, c) <= self.tolerance;
            if is_reached {
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
    fn convergence_norm<S: Iterated<Work = W>>(
        &self,
        system: &S,
        state: &S::State,
        moved: f64,
    ) -> f64 {
        // A force that depends steeply on velocity does so in every direction.
        if self.transverse_tolerance <= self.tolerance || self.velocity_tolerance.is_finite() {
            return moved;
        }
        let along = system.norm_on_force(&self.equations, state);
        along.max(moved * self.tolerance / self.transverse_tolerance)
    }

    /// One iteration; returns the node that moves most and by how much \[m\], before scaling to
    /// [`Newton::max_displacement`].
    ///
    /// # Errors
    /// [`NewtonError::Singular`] and [`NewtonError::NotFinite`].
    pub fn iterate<S: Iterated<Work = W>>(
        &mut self,
        system: &S,
        t: f64,
        state: &mut S::State,
        c: Factors,
    ) -> Result<(usize, f64), NewtonError> {
        self.iterations += 1;
        let worst = system.displace(&mut self.equations, t, state, c)?;
        let share = if worst.1 > self.max_displacement {
            self.max_displacement / worst.1
        } else {
            1.0
        };
        system.apply(&self.equations, state, c, share);
        Ok(worst)
    }
}
